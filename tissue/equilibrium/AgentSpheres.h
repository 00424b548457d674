#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/forces/Spheres.h"

namespace restenosis {

/// Copies of the agents as the force loop reads them: where they are now, in mixed precision if that is asked
/// for and every agent fits what it can express, and in double precision. In mixed precision those in double
/// precision are of the last remember(), else both are one.
class AgentSpheres {
 public:
  /// `wanted`: of mixed precision; nothing for double precision. `agents` and `bonds` must outlive the
  /// object.
  AgentSpheres(const AgentStore& agents, const BondTable& bonds, std::optional<FixedScale> wanted)
      : agents_(agents), bonds_(bonds), wanted_(wanted) {}

  /// Chooses the precision by what all agents are now; there are no copies until packAll().
  void choosePrecision();
  /// Whether the precision is to be chosen anew: an agent did not fit when it was last looked at.
  bool outgrown() const { return outgrown_; }
  bool mixed() const { return scale_.has_value(); }
  /// Whether the precision can express these agents.
  bool fit(std::span<const Index> agents) const;

  /// Copies all agents and makes room for an eighth more.
  void packAll();
  /// An index that no agent has: that of a sphere that touches nothing. Agents below it can be copied.
  Index nobody() const { return nobody_; }
  /// Copies agent i.
  void copy(Index i);
  /// Whether agent i is not where and as large as remember() found it.
  bool changed(Index i) const;
  /// Agent i is here now, and as large as it was: of this radius, which spares waiting for its copy.
  void moveTo(Index i, const Vec3& position, float radius) {
    if (scale_) {
      fixed_[i] = fixedSphere(*scale_, position, radius);
    } else {
      spheres_[i] = {position.x(), position.y(), position.z(), spheres_[i].r};
    }
  }
  /// Copies in double precision these agents, which are where moveTo() put them.
  void remember(std::span<const Index> moved);
  /// Agent i as remember() found it; only in mixed precision is this not where it is now.
  const Sphere& remembered(Index i) const { return spheres_[i]; }

  /// Those remembered.
  ExactSpheres exact() const { return ExactSpheres(spheres_); }
  /// Calls f with those of now, an ExactSpheres or a FixedSpheres.
  template <class F>
  void withPresent(F&& f) const {
    if (scale_) {
      f(FixedSpheres(fixed_, scale_->unit()));
    } else {
      f(exact());
    }
  }

 private:
  bool fits(Index i) const;

  const AgentStore& agents_;
  const BondTable& bonds_;
  std::optional<FixedScale> wanted_;
  std::optional<FixedScale> scale_;  ///< wanted_ unless an agent does not fit
  bool outgrown_ = false;
  Index nobody_ = 0;
  std::vector<FixedSphere> fixed_;  ///< in mixed precision only
  std::vector<Sphere> spheres_;
};

}  // namespace restenosis
