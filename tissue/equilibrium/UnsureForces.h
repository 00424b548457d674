#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tissue/agents/AgentMarks.h"
#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/equilibrium/AgentSpheres.h"
#include "tissue/neighbours/NeighbourList.h"

namespace restenosis {

/// On which agents the force may have changed since it was last known exactly: those that are marked, those
/// that move, and those on whom one that moves acts or acted.
class UnsureForces {
 public:
  /// `range`: of the pairs that act; its skin does not count. All others must outlive the object.
  UnsureForces(const AgentStore& agents, const BondTable& bonds, const NeighbourList& neighbours,
               const AgentSpheres& spheres, const NeighbourRange& range)
      : agents_(agents), bonds_(bonds), neighbours_(neighbours), spheres_(spheres), range_(range) {}

  /// Every force of so many agents is unsure, and nobody moves.
  void start(std::size_t agents);
  /// Appends agents up to so many, whose forces are unsure.
  void append(std::size_t agents);

  /// The forces on all agents, or on these, are unsure.
  void mark();
  void mark(std::span<const Index> agents);
  /// So are those on these agents and on those they act on, or acted on where AgentSpheres remembers them.
  void markAround(std::span<const Index> agents);
  /// The same for all that move.
  void markAroundMoving() { markAround(moving_); }
  /// These agents move from now on, too.
  void startMoving(std::span<const Index> agents);
  /// Who moves, in no particular order.
  std::span<const Index> moving() const { return moving_; }
  /// Nobody moves any more.
  void stopMoving();
  /// Every force is known.
  void know();

  /// The agents whose forces are unsure and that are wanted(i), in ascending order.
  template <class Wanted>
  std::vector<Index> those(const Wanted& wanted) const {
    return marked_.those(wanted);
  }

 private:
  /// Whether agent i, were it there and so large, could act on agent j where AgentSpheres remembers it: who
  /// is elsewhere, or of another size, is marked herself.
  bool mayAct(Index i, const Vec3& position, double radius, Index j) const;
  /// Whether it does where it is, or did where AgentSpheres remembers it.
  bool mayHaveActed(Index i, Index j) const;

  const AgentStore& agents_;
  const BondTable& bonds_;
  const NeighbourList& neighbours_;
  const AgentSpheres& spheres_;
  NeighbourRange range_;
  AgentMarks marked_;
  std::vector<std::uint8_t> isMoving_;
  std::vector<Index> moving_;
};

}  // namespace restenosis
