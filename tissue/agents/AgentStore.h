#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "tissue/agents/OptionalArray.h"

namespace restenosis {

using Vec3 = Eigen::Vector3d;
using AgentId = std::uint64_t;  ///< identifies an agent for ever, never reused
using Index = std::uint32_t;    ///< position in the store; changes when the store is reordered

/// What an agent is. `strut` agents are obstacles: they are moved by deployment only.
enum class AgentKind : std::uint8_t { smc, iel, eel, strut };

/// Phase of the cell cycle; meaningful for `smc` only.
enum class CycleState : std::uint8_t { g0, g1, sg2m };

/// Bits of AgentStore::flags.
enum AgentFlag : std::uint8_t {
  fixed = 1,        ///< never moved by mechanics (vessel ends, EEL during growth, struts)
  synthetic = 2,    ///< may cycle (model 4)
  inhibited = 4,    ///< contact-inhibited in the last evaluation (model 6)
  covered = 8,      ///< carries endothelium (model 7)
  exposed = 16,     ///< faces the lumen: more of it is free of neighbours than the threshold (model 6)
  injuredIel = 32,  ///< was an IEL agent before injury made it a synthetic cell
  daughter = 64     ///< born during growth: belongs to the neointima
};

/// The agents as a structure of arrays; all arrays have the same length. SI units.
struct AgentStore {
  std::vector<AgentId> id;
  std::vector<double> x, y, z;  ///< centre [m]; the vessel's axis is z, its inlet end z = 0
  std::vector<double> radius;   ///< [m]
  std::vector<AgentKind> kind;
  std::vector<CycleState> state;
  std::vector<std::uint8_t> flags;  ///< AgentFlag bits
  std::vector<double> clock;        ///< time spent in the present cycle phase [s]
  std::vector<double> g1Duration;   ///< this cycle's length of G1 [s], 0 before it is drawn
  std::vector<double> birthRadius;  ///< radius at birth; growth ends at twice its volume [m]
  std::vector<std::uint32_t>
      generation;           ///< divisions since the packed wall; keys random numbers of a cell's cycle
  std::vector<double> wss;  ///< wall shear stress received [Pa]
  std::vector<double> nitricOxide;  ///< [nmol/mm^3]
  std::vector<double> stress;       ///< minus a third of the trace of its virial stress [Pa]
  OptionalArray<float> activation;  ///< how far a cell has been told to grow, 0 to 1 (model 5)
  /// Of the matrix that a cell has laid down around itself, over 4 pi / 3 [m^3]: the agent's radius is
  /// cbrt(cellRadius^3 + matrix) (model 5)
  OptionalArray<float> matrix;
  OptionalArray<float> maturity;  ///< of a cell's endothelium, 0 to 1 (model 7)
  AgentId nextId = 0;

  Index size() const { return static_cast<Index>(x.size()); }
  Vec3 position(Index i) const { return {x[i], y[i], z[i]}; }
  void setPosition(Index i, const Vec3& p) { x[i] = p.x(), y[i] = p.y(), z[i] = p.z(); }
  /// Radius of a cell without its matrix [m].
  double cellRadius(Index i) const {
    return matrix[i] > 0 ? std::cbrt(radius[i] * radius[i] * radius[i] - matrix[i]) : radius[i];
  }
  /// Share of an agent's volume that is matrix.
  double matrixShare(Index i) const { return matrix[i] / (radius[i] * radius[i] * radius[i]); }
  /// Sets the radius of a cell and the matrix around it.
  void setCell(Index i, double cell, float matrixAround) {
    radius[i] = matrixAround > 0 ? std::cbrt(cell * cell * cell + matrixAround) : cell;
    if (matrix.modelled()) matrix.set(i, matrixAround);
  }
  bool has(Index i, AgentFlag flag) const { return (flags[i] & flag) != 0; }
  void set(Index i, AgentFlag flag, bool on) {
    flags[i] = static_cast<std::uint8_t>(on ? flags[i] | flag : flags[i] & ~flag);
  }

  /// Reserves memory for so many agents.
  void reserve(Index agents);
  /// Appends an agent at rest (G0, no flags) with a fresh id and returns its index.
  Index append(AgentKind kind, const Vec3& position, double radius);
  /// Removes every agent i with remove[i] != 0, keeping the order of the rest.
  void erase(std::span<const std::uint8_t> remove);
  /// Puts agent order[k] at position k; `order` is a permutation.
  void reorder(std::span<const Index> order);

  /// Passes every array to an archive: writing, reading and hashing a state are this one function.
  template <class Archive>
  void archive(Archive& a) {
    a(id, x, y, z, radius, kind, state, flags, clock, g1Duration, birthRadius, generation, wss, nitricOxide,
      stress, nextId, activation, matrix, maturity);
  }

 private:
  template <class F>
  void forEachArray(F&& f) {
    f(id), f(x), f(y), f(z), f(radius), f(kind), f(state), f(flags), f(clock), f(g1Duration), f(birthRadius),
        f(generation), f(wss), f(nitricOxide), f(stress);
    for (auto* optional : {&activation, &matrix, &maturity})
      if (optional->modelled()) f(optional->values());
  }
};

}  // namespace restenosis
