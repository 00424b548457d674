#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace restenosis {

/// The whole loop on the smallest vessel that still grows a neointima around a ring: about 1,700 agents, two
/// seconds of one core. Cells are large for the vessel, and the endothelium is back within the run, so that
/// the flow is solved several times.
inline constexpr std::string_view tinyScene = R"([scene]
title = "Tiny"
duration = "4 d"
step = "2 h"
seed = 1
fidelity = "draft"

[vessel]
length = "0.24 mm"
lumenDiameter = "0.4 mm"
wallThickness = "0.12 mm"
cellRadius = "18 um"

[stent]
design = "ring"
strutWidth = "0.06 mm"
strutThickness = "0.06 mm"
deploymentDepth = "40 um"
deploymentSteps = 8

[injury]
synthetic = "all"
removeIel = true

[mechanics]

[cellCycle]

[contactInhibition]

[endothelium]
scenario = "3-23 days"

[flow]
backend = "analytic"

[coupling]
lumenTolerance = "5 um"
lumenInterval = "0 h"

[output]
interval = "0.5 d"
checkpointInterval = "6 h"
pictures = false
)";

/// The text with its first `from` replaced. Throws where there is none: a test must not pass by a slip.
inline std::string with(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  const auto at = result.find(from);
  if (at == std::string::npos) throw std::invalid_argument("no such text: " + std::string(from));
  return result.replace(at, from.size(), to);
}

/// The tiny scene with OpenFOAM, and the only fidelity whose cells are small enough for so narrow a lumen.
inline std::string tinyFoamScene() {
  return with(with(tinyScene, "\"analytic\"", "\"foam\""), "\"draft\"", "\"reference\"");
}

/// The tiny scene with all that growth beneath the endothelium may be modelled with.
inline std::string growingScene() {
  const std::string growing =
      with(with(tinyScene, "[contactInhibition]",
                "[activation]\nentryRate = \"4 1/d\"\n\n[extracellularMatrix]\nrate = \"0.1 1/d\"\n\n"
                "[contactInhibition]\nlaw = \"stress\""),
           "scenario = \"3-23 days\"",
           "scenario = \"fast\"\nmaturationTime = \"1 d\"\nnitricOxideReach = \"40 um\"");
  return with(growing, "synthetic = \"all\"", "synthetic = \"nearInjury\"");
}

}  // namespace restenosis
