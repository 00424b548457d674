#pragma once

#include <memory>

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/coupling/PlannedPart.h"
#include "tissue/equilibrium/Relaxation.h"
#include "tissue/vessel/EndPlanes.h"

namespace restenosis {

/// Brings the wall back to mechanical equilibrium after cells have grown or divided (model 3). The EEL does
/// not yield.
class RelaxPart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<RelaxPart> make(const PartContext& context);
  explicit RelaxPart(World& world);
  std::string_view name() const override { return "relax"; }
  std::vector<Quantity> reads() const override { return {Quantity::cellStates}; }
  std::vector<Quantity> writes() const override { return {Quantity::agentPositions}; }
  Verdict inputsChanged(const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  World& world_;
  Relaxation relaxation_;
  EndPlanes ends_;
};

}  // namespace restenosis
