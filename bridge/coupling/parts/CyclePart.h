#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/output/PlannedPart.h"

namespace restenosis {

/// Takes the cells through one step of their cycle: growth, rest, division (model 5).
class CyclePart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<CyclePart> make(const PartContext& context);
  /// `step`: the biological step [s]; `divisions` are added to.
  CyclePart(Quantities& quantities, Biology& biology, double step, std::uint64_t& divisions,
            PartTimer& timer);

  std::string_view name() const override { return "cycle"; }
  bool isPurpose(const Instant&) const override { return true; }
  bool appliesAt(const Instant& now) const override { return !now.last; }
  /// Wall shear stress is needed where it can turn a rule's answer (ArrestRules).
  Verdict needs(Quantity quantity, const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  Read<Quantity::exposure> exposure_ = read<Quantity::exposure>();
  Read<Quantity::nitricOxide> nitricOxide_ = read<Quantity::nitricOxide>();
  Write<Quantity::cellStates> cells_ = write<Quantity::cellStates>();
  Biology& biology_;
  double step_;
  std::uint64_t& divisions_;
  PartTimer& timer_;
};

}  // namespace restenosis
