#include "bridge/scene/Diagnostic.h"

#include <fmt/format.h>

#include "tissue/parameters/Printable.h"

namespace restenosis {
namespace {

std::string oneLineEach(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const auto& diagnostic : diagnostics) {
    if (!text.empty()) text += '\n';
    text += toString(diagnostic);
  }
  return text;
}

}  // namespace

std::string toString(const Diagnostic& diagnostic) {
  const std::string file = printable(diagnostic.file), message = printable(diagnostic.message);
  if (diagnostic.line == 0) return fmt::format("{}: {}", file, message);
  return fmt::format("{}:{}: {}", file, diagnostic.line, message);
}

SceneError::SceneError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(oneLineEach(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace restenosis
