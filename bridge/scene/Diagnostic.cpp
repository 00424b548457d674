#include "Diagnostic.h"

#include <fmt/format.h>

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
  if (diagnostic.line == 0) return fmt::format("{}: {}", diagnostic.file, diagnostic.message);
  return fmt::format("{}:{}: {}", diagnostic.file, diagnostic.line, diagnostic.message);
}

SceneError::SceneError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(oneLineEach(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace restenosis
