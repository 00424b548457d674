#pragma once

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/coupling/PlannedPart.h"

namespace restenosis {

/// Takes the lumen's shape from the agents and struts (model 9).
///
/// Once a day, and at the end, it looks whether the lumen is still open, whoever else reads it: when a run
/// ends because its lumen has closed depends on the tissue, not on what is recorded.
class LumenPart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<LumenPart> make(const PartContext& context);
  explicit LumenPart(World& world) : world_(world) {}
  std::string_view name() const override { return "lumen"; }
  std::vector<Quantity> reads() const override { return {Quantity::agentPositions}; }
  std::vector<Quantity> writes() const override { return {Quantity::lumen}; }
  bool isPurpose(const Instant& now) const override { return looksForOcclusion(now); }
  Verdict inputsChanged(const Instant& now) const override;
  /// Throws Occluded, once a day, when the lumen has closed.
  void run(const Instant& now) override;

 private:
  static bool looksForOcclusion(const Instant& now) { return now.endsDay || now.last; }

  World& world_;
};

}  // namespace restenosis
