#pragma once

#include <memory>
#include <vector>

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/output/PlannedPart.h"

namespace restenosis {

/// Lets endothelium return over the exposed cells (model 7).
class EndotheliumPart : public Part {
 public:
  static std::vector<PlannedPart> explain(const Scene& scene);
  static std::unique_ptr<EndotheliumPart> make(const PartContext& context);
  EndotheliumPart(Quantities& quantities, const Biology& biology, PartTimer& timer)
      : Part(quantities), biology_(biology), timer_(timer) {}

  std::string_view name() const override { return "endothelium"; }
  Verdict inputsChanged(const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  Read<Quantity::exposure> exposure_ = read<Quantity::exposure>();
  Write<Quantity::coverage> coverage_ = write<Quantity::coverage>();
  const Biology& biology_;
  PartTimer& timer_;
};

}  // namespace restenosis
