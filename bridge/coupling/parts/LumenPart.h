#pragma once

#include "Part.h"
#include "World.h"

namespace restenosis {

/// Takes the lumen's shape from the agents and struts (model 9).
class LumenPart : public Part {
 public:
  explicit LumenPart(World& world) : world_(world) {}
  std::string_view name() const override { return "lumen"; }
  std::vector<Quantity> reads() const override { return {Quantity::agentPositions}; }
  std::vector<Quantity> writes() const override { return {Quantity::lumen}; }
  Verdict inputsChanged(const Instant& now) const override;
  void run(const Instant& now) override;

 private:
  World& world_;
};

}  // namespace restenosis
