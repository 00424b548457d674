#include "bridge/coupling/Plan.h"

#include <fmt/format.h>

#include "bridge/coupling/CostForecast.h"
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
  return text + flowCostText(scene) + tissueCostText(scene);
}

}  // namespace restenosis
