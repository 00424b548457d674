#pragma once

#include <memory>

#include "tissue/biology/ArrestRule.h"
#include "tissue/biology/BiologySettings.h"

namespace restenosis {

/// A contractile cell rests: only synthetic ones proliferate (model 4).
class ContractileArrest : public ArrestRule {
 public:
  static std::unique_ptr<const ArrestRule> make(const BiologySettings&) {
    return std::make_unique<ContractileArrest>();
  }
  bool arrests(const AgentStore& agents, Index cell) const override { return !agents.has(cell, synthetic); }
};

}  // namespace restenosis
