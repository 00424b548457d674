#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"
#include "tissue/agents/BondTable.h"
#include "tissue/forces/Spheres.h"

namespace restenosis {

/// Copies of position and radius, packed as the pair kernel reads them: in mixed precision if that is wanted
/// and can express every agent, else in double precision.
class AgentSpheres {
 public:
  /// `mixed`: the scale of mixed precision; nothing for double precision. `agents` and `bonds` must outlive
  /// the object.
  AgentSpheres(const AgentStore& agents, const BondTable& bonds, std::optional<FixedScale> mixed)
      : agents_(agents), bonds_(bonds), wanted_(mixed) {}

  /// Chooses the precision, copies all agents and keeps capacity for an eighth more.
  void copyAll();
  bool mixed() const { return scale_.has_value(); }
  /// Whether the precision remains the right one where these agents have changed.
  bool precisionHolds(std::span<const Index> changed) const;

  /// An index that no agent has: that of a sphere that touches nothing. Agents below it can be copied.
  Index none() const { return none_; }
  void copy(Index i);
  /// Whether agent i is not where and as large as its copy.
  bool changed(Index i) const;
  float radius(Index i) const {  ///< [m]
    return scale_ ? fixed_[i].r : static_cast<float>(exact_[i].r);
  }
  /// Square of the distance of two copies, up to rounding in single precision [m^2].
  float squaredDistance(Index i, Index j) const {
    if (!scale_)
      return squares(exact_[i].x - exact_[j].x, exact_[i].y - exact_[j].y, exact_[i].z - exact_[j].z);
    const auto apart = [this](std::uint32_t a, std::uint32_t b) {
      return static_cast<float>(static_cast<std::int32_t>(a - b)) * static_cast<float>(scale_->unit());
    };
    const FixedSphere &a = fixed_[i], &b = fixed_[j];
    return squares(apart(a.x, b.x), apart(a.y, b.y), apart(a.z, b.z));
  }
  /// How far agent i is from its copy, and by how much its radius differs [m].
  struct Change {
    double distance, growth;
  };
  Change changeOf(Index i) const;
  /// Moves the copy of agent i, of this radius.
  void move(Index i, const Vec3& position, float radius) {
    if (scale_) {
      fixed_[i] = fixedSphere(*scale_, position, radius);
    } else {
      exact_[i] = {position.x(), position.y(), position.z(), exact_[i].r};
    }
  }

  /// Calls f with the copies, an ExactSpheres or a FixedSpheres.
  template <class F>
  void visit(F&& f) const {
    if (scale_) {
      f(FixedSpheres(fixed_, scale_->unit()));
    } else {
      f(ExactSpheres(exact_));
    }
  }

 private:
  bool fits(Index i) const;
  template <class Real>
  static float squares(Real x, Real y, Real z) {
    return static_cast<float>(x * x + y * y + z * z);
  }

  const AgentStore& agents_;
  const BondTable& bonds_;
  std::optional<FixedScale> wanted_;
  std::optional<FixedScale> scale_;  ///< wanted_, unless an agent does not fit
  Index none_ = 0;
  std::vector<FixedSphere> fixed_;  ///< in mixed precision
  std::vector<Sphere> exact_;       ///< in double precision
};

}  // namespace restenosis
