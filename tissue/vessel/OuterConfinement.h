#pragma once

#include "tissue/equilibrium/Constraint.h"
#include "tissue/vessel/RadiusMap.h"

namespace restenosis {

/// Keeps cells inside a smooth surface through the EEL: a pressed cell would leak between the spheres of the
/// lamina (model 4). The surface is the radius map of the EEL agents; a cell's centre stays `margin` of its
/// radius inside it. The constraint acts radially.
///
/// The surface is fixed at construction: make a new one after the EEL has moved.
class OuterConfinement : public Constraint {
 public:
  OuterConfinement() = default;  ///< confines nothing
  /// `cellRadius` is the mean radius of the wall's agents [m]; the surface is smoothed over twice that.
  OuterConfinement(const AgentStore& agents, double cellRadius, double margin = defaultMargin);

  /// Half a radius (assumed): a cell at rest beside the EEL is further in, so the surface carries nothing
  /// there.
  static constexpr double defaultMargin = 0.5;

  void project(AgentKind kind, double radius, Vec3& position) const override;
  double margin(AgentKind kind, double radius, const Vec3& position) const override;
  void release(AgentKind kind, double radius, const Vec3& position, Vec3& force) const override;

  template <class Archive>
  void archive(Archive& a) {
    a(map_, margin_);
  }

 private:
  /// Distance from the axis [m] below which release() does not act where the surface is at `surface` [m].
  double clearlyInside(double surface, double radius) const;
  /// Whether an agent is so far inside that the surface cannot act; cheap, and true of most.
  bool deepInside(const Vec3& position, double radius) const;

  RadiusMap map_;
  double margin_ = defaultMargin;
};

}  // namespace restenosis
