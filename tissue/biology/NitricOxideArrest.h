#pragma once

#include <memory>

#include "tissue/biology/ArrestRule.h"
#include "tissue/biology/BiologySettings.h"
#include "tissue/biology/Endothelium.h"
#include "tissue/biology/NitricOxide.h"

namespace restenosis {

/// A cell rests if its endothelium produces enough nitric oxide under its wall shear stress (model 7).
class NitricOxideArrest : public ArrestRule {
 public:
  /// Null without endothelium.
  static std::unique_ptr<const ArrestRule> make(const BiologySettings& settings);
  NitricOxideArrest(const EndotheliumParameters& parameters, double endotheliumOnset);

  bool arrests(const AgentStore& agents, Index cell) const override {
    return agents.nitricOxide[cell] >= law_.threshold();
  }
  bool readsWss() const override { return true; }
  /// Bare cells have no nitric oxide but what reaches them from others.
  bool readsWssOf(const AgentStore& agents, Index cell) const override {
    return reaches_ || agents.has(cell, covered);
  }
  /// Infinite where a cell's own stress does not decide: where nitric oxide reaches others, or endothelium
  /// matures.
  double decidingWss() const override;
  bool undecided(const AgentStore& agents, Index cell, double margin) const override;
  std::string readsNoWssUntil(double time) const override;
  std::string whenWssIsRead() const override;
  std::string_view whenNoCellReads() const override { return "no cell is covered by endothelium"; }
  std::string_view whenAllAreDecided() const override {
    return "every covered cell rests or divides whatever its wall shear stress";
  }

 private:
  NitricOxide law_;
  double onset_;  ///< of coverage [s]
  bool reaches_;  ///< whether nitric oxide reaches other cells
  bool matures_;  ///< whether endothelium makes less of it at first
};

}  // namespace restenosis
