#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/forces/MechanicsParameters.h"
#include "tissue/forces/PairRows.h"
#include "tissue/forces/Spheres.h"
#include "tissue/neighbours/NeighbourList.h"

namespace restenosis {

/// What acts on one agent.
struct AgentLoad {
  double fx = 0, fy = 0, fz = 0;  ///< [N]
  double pressure = 0;   ///< minus a third of the trace of the virial stress [Pa]; compression positive
  double stiffness = 0;  ///< sum of the slopes of the acting pair forces [N/m]

  Vec3 force() const { return {fx, fy, fz}; }
};

/// The forces between agents (model 3): contact, bonds, cohesion.
///
/// Gathered agent by agent in ascending order of partners. Pairs out of range add nothing, so every list that
/// holds all pairs in range gives the same bits, and so does every number of threads.
///
/// In mixed precision, differences of positions are exact, and what follows is in single precision: a force
/// has an error of some 10^-6 of the largest pair force on its agent.
///
/// The virial stress of an agent takes half of each pair's branch vector b (from centre to centre):
/// sigma = -(1/V) sum 1/2 b (x) F with F the force on the agent and b pointing to it; pressure =
/// -tr(sigma)/3.
class ForceField {
 public:
  /// Throws std::invalid_argument for an unknown contact law, naming the known ones.
  explicit ForceField(const MechanicsParameters& parameters);

  /// Which pairs a neighbour list must hold.
  NeighbourRange range(double skin) const;

  /// Sets loads[k] for the k-th of `agents`, whose rows are `rows`. In the calling thread: for use in
  /// parallel loops.
  void evaluate(const ExactSpheres& spheres, const PairRows& rows, std::span<const Index> agents,
                std::span<AgentLoad> loads) const;
  void evaluate(const FixedSpheres& spheres, const PairRows& rows, std::span<const Index> agents,
                std::span<AgentLoad> loads) const;

  /// Loads of all agents in double precision, for those who need them once: makes its own neighbour list.
  std::vector<AgentLoad> evaluate(const AgentStore& agents, const BondTable& bonds) const;

  /// Sets the pressures of all agents, but for struts, to those of where they stand.
  void setPressures(AgentStore& agents, const BondTable& bonds) const;

  /// Energy of all contacts, bonds (taken across the axis) and cohesion [J].
  double energy(const AgentStore& agents, const BondTable& bonds) const;

  /// Agents, but for struts, with an overlap past the contact law's validity: its continuation acts on them.
  /// Makes its own neighbour list.
  Index agentsBeyondLaw(const AgentStore& agents) const;

 private:
  MechanicsParameters parameters_;
  const struct ContactLaw* law_;
};

}  // namespace restenosis
