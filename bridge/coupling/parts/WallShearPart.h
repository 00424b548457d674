#pragma once

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/coupling/PlannedPart.h"

namespace restenosis {

/// Carries wall shear stress from the faces of the flow to the cells, area-weighted (model 9), and, where the
/// lumen has moved since the flow was solved, brings it up to date to first order (ShearResponse).
class WallShearPart : public Part {
 public:
  /// Nothing: it goes with the flow.
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<WallShearPart> make(const PartContext& context);
  explicit WallShearPart(World& world) : world_(world) {}
  std::string_view name() const override { return "wallShear"; }
  std::vector<Quantity> reads() const override {
    return {Quantity::wallTraction, Quantity::exposure, Quantity::agentPositions, Quantity::lumen};
  }
  std::vector<Quantity> writes() const override { return {Quantity::wallShearStress}; }
  Verdict inputsChanged(const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  void followLumen();

  World& world_;
};

}  // namespace restenosis
