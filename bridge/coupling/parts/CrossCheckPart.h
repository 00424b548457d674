#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bridge/coupling/CrossCheck.h"
#include "bridge/coupling/LumenExtraction.h"
#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/output/PlannedPart.h"

namespace restenosis {

/// Solves the flow in some of the lumens by another method too, and records how the stress differs: the first
/// lumen and the last, and between them as many as `crossCheckShare` of the flow's time allows. The state of
/// the tissue does not depend on it.
class CrossCheckPart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<CrossCheckPart> make(const PartContext& context);
  CrossCheckPart(const PartContext& context, std::unique_ptr<FlowBackend> backend);

  std::string_view name() const override { return "crossCheck"; }
  bool isPurpose(const Instant&) const override { return true; }
  bool appliesAt(const Instant& now) const override;
  /// A check that fails is remarked on.
  void run(const Instant& now) override;

 private:
  /// Whether a check now and one at the end fit into the share of the time.
  bool affordable() const;
  /// False where it was asked to stop.
  bool check(const TriSurface& lumen);
  void sayIfLarge(const CrossCheckRecord& record);
  void remark(const std::string& text);

  Read<Quantity::wallTraction> flow_ = observe<Quantity::wallTraction>();
  Read<Quantity::agentPositions> wall_ = observe<Quantity::agentPositions>();
  RunState& run_;
  CrossCheckState& state_;
  std::vector<Vec3> struts_;  ///< Stent::middles
  std::unique_ptr<FlowBackend> backend_;
  const std::atomic<bool>* stopRequested_;
};

/// Seconds of cross-checks, and their share of those of meshes and flows.
CrossCheckSummary crossCheckSummary(const RunState& run);

}  // namespace restenosis
