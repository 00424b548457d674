#include "bridge/flow/foam/FoamOutlets.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "bridge/surface/StlFile.h"

namespace restenosis {
namespace {

constexpr std::string_view patchReport = R"(    {0}{1}
    {{
        type            surfaceFieldValue;
        libs            (fieldFunctionObjects);
        writeControl    onEnd;
        executeControl  onEnd;
        writeFields     false;
        log             false;
        regionType      patch;
        name            {0};
        operation       {2};
        fields          ({3});
    }}
)";

/// Puts lines into an entry that is empty.
void fill(std::string& text, std::string_view entry, const std::string& lines) {
  const std::string empty = fmt::format("\n{} {{}}", entry);
  const auto at = text.find(empty);
  if (at == std::string::npos)
    throw std::invalid_argument(
        fmt::format("system/outlets of the case template has no empty entry '{}'", entry));
  text.replace(at, empty.size(), fmt::format("\n{}\n{{\n{}}}", entry, lines));
}

}  // namespace

std::string outletsText(std::string text, const FlowConditions& conditions) {
  if (conditions.outlets.size() < 2) return text;
  std::string names, surfaces, velocities, functions;
  for (std::size_t n = 1; n < conditions.outlets.size(); ++n) {
    const std::string_view name = regionName(outletRegion(n));
    names += fmt::format("    {0} {{ name {0}; }}\n", name);
    surfaces +=
        fmt::format("    {} {{ level ($coreLevel $coreLevel); patchInfo {{ type patch; }} }}\n", name);
    velocities += fmt::format(
        "    {}\n    {{\n        type        flowRateOutletVelocity;\n        volumetricFlowRate constant "
        "{};\n"
        "        value       uniform (0 0 0);\n    }}\n",
        name, conditions.outlets[n].share * conditions.flowRate);
    functions += fmt::format(patchReport, name, "Flow", "sum", "phi");
    functions += fmt::format(patchReport, name, "Pressure", "areaAverage", "p");
  }
  fill(text, "outletNames", names);
  fill(text, "outletSurfaces", surfaces);
  fill(text, "outletVelocities", velocities);
  fill(text, "outletFunctions", functions);
  return text;
}

}  // namespace restenosis
