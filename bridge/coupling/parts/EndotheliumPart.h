#pragma once

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/coupling/PlannedPart.h"

namespace restenosis {

/// Lets endothelium return over the exposed cells (model 7).
class EndotheliumPart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<EndotheliumPart> make(const PartContext& context);
  explicit EndotheliumPart(World& world) : world_(world) {}
  std::string_view name() const override { return "endothelium"; }
  std::vector<Quantity> reads() const override { return {Quantity::exposure}; }
  std::vector<Quantity> writes() const override { return {Quantity::coverage}; }
  Verdict inputsChanged(const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  World& world_;
};

}  // namespace restenosis
