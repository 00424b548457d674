#pragma once

#include <memory>
#include <vector>

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/output/PlannedPart.h"

namespace restenosis {

/// Finds which cells face the lumen and which are crowded (model 6).
class ExposurePart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<ExposurePart> make(const PartContext& context);
  ExposurePart(Quantities& quantities, Biology& biology, PartTimer& timer)
      : Part(quantities), biology_(biology), timer_(timer) {}

  std::string_view name() const override { return "exposure"; }
  Verdict inputsChanged(const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  Read<Quantity::agentPositions> positions_ = read<Quantity::agentPositions>();
  Write<Quantity::exposure> exposure_ = write<Quantity::exposure>();
  Biology& biology_;
  PartTimer& timer_;
};

}  // namespace restenosis
