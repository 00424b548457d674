#pragma once

#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// A lumen along z as seen from the line that joins the centres of its ends: how far one sees in planes of
/// constant z, by angle. A lumen with undercuts is seen as what lies in front of them.
class AxisView {
 public:
  /// @param lumen closed, its ends planes of constant z, the inlet below the outlet
  /// @param planes pieces of equal length between the ends [1]: there is one plane more
  /// @param angles rays in each plane, from the x axis on
  /// Throws std::invalid_argument where the line leaves the lumen, or an end is no such plane.
  AxisView(const TriSurface& lumen, int planes, int angles);

  int planes() const { return planes_; }
  int angles() const { return angles_; }
  double radius(int plane, int angle) const { return radius_[index(plane, angle)]; }  ///< [m]
  Vec3 axis(int plane) const;
  /// Share of the rays that meet the lumen's sides again behind where they leave it.
  double undercut() const { return undercut_; }

 private:
  std::size_t index(int plane, int angle) const {
    return static_cast<std::size_t>(plane) * static_cast<std::size_t>(angles_) +
           static_cast<std::size_t>(angle);
  }
  int planes_, angles_;
  Vec3 inlet_, outlet_;
  std::vector<double> radius_;
  double undercut_ = 0.0;
};

}  // namespace restenosis
