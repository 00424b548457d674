#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/forces/AgentLoad.h"
#include "tissue/forces/MechanicsParameters.h"
#include "tissue/forces/PairList.h"
#include "tissue/forces/Spheres.h"
#include "tissue/neighbours/NeighbourList.h"

namespace restenosis {

/// The forces between agents (model 3): contact, bonds, cohesion.
///
/// Summed agent by agent in ascending order of partners. Pairs out of range add nothing, so every list that
/// holds all pairs in range gives the same bits, and so does every number of threads.
///
/// In mixed precision, differences of positions are exact, and what follows is in single precision: a force
/// has an error of some 10^-6 of the largest pair force on its agent.
class ForceField {
 public:
  /// Throws std::invalid_argument for an unknown contact law, naming the known ones.
  explicit ForceField(const MechanicsParameters& parameters);

  /// Which pairs a neighbour list must hold.
  NeighbourRange range(double skin) const;

  /// The pairs of a neighbour list and of bonds.
  PairSource pairs(const AgentStore& agents, const NeighbourList& neighbours, const BondTable& bonds) const;

  /// Sets loads[k] for the k-th of `agents`, which have the pairs `list`. In the calling thread: for use in
  /// parallel loops.
  void evaluate(const ExactSpheres& spheres, const PairList& list, std::span<const Index> agents,
                std::span<AgentLoad> loads) const;
  void evaluate(const FixedSpheres& spheres, const PairList& list, std::span<const Index> agents,
                std::span<AgentLoad> loads) const;

  /// Loads of all agents by the plain kernel. Makes its own neighbour list.
  std::vector<AgentLoad> evaluate(const AgentStore& agents, const BondTable& bonds) const;

  /// Sets the stresses of all agents, but for struts, to those of their present positions.
  void setStresses(AgentStore& agents, const BondTable& bonds) const;

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
