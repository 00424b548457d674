#pragma once

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/coupling/PlannedPart.h"

namespace restenosis {

/// Takes the cells through one step of their cycle: growth, rest, division (model 5).
class CyclePart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<CyclePart> make(const PartContext& context);
  explicit CyclePart(World& world) : world_(world) {}
  std::string_view name() const override { return "cycle"; }
  std::vector<Quantity> reads() const override;
  std::vector<Quantity> writes() const override { return {Quantity::cellStates}; }
  bool isPurpose(const Instant&) const override { return true; }
  bool appliesAt(const Instant& now) const override { return !now.last; }
  /// Wall shear stress is needed where it can turn a rule's answer (ArrestRules).
  Verdict needs(Quantity quantity, const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  World& world_;
};

}  // namespace restenosis
