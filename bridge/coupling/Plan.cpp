#include "bridge/coupling/Plan.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "bridge/coupling/CostForecast.h"
#include "bridge/coupling/FidelityError.h"
#include "bridge/coupling/GrowthStep.h"
#include "bridge/coupling/Instant.h"
#include "bridge/coupling/WallPreparation.h"
#include "bridge/surface/SceneStent.h"
#include "tissue/parameters/Printable.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

std::vector<PlannedPart> plannedParts(const Scene& scene) {
  std::vector<PlannedPart> plan = WallPreparation::explain(scene);
  for (const PartEntry& entry : growthStep())
    for (PlannedPart& part : entry.explain(scene)) plan.push_back(std::move(part));
  return plan;
}

std::string surfacesText(const Scene& scene) {
  std::string text;
  if (!scene.lumenParts.empty()) text += fmt::format("lumen of {}:\n", scene.vessel.lumenSurface);
  for (const std::string& part : scene.lumenParts) text += fmt::format("  {}\n", part);
  if (!scene.stent) return text;
  if (const std::string struts = describeStentFile(*scene.stent); !struts.empty())
    text += fmt::format("stent of {}:\n  {:<7} {}\n", scene.stent->file, "strut", struts);
  return text;
}

std::string planText(const Scene& scene) {
  const std::uint32_t steps = stepCount(scene.scene);
  std::string text = fmt::format("{}: {}\n", printable(scene.file.string()), printable(scene.scene.title));
  text +=
      fmt::format("vessel {:g} mm long, lumen {:g} mm; {:g} days in {} steps of {:g} h; fidelity {}\n",
                  scene.vessel.length * 1e3, scene.vessel.lumenDiameter * 1e3,
                  scene.scene.duration / secondsPerDay, steps, scene.scene.step / 3600, scene.scene.fidelity);
  text += surfacesText(scene);
  for (const std::string& remark : scene.remarks) text += remark + "\n";
  for (const PlannedPart& part : plannedParts(scene))
    text +=
        fmt::format("  {:<5}{:<20} {}\n", part.runs ? "runs" : "-", part.name, printable(part.explanation));
  return text + costText(scene) + fidelityErrorText(scene);
}

std::string planJson(const Scene& scene) {
  nlohmann::ordered_json plan;
  plan["scene"] = scene.file.string();
  plan["title"] = scene.scene.title;
  plan["vessel"] = {{"length_mm", scene.vessel.length * 1e3},
                    {"lumenDiameter_mm", scene.vessel.lumenDiameter * 1e3}};
  plan["days"] = scene.scene.duration / secondsPerDay;
  plan["steps"] = stepCount(scene.scene);
  plan["fidelity"] = scene.scene.fidelity;
  plan["surfaces"] = scene.lumenParts;
  plan["remarks"] = scene.remarks;
  plan["parts"] = nlohmann::ordered_json::array();
  for (const PlannedPart& part : plannedParts(scene))
    plan["parts"].push_back({{"name", part.name}, {"runs", part.runs}, {"explanation", part.explanation}});
  plan["tissue"] = nullptr;
  if (const auto tissue = tissueCost(scene)) {
    plan["tissue"] = {{"agents", std::llround(tissue->agents)},
                      {"strutAgents", std::llround(tissue->struts)},
                      {"memory_MB", tissue->bytes / 1e6},
                      {"seconds", tissue->seconds}};
  }
  plan["flow"] = nullptr;
  if (const auto flow = flowCost(scene)) {
    plan["flow"] = {{"backend", scene.flow->backend},
                    {"pieces", std::llround(flow->pieces)},
                    {"kind", flow->kind},
                    {"memory_MB", flow->bytes / 1e6},
                    {"secondsASolve", flow->secondsASolve},
                    {"likelySolves", {flow->fewSolves, flow->manySolves}}};
  }
  plan["error"] = nullptr;
  if (const auto error = fidelityError(scene))
    plan["error"] = {{"neointimaArea", error->area}, {"seeds", error->seeds}};
  // Names of files may be no UTF-8
  return plan.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace restenosis
