#pragma once

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/coupling/PlannedPart.h"

namespace restenosis {

/// Turns the wall shear stress of covered cells into nitric oxide (model 7).
class NitricOxidePart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<NitricOxidePart> make(const PartContext& context);
  explicit NitricOxidePart(World& world) : world_(world) {}
  std::string_view name() const override { return "nitricOxide"; }
  std::vector<Quantity> reads() const override { return {Quantity::wallShearStress, Quantity::coverage}; }
  std::vector<Quantity> writes() const override { return {Quantity::nitricOxide}; }
  /// Wall shear stress is needed where it can turn a rule's answer (ArrestRules).
  Verdict needs(Quantity quantity, const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  World& world_;
};

}  // namespace restenosis
