#pragma once

#include <memory>
#include <vector>

#include "bridge/coupling/LumenExtraction.h"
#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/output/PlannedPart.h"
#include "tissue/equilibrium/Relaxation.h"
#include "tissue/vessel/EndPlanes.h"
#include "tissue/vessel/OuterConfinement.h"

namespace restenosis {

/// Brings the wall back to mechanical equilibrium after cells have grown or divided (model 3). The EEL does
/// not yield.
class RelaxPart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<RelaxPart> make(const PartContext& context);
  /// The scene has [mechanics]. `work` is added to; `extraction` gives its memory back before agents move.
  RelaxPart(Quantities& quantities, const Scene& scene, const OuterConfinement& confinement,
            LumenExtraction& extraction, RelaxationWork& work, PartTimer& timer);

  std::string_view name() const override { return "relax"; }
  Verdict inputsChanged(const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  void relax(Wall& wall);

  Read<Quantity::cellStates> cells_ = read<Quantity::cellStates>();
  Write<Quantity::agentPositions> positions_ = write<Quantity::agentPositions>();
  const Scene& scene_;
  const OuterConfinement& confinement_;
  LumenExtraction& extraction_;
  RelaxationWork& work_;
  PartTimer& timer_;
  Relaxation relaxation_;
  EndPlanes ends_;
};

}  // namespace restenosis
