#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tissue/agents/AgentShapes.h"

namespace restenosis {

/// A sphere at a place where something has changed.
struct DisturbedPlace {
  Vec3 centre;    ///< [m]
  double radius;  ///< [m]
};

/// A copy of the agents as they were when they last moved or grew by more than a tolerance: what is computed
/// from it changes only where the copy does. Every agent is within the tolerance of its copy, so small
/// motions cannot add up unnoticed. Follows agents by id through births, removals and changes of order.
class ReferenceConfiguration {
 public:
  /// Copies the agents that are new, of another kind, or farther from their copy than `tolerance` times its
  /// radius (or grown by more than that), and forgets those that are gone. Returns spheres that hold every
  /// place where the copy changed, old and new ones. Afterwards index i here is agent i there.
  std::vector<DisturbedPlace> follow(const AgentStore& agents, double tolerance);

  /// Place k has the agent of former index order[k]. follow() would find that by their ids, which is slower.
  void reorder(std::span<const Index> order);

  AgentShapes shapes() const { return {x_, y_, z_, radius_, kind_}; }
  /// A byte for each agent that goes with it through changes of order; 0 for a new one.
  std::span<std::uint8_t> marks() { return marks_; }

  template <class Archive>
  void archive(Archive& a) {
    a(id_, x_, y_, z_, radius_, kind_, marks_);
  }

 private:
  /// Moves copy order[k] to place k; a placeholder where that is `noCopy`.
  void permute(std::span<const Index> order);
  /// Adopts the order of `agents`; returns the places of copies of agents that are gone.
  std::vector<DisturbedPlace> reorderLike(const AgentStore& agents);
  bool inOrderOf(const AgentStore& agents) const;
  Index size() const { return static_cast<Index>(id_.size()); }
  DisturbedPlace placeOf(Index i) const { return {shapes().position(i), radius_[i]}; }
  /// Appends a placeholder for an agent to be copied; its radius of 0 differs from every agent's.
  void appendNew(AgentId id);
  /// Whether agent `i` is new, of another kind, or farther from its copy than it may be (follow()).
  bool differs(const AgentStore& agents, Index i, double tolerance) const;
  void copy(const AgentStore& agents, Index i);

  std::vector<AgentId> id_;
  std::vector<double> x_, y_, z_, radius_;  ///< [m]
  std::vector<AgentKind> kind_;
  std::vector<std::uint8_t> marks_;
};

}  // namespace restenosis
