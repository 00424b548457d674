#include "bridge/output/SummaryJson.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bridge/output/Version.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {

namespace {

using Json = nlohmann::ordered_json;

Json finalValues(const TimeSeriesRow& row) {
  auto values = Json::object();
  row.forEachColumn([&values](const char* column, const auto& value, double scale) {
    if constexpr (requires { value.has_value(); }) {
      values[column] = value ? Json(*value * scale) : Json(nullptr);
    } else if constexpr (std::is_integral_v<std::decay_t<decltype(value)>>) {
      values[column] = value;
    } else {
      values[column] = value * scale;
    }
  });
  return values;
}

Json orNull(const std::optional<double>& value, double scale = 1) {
  return value ? Json(scale * *value) : Json();
}

Json packing(const Summary& summary) {
  if (!summary.packing) return nullptr;
  const PackingReport& done = *summary.packing;
  return {{"ielAgents", done.counts.iel},
          {"eelAgents", done.counts.eel},
          {"cells", done.counts.smc},
          {"bonds", done.bonds},
          {"largestResidual", done.released.residual},
          {"ielMeanRadialMoveOnRelease_um", 1e6 * done.ielDrift},
          {"rmsMoveOnRelease_um", 1e6 * done.rmsMove},
          {"cellsOutsideLaminae", done.expelled}};
}

Json deployment(const Summary& summary) {
  if (!summary.deployment) return nullptr;
  const DeploymentStatistics& wall = *summary.deployment;
  return {{"freeAgentsInTheWayOfStruts", wall.freeInPath},
          {"agentsLumenwardOfStruts", wall.escaped},
          {"freeAgentsLumenwardOfStruts", wall.escapedFree},
          {"freeAgentsPassedByStruts", wall.passedFree},
          {"cellsOutsideEel", wall.outside},
          {"ielRadiusUnderStruts_um", orNull(wall.ielUnderStrut, 1e6)},
          {"ielToEelUnderStruts_um", orNull(wall.laminaDistance, 1e6)},
          {"largestOverlap_cellRadii", wall.largestOverlap},
          {"meanBondStrain", orNull(wall.meanStrain)},
          {"largestBondStrain", wall.largestStrain},
          {"meanIelBondStrain", orNull(wall.meanIelStrain)},
          {"largestIelBondStrain", wall.largestIelStrain}};
}

Json injury(const Summary& summary) {
  if (!summary.injury) return nullptr;
  const InjuryReport& done = *summary.injury;
  return {{"ielAgents", done.iel},
          {"stretchedIelAgents", done.stretched},
          {"brokenIelAgents", done.broken},
          {"fenestratedIelAgents", done.fenestrated},
          {"removedIelAgents", done.removed},
          {"ielBonds", done.ielBonds},
          {"brokenIelBonds", done.brokenBonds},
          {"syntheticCells", done.synthetic},
          {"syntheticCellsByStretch", done.syntheticByStretch}};
}

Json beats(const Summary& summary) {
  if (!summary.beats) return nullptr;
  const BeatSummary& beats = *summary.beats;
  return {{"beats", beats.beats},
          {"period_s", beats.period},
          {"meanTawss_Pa", beats.meanStress},
          {"changeInLastBeat", beats.change},
          {"steadyMeanDifference", beats.steadyMean},
          {"steadyRelativeL2", beats.steadyDifference},
          {"seconds", beats.seconds}};
}

Json outlets(const Summary& summary) {
  double all = 0;
  for (const auto& [name, flow] : summary.outlets) all += flow.flowRate;
  Json list = Json::array();
  for (const auto& [name, flow] : summary.outlets)
    list.push_back({{"solid", name},
                    {"flowRate_m3_s", flow.flowRate},
                    {"share", flow.flowRate / all},
                    {"pressure_Pa", flow.pressure}});
  return list;
}

Json flowSolves(const Summary& summary) {
  Json flow;
  flow["backend"] = summary.flowBackend.empty() ? Json(nullptr) : Json(summary.flowBackend);
  std::uint64_t skipped = 0;
  for (const auto& [reason, count] : summary.flowSolvesSkipped) skipped += count;
  flow["solvesDone"] = summary.flowSolvesDone;
  flow["solvesSkipped"] = skipped;
  flow["skippedBecause"] = Json(summary.flowSolvesSkipped);
  flow["meshesMoved"] = summary.flowMeshesMoved;
  flow["remeshedBecause"] = Json(summary.flowRemeshed);
  flow["beats"] = beats(summary);
  flow["outlets"] = outlets(summary);
  return flow;
}

/// Least and largest of a value that not every check has; null where none has it.
template <class Value>
Json range(const CrossCheckSummary& all, Value&& value) {
  std::optional<double> least, largest;
  for (const CrossCheckRecord& check : all.checks) {
    const std::optional<double> v = value(check);
    if (!v) continue;
    least = std::min(least.value_or(*v), *v), largest = std::max(largest.value_or(*v), *v);
  }
  return least ? Json{*least, *largest} : Json();
}

Json crossCheck(const Summary& summary) {
  if (!summary.crossCheck) return nullptr;
  const CrossCheckSummary& all = *summary.crossCheck;
  Json json = {{"method", all.method},
               {"checks", all.checks.size()},
               {"failed", all.failed},
               {"seconds", all.seconds},
               {"shareOfFlowTime", all.shareOfFlow}};
  const auto part = [&](const char* name, std::optional<StressDifference> CrossCheckRecord::*place) {
    using Value = std::optional<double>;
    json[name] = {{"meanDifference",
                   range(all, [&](const auto& c) { return c.*place ? Value((c.*place)->mean) : Value(); })},
                  {"relativeL2",
                   range(all, [&](const auto& c) { return c.*place ? Value((c.*place)->l2) : Value(); })}};
  };
  part("smoothWall", &CrossCheckRecord::smoothWall);
  part("nearStruts", &CrossCheckRecord::nearStruts);
  part("struts", &CrossCheckRecord::struts);
  json["decidedOtherwise"] = range(all, [](const auto& c) { return c.decidedOtherwise; });
  return json;
}

Json poiseuille(const Summary& summary) {
  if (!summary.poiseuille) return nullptr;
  const PoiseuilleError& error = *summary.poiseuille;
  return {{"exactWss_Pa", error.exact},
          {"meanError", error.mean},
          {"l2Error", error.l2},
          {"largestError", error.largest},
          {"endsLeftOut_mm", 1e3 * error.endMargin}};
}

Json plan(const Summary& summary) {
  auto parts = Json::array();
  for (const PlannedPart& part : summary.plan)
    parts.push_back({{"part", part.name}, {"runs", part.runs}, {"explanation", part.explanation}});
  return parts;
}

Json differences(const Summary& summary) {
  auto keys = Json::array();
  for (const DefaultDifference& one : summary.differences)
    keys.push_back({{"key", one.key},
                    {"value", one.value},
                    {"default", one.byDefault.empty() ? Json() : Json(one.byDefault)},
                    {"meaning", one.meaning}});
  return keys;
}

Json provenance(const Summary& summary) {
  const Provenance& made = summary.provenance;
  return {{"command", made.command},
          {"workingFolder", made.workingFolder},
          {"host", made.host},
          {"started", made.started},
          {"ended", timeNow()}};
}

Json partCosts(const Summary& summary) {
  auto parts = Json::object();
  for (const auto& [name, cost] : summary.parts) {
    auto& part = parts[name];
    part["seconds"] = cost.seconds;
    part["peakMemory_MiB"] = static_cast<double>(cost.peakMemory) / 0x1p20;
    if (cost.peakChildMemory > 0)
      part["peakChildProcessMemory_MiB"] = static_cast<double>(cost.peakChildMemory) / 0x1p20;
    part["calls"] = cost.calls;
  }
  return parts;
}

}  // namespace

void writeSummaryJson(const std::filesystem::path& file, const Summary& summary) {
  Json json;
  json["scene"] = summary.scene;
  json["title"] = summary.title;
  json["status"] = summary.status;
  json["version"] = version();
  json["seed"] = summary.seed;
  json["threads"] = summary.threads;
  json["ranks"] = summary.ranks;
  json["agents"] = summary.last.agents;
  json["sceneFingerprint"] = summary.sceneFingerprint;
  json["stateDigest"] = summary.stateDigest;
  json["final"] = finalValues(summary.last);
  json["packing"] = packing(summary);
  json["deployment"] = deployment(summary);
  json["injury"] = injury(summary);
  json["flow"] = flowSolves(summary);
  json["crossCheck"] = crossCheck(summary);
  json["relaxation"] = {{"iterations", summary.relaxationIterations},
                        {"agentEvaluations", summary.agentEvaluations},
                        {"largestResidual", summary.relaxationResidual}};
  json["poiseuille"] = poiseuille(summary);
  json["parts"] = partCosts(summary);
  double total = 0;
  for (const auto& [name, cost] : summary.parts) total += cost.seconds;
  json["totalSeconds"] = total;
  json["remarks"] = summary.remarks;
  json["plan"] = plan(summary);
  json["differsFromDefaults"] = differences(summary);
  json["provenance"] = provenance(summary);
  // Titles and messages may hold bytes that are not UTF-8; they must not cost a finished run its summary.
  atomicWrite(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace restenosis
