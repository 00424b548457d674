#pragma once

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/coupling/PlannedPart.h"

namespace restenosis {

/// Finds which cells face the lumen and which are crowded (model 6).
class ExposurePart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<ExposurePart> make(const PartContext& context);
  explicit ExposurePart(World& world) : world_(world) {}
  std::string_view name() const override { return "exposure"; }
  std::vector<Quantity> reads() const override { return {Quantity::agentPositions}; }
  std::vector<Quantity> writes() const override { return {Quantity::exposure}; }
  Verdict inputsChanged(const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  World& world_;
};

}  // namespace restenosis
