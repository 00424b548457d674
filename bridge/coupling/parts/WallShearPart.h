#pragma once

#include <memory>
#include <vector>

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/output/PlannedPart.h"

namespace restenosis {

/// Carries wall shear stress from the faces of the flow to the cells, area-weighted (model 9), and, where the
/// lumen has moved since the flow was solved, brings it up to date to first order (ShearResponse).
class WallShearPart : public Part {
 public:
  /// Nothing: it goes with the flow.
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<WallShearPart> make(const PartContext& context);
  /// The scene has [flow].
  WallShearPart(Quantities& quantities, const Scene& scene, PartTimer& timer)
      : Part(quantities), scene_(scene), timer_(timer) {}

  std::string_view name() const override { return "wallShear"; }
  Verdict inputsChanged(const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  void followLumen(AgentStore& agents) const;

  Read<Quantity::wallTraction> flow_ = read<Quantity::wallTraction>();
  Read<Quantity::exposure> exposure_ = read<Quantity::exposure>();
  Read<Quantity::agentPositions> positions_ = read<Quantity::agentPositions>();
  Read<Quantity::lumen> lumen_ = read<Quantity::lumen>();
  Write<Quantity::wallShearStress> stress_ = write<Quantity::wallShearStress>();
  const Scene& scene_;
  PartTimer& timer_;
};

}  // namespace restenosis
