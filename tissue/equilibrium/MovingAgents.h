#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/equilibrium/MotionPiece.h"
#include "tissue/forces/PairRows.h"

namespace restenosis {

/// Agents that move, piece by piece.
struct MovingAgents {
  std::vector<Index> agents;  ///< in ascending order
  std::vector<MotionPiece> pieces;
  std::vector<PairRows> rows;  ///< of each piece; AgentForces' own
  bool areRowsOf = false;      ///< whether `rows` are those of these agents: to be cleared when others move

  std::size_t size() const { return agents.size(); }
  /// How many agents there are room for.
  std::size_t capacity() const { return pieces.capacity() * MotionPiece::most; }
  /// Makes it so many agents; those added are yet to be set.
  void resize(std::size_t count) {
    agents.resize(count);
    pieces.resize((count + MotionPiece::most - 1) / MotionPiece::most);
  }
  MotionPiece& pieceOf(std::size_t k) { return pieces[k / MotionPiece::most]; }
  const MotionPiece& pieceOf(std::size_t k) const { return pieces[k / MotionPiece::most]; }
  /// The place of the k-th agent in its piece.
  static std::size_t inPiece(std::size_t k) { return k % MotionPiece::most; }
  /// The agents of the piece that begins with the k-th.
  std::span<const Index> agentsFrom(std::size_t k) const {
    return std::span(agents).subspan(k, std::min(MotionPiece::most, size() - k));
  }
  void set(std::size_t k, const AgentMotion& agent) { pieceOf(k).set(inPiece(k), agent); }
  void setNow(std::size_t k, const AgentForce& now) { pieceOf(k).setNow(inPiece(k), now); }
  AgentForce now(std::size_t k) const { return pieceOf(k).now(inPiece(k)); }
  Vec3 position(std::size_t k) const { return pieceOf(k).position(inPiece(k)); }
  /// Makes the k-th agent the m-th.
  void copy(std::size_t k, std::size_t m) {
    agents[k] = agents[m];
    pieceOf(k).copy(inPiece(k), pieceOf(m), inPiece(m));
  }
  /// After agents were set or left out.
  void fillLanes() {
    if (!pieces.empty()) pieces.back().fillLanes(size() - (pieces.size() - 1) * MotionPiece::most);
  }
};

}  // namespace restenosis
