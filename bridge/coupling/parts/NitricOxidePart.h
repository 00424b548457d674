#pragma once

#include <memory>
#include <vector>

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/output/PlannedPart.h"

namespace restenosis {

/// Turns the wall shear stress of covered cells into nitric oxide (model 7).
class NitricOxidePart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<NitricOxidePart> make(const PartContext& context);
  NitricOxidePart(Quantities& quantities, const Biology& biology, PartTimer& timer)
      : Part(quantities), biology_(biology), timer_(timer) {}

  std::string_view name() const override { return "nitricOxide"; }
  /// Wall shear stress is needed where it can turn a rule's answer (ArrestRules).
  Verdict needs(Quantity quantity, const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  Read<Quantity::wallShearStress> stress_ = read<Quantity::wallShearStress>();
  Read<Quantity::coverage> coverage_ = read<Quantity::coverage>();
  Write<Quantity::nitricOxide> nitricOxide_ = write<Quantity::nitricOxide>();
  const Biology& biology_;
  PartTimer& timer_;
};

}  // namespace restenosis
