#include <stdexcept>
#include <string>
#include <vector>

#include "bridge/scene/SceneReader.h"
#include "bridge/scene/SceneWriter.h"
#include "bridge/scene/SweptSetting.h"
#include "bridge/scene/Units.h"
#include "tests/fuzz/FuzzTargets.h"
#include "tissue/parameters/Printable.h"

namespace restenosis {
namespace {

/// Separates a scene from the overrides that follow it, one a line, as behind `--set`.
constexpr std::string_view overridesBegin = "\n--set\n";

void require(bool fulfilled, const char* what) {
  if (!fulfilled) throw std::logic_error(what);
}

}  // namespace

void fuzzScene(std::string_view input) {
  static const Units units;
  const SceneReader reader(units);
  const auto end = input.find(overridesBegin);
  const std::string_view toml = input.substr(0, end);
  std::vector<SceneOverride> overrides;
  if (end != std::string_view::npos) {
    std::string_view rest = input.substr(end + overridesBegin.size());
    while (!rest.empty()) {
      const std::string_view line = rest.substr(0, rest.find('\n'));
      overrides.emplace_back(std::string(line));
      rest.remove_prefix(std::min(rest.size(), line.size() + 1));
      try {
        readSweptSetting(line);
      } catch (const std::invalid_argument&) {
        // Refused, as it says
      }
    }
  }
  try {
    const Scene scene = reader.readText(toml, "fuzzed.toml", overrides);
    // What was accepted is written such that it is accepted again, and is the same. That takes ten times as
    // long as the reading, so it is for some.
    if (input.size() % 8 != 0) return;
    const std::string written = writeScene(scene, units);
    require(writeScene(reader.readText(written, "fuzzed.toml"), units) == written,
            "a scene is another one when it is written and read again");
  } catch (const SceneError& error) {
    require(!error.diagnostics().empty(), "a scene is refused without a reason");
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      const std::string text = toString(diagnostic);
      require(!diagnostic.message.empty() && printable(text) == text, "a message is no printable line");
    }
  }
}

}  // namespace restenosis
