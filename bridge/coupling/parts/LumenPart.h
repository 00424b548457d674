#pragma once

#include <memory>
#include <vector>

#include "bridge/coupling/LumenExtraction.h"
#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/output/PlannedPart.h"

namespace restenosis {

/// Takes the lumen's shape from the agents and struts (model 9).
///
/// Once a day, and at the end, it looks whether the lumen is still open, whoever else reads it: when a run
/// ends because its lumen has closed depends on the tissue, not on what is recorded.
class LumenPart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<LumenPart> make(const PartContext& context);
  LumenPart(Quantities& quantities, LumenExtraction& extraction)
      : Part(quantities), extraction_(extraction) {}

  std::string_view name() const override { return "lumen"; }
  bool isPurpose(const Instant& now) const override { return looksForOcclusion(now); }
  Verdict inputsChanged(const Instant& now) const override;
  /// Throws Occluded, once a day, when the lumen has closed.
  void run(const Instant& now) override;

 private:
  static bool looksForOcclusion(const Instant& now) { return now.endsDay || now.last; }

  Read<Quantity::agentPositions> positions_ = read<Quantity::agentPositions>();
  Write<Quantity::lumen> lumen_ = write<Quantity::lumen>();
  Read<Quantity::wallTraction> flow_ = observe<Quantity::wallTraction>();
  LumenExtraction& extraction_;
};

}  // namespace restenosis
