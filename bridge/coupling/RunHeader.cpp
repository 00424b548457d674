#include "bridge/coupling/RunHeader.h"

#include <fmt/format.h>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/output/Version.h"

namespace restenosis {
namespace {

std::string flowText(const Scene& scene, int ranks) {
  if (!noFlowBecause(scene).empty()) return "no flow";
  const std::string flow = fmt::format("flow by {} ({})", scene.flow->backend, scene.scene.fidelity);
  return ranks > 1 ? fmt::format("{} on {} processes", flow, ranks) : flow;
}

}  // namespace

std::string runHeader(const Scene& scene, const RunPlace& place) {
  return fmt::format("restenosisFoam {}\n{}: {}\n{}; threads: {}; results: {}", version(), scene.name,
                     scene.scene.title, flowText(scene, place.ranks), place.threads, place.results.string());
}

}  // namespace restenosis
