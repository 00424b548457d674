#pragma once

#include "Part.h"
#include "World.h"

namespace restenosis {

/// Carries wall shear stress from the faces of the flow to the cells, area-weighted (model 9).
class WallShearPart : public Part {
 public:
  explicit WallShearPart(World& world) : world_(world) {}
  std::string_view name() const override { return "wallShear"; }
  std::vector<Quantity> reads() const override {
    return {Quantity::wallTraction, Quantity::exposure, Quantity::agentPositions};
  }
  std::vector<Quantity> writes() const override { return {Quantity::wallShearStress}; }
  Verdict inputsChanged(const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  World& world_;
};

}  // namespace restenosis
