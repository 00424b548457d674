#include "bridge/coupling/parts/CrossCheckPart.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "bridge/coupling/FlowForecast.h"
#include "bridge/coupling/SceneFlow.h"
#include "bridge/flow/FlowBackendNames.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {
namespace {

constexpr const char* part = "crossCheck";

double secondsOf(const PartTimer& timer, const char* name) {
  const auto cost = timer.costs().find(name);
  return cost == timer.costs().end() ? 0.0 : cost->second.seconds;
}

double flowSeconds(const PartTimer& timer) { return secondsOf(timer, "mesh") + secondsOf(timer, "flow"); }

}  // namespace

std::vector<PlannedPart> CrossCheckPart::explain(const Scene& scene) {
  if (!scene.flow || !scene.flow->isCrossChecked()) return {};
  const FlowParameters& flow = *scene.flow;
  const std::string name = fmt::format("cross-check ({})", flow.crossCheck);
  if (const std::string noFlow = noFlowBecause(scene); !noFlow.empty()) return {{name, false, noFlow}};
  return {{name, true,
           fmt::format("of the first and the last flow, and of as many between as {:g} % of the flow's time "
                       "allows",
                       100 * flow.crossCheckShare)}};
}

std::unique_ptr<CrossCheckPart> CrossCheckPart::make(const PartContext& context) {
  const Scene& scene = context.run.scene;
  if (!scene.flow || !scene.flow->isCrossChecked()) return nullptr;
  FlowBackendOptions options = flowBackendOptions(context);
  options.moveMesh = false;
  std::string_view method = scene.flow->crossCheck;
  if (method == flowBackendNames::reference) {
    method = scene.flow->backend;
    options.fidelity = flowBackendNames::reference;
    options.foam.reset();
    options.lbm.reset();
  }
  return std::make_unique<CrossCheckPart>(context, flowBackendFor(scene, method, options));
}

CrossCheckPart::CrossCheckPart(const PartContext& context, std::unique_ptr<FlowBackend> backend)
    : Part(context.run.quantities),
      run_(context.run),
      state_(context.run.crossCheck),
      backend_(std::move(backend)),
      stopRequested_(context.stopRequested) {
  if (run_.stent) struts_ = run_.stent->middles();
}

bool CrossCheckPart::appliesAt(const Instant& now) const {
  return flow_->solves != state_.solvesSeen || (now.last && state_.pending);
}

void CrossCheckPart::run(const Instant& now) {
  if (flow_->solves != state_.solvesSeen) {
    state_.pending = run_.extraction.surface();
    state_.solvesSeen = flow_->solves;
  }
  if (flow_->solves > 1 && !now.last && !affordable()) return;
  if (check(*state_.pending)) state_.pending.reset();
}

bool CrossCheckPart::affordable() const {
  const double spent = secondsOf(run_.timer, part);
  const auto done = static_cast<double>(state_.checks.size() + state_.failed);
  const double each = done > 0 ? spent / done : 0;
  return spent + 2 * each <= run_.scene.flow->crossCheckShare * flowSeconds(run_.timer);
}

bool CrossCheckPart::check(const TriSurface& lumen) {
  auto measurement = run_.timer.measure(part);
  const std::filesystem::path folder = run_.folder.crossCheckCase(flow_->time);
  const FlowParameters& flow = *run_.scene.flow;
  if (!state_.checks.empty()) backend_->startFrom(run_.folder.crossCheckCase(state_.checks.back().time));
  try {
    const FlowSolution other =
        backend_->solve(lumen, flow.conditions(run_.scene.vessel.lumenDiameter), folder);
    CrossCheckRecord record = stressDifferences(lumen, struts_, *flow_->last, other);
    record.time = flow_->time;
    if (run_.biology.hasEndothelium())
      record.decidedOtherwise = decidedOtherwise(wall_->agents, run_.biology, *flow_->last, other);
    state_.checks.push_back(record);
    sayIfLarge(record);
  } catch (const FlowFailed& failure) {
    if (stopRequested_ && *stopRequested_) return false;
    ++state_.failed;
    remark(fmt::format("failed: {}{}", failure.what(),
                       failure.log.empty() ? "" : fmt::format(" (see {})", failure.log.string())));
  }
  if (!run_.scene.output.keepsAllFlowCases()) run_.folder.removeCrossChecksBut(folder);
  return true;
}

void CrossCheckPart::sayIfLarge(const CrossCheckRecord& record) {
  const FlowParameters& flow = *run_.scene.flow;
  std::string text;
  const auto look = [&](const char* where, const std::optional<StressDifference>& difference) {
    if (!difference || std::abs(difference->mean) <= flow.crossCheckLimit) return;
    text += fmt::format("{}{:+.1f} % {}", text.empty() ? "" : ", ", 100 * difference->mean, where);
  };
  look("on smooth wall", record.smoothWall);
  look("near struts", record.nearStruts);
  look("on struts", record.struts);
  if (text.empty()) return;
  text = fmt::format("the mean stress by {} differs by {} (flow.crossCheckLimit: {:g} %)", flow.crossCheck,
                     text, 100 * flow.crossCheckLimit);
  remark(text);
}

void CrossCheckPart::remark(const std::string& text) {
  const std::string prefix = fmt::format("cross-check at day {:.3f}: ", flow_->time / secondsPerDay);
  state_.remarked.add(run_.remarks, prefix, text);
  run_.progress.message(prefix + text);
}

CrossCheckSummary crossCheckSummary(const RunState& run) {
  CrossCheckSummary summary{.method = run.scene.flow->crossCheck,
                            .checks = run.crossCheck.checks,
                            .failed = run.crossCheck.failed,
                            .seconds = secondsOf(run.timer, part)};
  if (const double flow = flowSeconds(run.timer); flow > 0) summary.shareOfFlow = summary.seconds / flow;
  return summary;
}

}  // namespace restenosis
