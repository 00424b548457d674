#include "tissue/stent/Injury.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tissue/agents/RandomStream.h"
#include "tissue/neighbours/NeighbourQuery.h"
#include "tissue/stent/LaminaStretch.h"
#include "tissue/vessel/Cylindrical.h"

namespace restenosis {
namespace {

class Injurer {
 public:
  Injurer(Wall& wall, const InjuryParameters& parameters, std::uint64_t seed)
      : wall_(wall),
        agents_(wall.agents),
        parameters_(parameters),
        seed_(seed),
        injured_(wall.agents.size(), 0) {}

  InjuryReport run() {
    findExtent();
    measure();
    if (parameters_.ielBreaks) breakLamina();
    fenestrate();
    turnInjuredIntoCells();
    makeNeighboursSynthetic();
    if (parameters_.removeIel) removeLamina();
    setEndothelium();
    for (Index i = 0; i < agents_.size(); ++i) report_.synthetic += agents_.has(i, synthetic);
    return report_;
  }

 private:
  bool mayBeInjured(Index i) const {
    return agents_.kind[i] == AgentKind::iel && !agents_.has(i, fixed) && agents_.z[i] >= firstZ_ &&
           agents_.z[i] <= lastZ_;
  }

  /// Finds where the IEL may be injured: all but `endMargin` of it beside either fixed end.
  void findExtent() {
    double first = wall_.length, last = 0;
    for (Index i = 0; i < agents_.size(); ++i) {
      if (agents_.kind[i] != AgentKind::iel || agents_.has(i, fixed)) continue;
      first = std::min(first, agents_.z[i]), last = std::max(last, agents_.z[i]);
    }
    const double margin = std::min(parameters_.endMargin, (last - first) / 4);
    firstZ_ = first + margin, lastZ_ = last - margin;
  }

  /// Calls f(a, b, strain) once for every bond of two IEL agents of which at least one may be injured.
  template <class F>
  void forEachIelBond(F&& f) const {
    for (Index a = 0; a < agents_.size(); ++a) {
      if (agents_.kind[a] != AgentKind::iel) continue;
      for (const Bond& bond : wall_.bonds.of(a)) {
        const Index b = bond.partner;
        if (b < a || agents_.kind[b] != AgentKind::iel || !(mayBeInjured(a) || mayBeInjured(b))) continue;
        f(a, b, (agents_.position(a) - agents_.position(b)).norm() / bond.restLength - 1.0);
      }
    }
  }

  void measure() {
    double sum = 0;
    forEachIelBond([&](Index, Index, double strain) {
      sum += strain;
      report_.largestStrain = std::max(report_.largestStrain, strain);
      ++report_.ielBonds;
    });
    if (report_.ielBonds > 0) report_.meanStrain = sum / static_cast<double>(report_.ielBonds);
    stretch_ = laminaStretch(wall_);
    for (Index i = 0; i < agents_.size(); ++i) {
      if (!mayBeInjured(i)) continue;
      ++report_.iel;
      report_.stretched += stretch_[i] > parameters_.stretchedStrain;
    }
  }

  bool isPastLimit(Index a, Index b, double strain) const {
    if (strain <= 0) return false;
    const Vec3 bond = (agents_.position(b) - agents_.position(a)).normalized();
    constexpr double smallest = std::numeric_limits<double>::min();  // a limit of 0 breaks at any strain
    const double along = strain * bond.z() / std::max(parameters_.strainLimitAlong, smallest);
    const double around =
        strain * std::hypot(bond.x(), bond.y()) / std::max(parameters_.strainLimitAround, smallest);
    return along * along + around * around > 1;
  }

  void breakLamina() {
    std::vector<std::pair<Index, Index>> broken;
    forEachIelBond([&](Index a, Index b, double strain) {
      if (isPastLimit(a, b, strain)) broken.emplace_back(a, b);
    });
    for (const auto& [a, b] : broken) {
      wall_.bonds.disconnect(a, b);
      injured_[a] = injured_[b] = 1;
    }
    report_.brokenBonds = broken.size();
    for (Index i = 0; i < agents_.size(); ++i) {
      const bool pastStress =
          parameters_.stressLimit > 0 && std::abs(agents_.stress[i]) > parameters_.stressLimit;
      injured_[i] = mayBeInjured(i) && (injured_[i] || pastStress);
      report_.broken += injured_[i];
    }
  }

  void fenestrate() {
    for (Index i = 0; i < agents_.size(); ++i) {
      if (!mayBeInjured(i) || injured_[i] || stretch_[i] <= parameters_.stretchedStrain) continue;
      RandomStream stream(seed_, agents_.id[i], 0, RandomPurpose::fenestration);
      if (stream.uniform() >= parameters_.fenestrationProbability) continue;
      injured_[i] = 1;
      ++report_.fenestrated;
    }
  }

  void turnInjuredIntoCells() {
    for (Index i = 0; i < agents_.size(); ++i) {
      if (!injured_[i]) continue;
      agents_.kind[i] = AgentKind::smc;
      agents_.state[i] = CycleState::g0;
      agents_.clock[i] = agents_.g1Duration[i] = 0;
      agents_.set(i, injuredIel, true);
    }
  }

  /// Cells become synthetic within reach of injured agents, and of the whole IEL where it is to be removed.
  void makeNeighboursSynthetic() {
    const bool everyCell = parameters_.everyCellSynthetic();
    const CellGrid grid(agents_, 2 * std::max(parameters_.syntheticReach, 1.0) * wall_.cellRadius);
    NeighbourQuery query(agents_, grid);
    const auto becomeSynthetic = [&](Index i) {
      if (agents_.kind[i] == AgentKind::smc && !agents_.has(i, fixed)) agents_.set(i, synthetic, true);
    };
    for (Index i = 0; i < agents_.size(); ++i) {
      if (injured_[i] || everyCell) becomeSynthetic(i);
      const bool leaves = parameters_.removeIel && agents_.kind[i] == AgentKind::iel;
      if (!injured_[i] && !leaves) continue;
      query.forEachNeighbour(i, parameters_.syntheticReach, [&](Index j, double) { becomeSynthetic(j); });
    }
  }

  void removeLamina() {
    std::vector<std::uint8_t> remove(agents_.size(), 0);
    for (Index i = 0; i < agents_.size(); ++i) {
      remove[i] = agents_.kind[i] == AgentKind::iel;
      report_.removed += remove[i];
    }
    wall_.bonds.erase(remove);
    agents_.erase(remove);
  }

  void setEndothelium() {
    const bool kept = !parameters_.denuded();
    for (Index i = 0; i < agents_.size(); ++i) {
      const bool lumenFacing = agents_.kind[i] == AgentKind::iel || agents_.has(i, injuredIel);
      agents_.set(i, covered, kept && lumenFacing);
    }
  }

  Wall& wall_;
  AgentStore& agents_;
  const InjuryParameters& parameters_;
  std::uint64_t seed_;
  std::vector<std::uint8_t> injured_;
  std::vector<double> stretch_;
  double firstZ_ = 0, lastZ_ = 0;  ///< between these the IEL may be injured [m]
  InjuryReport report_;
};

}  // namespace

InjuryReport injure(Wall& wall, const InjuryParameters& parameters, std::uint64_t seed) {
  return Injurer(wall, parameters, seed).run();
}

}  // namespace restenosis
