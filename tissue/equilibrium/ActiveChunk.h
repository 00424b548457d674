#pragma once

#include <array>
#include <cstddef>

#include "tissue/agents/Chunks.h"
#include "tissue/agents/Lanes.h"
#include "tissue/forces/PairList.h"

namespace restenosis {

/// What the pair forces do to an agent.
struct AgentForce {
  float fx = 0, fy = 0, fz = 0;  ///< force, without what constraints carry of it [N]
  float stiffness = 1;           ///< sum of the slopes of its pair forces, above 0 [N/m]
  float residual = 0;            ///< how far the force would still move it: force / stiffness / radius
  float stress = 0;              ///< AgentLoad::stress [Pa]
};

/// Up to `capacity` agents of the active set as a structure of arrays: all that a step reads and writes of
/// them. Loops compute several at once and go on to the end of the last lanes, which fillLanes() fills.
///
/// Positions are in double precision, for forces are differences of pair forces. The step that leads there
/// need not be: a step with a length that errs by 10^-7 of itself is as good.
struct alignas(64) ActiveChunk {
  static constexpr std::size_t capacity = chunkSize;
  static constexpr std::size_t lanes = 8;
  using Values = Numbers<float, static_cast<int>(lanes)>;
  using Doubles = std::array<double, capacity>;
  using Floats = std::array<float, capacity>;

  Doubles x, y, z;    ///< [m]
  Floats vx, vy, vz;  ///< velocity, the minimiser's own
  Floats fx, fy, fz;  ///< AgentForce
  Floats stiffness;   ///< AgentForce [N/m]
  Floats residual;    ///< AgentForce
  Floats stress;      ///< AgentForce [Pa]
  Floats radius;      ///< [m]
  Floats listMargin;  ///< may move so far before the neighbour list is checked (NeighbourList::margin) [m]
  Floats constraintMargin;  ///< may move so far before a constraint acts (Constraint::margin) [m]
  Floats path;              ///< length of its path since it became active or was last verified [m]
  Floats unreviewed;        ///< the same since its neighbours were last reviewed [m]
  std::array<AgentKind, capacity> kind;

  PairList pairs;             ///< of its agents
  bool pairsCurrent = false;  ///< whether `pairs` are those of its agents and of the neighbour list

  Vec3 position(std::size_t k) const { return {x[k], y[k], z[k]}; }
  AgentForce force(std::size_t k) const {
    return {fx[k], fy[k], fz[k], stiffness[k], residual[k], stress[k]};
  }
  void setForce(std::size_t k, const AgentForce& force);
  /// Makes the k-th an agent at rest, without forces and margins.
  void set(std::size_t k, AgentKind ofKind, const Vec3& position, double ofRadius);
  /// Makes the k-th a copy of the m-th of another chunk or of this one.
  void copy(std::size_t k, const ActiveChunk& from, std::size_t m);
  /// Of `count` agents: fills the rest of the last lanes with agents at rest on which nothing acts.
  void fillLanes(std::size_t count);
};

/// How far the agents of a chunk are to move [m].
struct Moves {
  ActiveChunk::Floats x, y, z;
};

}  // namespace restenosis
