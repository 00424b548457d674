#pragma once

#include <memory>

#include "tissue/biology/ArrestRule.h"
#include "tissue/biology/BiologySettings.h"

namespace restenosis {

/// A cell that ContactInhibition has flagged `inhibited` rests (model 6).
class InhibitionArrest : public ArrestRule {
 public:
  static std::unique_ptr<const ArrestRule> make(const BiologySettings&) {
    return std::make_unique<InhibitionArrest>();
  }
  bool arrests(const AgentStore& agents, Index cell) const override { return agents.has(cell, inhibited); }
};

}  // namespace restenosis
