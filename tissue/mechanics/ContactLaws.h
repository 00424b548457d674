#pragma once

#include <string_view>
#include <vector>

#include "ForceField.h"

namespace restenosis {

/// All that the force loop reads of the agents.
struct ForceInput {
  std::span<const Sphere> spheres;
  std::span<const std::uint8_t> flags;
  const NeighbourList& neighbours;
  const BondTable& bonds;
  const MechanicsParameters& parameters;
};

/// One contact law in the table: the force loop compiled for it, so that no pair pays for the choice.
struct ContactLaw {
  std::string_view name;
  void (*evaluate)(const ForceInput&, std::span<const Index> subset, std::span<AgentLoad> load);
  double (*energy)(double modulus, double overlap, double reducedRadius);
  double (*validOverlap)(double reducedRadius);
};

/// The law called `name`. Throws std::invalid_argument naming the known ones.
const ContactLaw& contactLaw(std::string_view name);
std::vector<std::string_view> contactLawNames();

}  // namespace restenosis
