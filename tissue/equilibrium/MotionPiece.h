#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "tissue/agents/Chunks.h"
#include "tissue/agents/Lanes.h"
#include "tissue/equilibrium/AgentMotion.h"

namespace restenosis {

/// Up to `most` agents that move, with all of their own that a step reads and writes: those that are awake
/// among sleepers are few, and far apart in the store. Loops over them compute several at once and go on to
/// the end of the last lanes, where agents are that fillLanes() made.
///
/// Where agents are is in double precision, for the forces are differences of pair forces. What leads there
/// need not be: a step whose length errs by 10^-7 of itself is as good.
struct alignas(64) MotionPiece {
  static constexpr std::size_t most = chunkSize;
  static constexpr std::size_t lanes = 8;
  using Values = Numbers<float, static_cast<int>(lanes)>;
  using Doubles = std::array<double, most>;
  using Floats = std::array<float, most>;

  Doubles x, y, z;    ///< [m]
  Floats vx, vy, vz;  ///< velocity, the minimiser's own
  Floats fx, fy, fz;  ///< AgentForce::force, where they are [N]
  Floats stiffness;   ///< AgentForce::stiffness [N/m]
  Floats residual;    ///< AgentForce::residual
  Floats radius;      ///< [m]
  Floats leash;       ///< AgentMotion::leash [m]
  Floats room;        ///< AgentMotion::room [m]
  Floats way;         ///< come since those beside them were looked at [m]
  std::array<AgentKind, most> kind;
  std::array<std::uint8_t, most> daughter;

  Vec3 position(std::size_t k) const { return {x[k], y[k], z[k]}; }
  Vec3 force(std::size_t k) const { return {fx[k], fy[k], fz[k]}; }
  void setForce(std::size_t k, const Vec3& force) {
    fx[k] = static_cast<float>(force.x());
    fy[k] = static_cast<float>(force.y());
    fz[k] = static_cast<float>(force.z());
  }
  AgentForce now(std::size_t k) const {
    return {.force = force(k), .stiffness = stiffness[k], .residual = residual[k]};
  }
  void setNow(std::size_t k, const AgentForce& now);
  /// Makes the k-th this agent, at rest; no force on it is known.
  void set(std::size_t k, const AgentMotion& agent);
  /// Makes the k-th what the m-th of a piece is.
  void copy(std::size_t k, const MotionPiece& from, std::size_t m);
  /// Asks for all of it, so that it comes while something else is computed. Speed only.
  void fetch() const {
    constexpr std::size_t line = 64;
    for (std::size_t at = 0; at < sizeof(MotionPiece); at += line)
      __builtin_prefetch(reinterpret_cast<const char*>(this) + at);
  }
  /// Of `count` agents: puts agents at rest, on which nothing acts, into what is left of the last lanes.
  void fillLanes(std::size_t count);
};

/// How far the agents of a piece are to move [m].
struct Moves {
  MotionPiece::Floats x, y, z;
};

}  // namespace restenosis
