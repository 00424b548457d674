#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "bridge/surface/LumenField.h"

namespace restenosis {

/// Lumen radius by axial position and angle: how far one sees from the vessel's axis. It costs no
/// triangulation and is what displacement and neointima are measured with.
class RadialMap {
 public:
  RadialMap() = default;
  /// Casts `angles` rays outwards in every plane of the field's nodes, up to the first point where the
  /// (bilinear) field is not positive. A ray that starts in tissue has radius 0.
  explicit RadialMap(const LumenField& field, int angles = 360);
  /// The map of a lumen that is round: `radius` gives it [m] by axial position. Planes lie about `spacing`
  /// [m] apart, the first and the last on the ends z = 0 and `length` [m].
  static RadialMap ofRound(const std::function<double(double)>& radius, double length, double spacing,
                           int angles = 360);

  int planes() const { return static_cast<int>(z_.size()); }
  int angles() const { return angles_; }
  double z(int plane) const { return z_[plane]; }  ///< [m]
  double angle(int index) const;                   ///< from the x axis [rad]
  double radius(int plane, int angle) const {
    return radius_[static_cast<std::size_t>(plane) * angles_ + angle];
  }
  /// A quantity given for every ray, plane by plane, at the axial position and angle of a point: bilinear
  /// between rays; beyond the ends as on them.
  double interpolate(std::span<const double> byRay, const Vec3& point) const;
  double radiusAt(const Vec3& point) const { return interpolate(radius_, point); }  ///< [m]
  double meanRadius() const;          ///< over planes (trapezoidal) and angles [m]
  double lumenArea(int plane) const;  ///< of a cross-section as seen from the axis [m^2]
  /// The plane nearest to a z [m]. Throws std::invalid_argument for a map without planes.
  int nearestPlane(double z) const;
  /// Smallest cross-section of the planes between two z [m^2]; where none lies there, that of the plane
  /// nearest to their middle. Throws std::invalid_argument for a map without planes.
  double minimalArea(double from = -HUGE_VAL, double to = HUGE_VAL) const;
  double planeWeight(int plane) const;  ///< length of vessel a plane stands for [m]
  bool comparable(const RadialMap& other) const;

  template <class Archive>
  void archive(Archive& a) {
    a(angles_, z_, radius_);
  }

 private:
  int angles_ = 0;
  std::vector<double> z_, radius_;
};

/// How far a lumen has moved between two maps.
struct LumenDisplacement {
  double mean = 0;     ///< of |dR| [m]
  double robust = 0;   ///< 99 % of the lumen moved less than this [m]; what `lumenTolerance` is compared with
  double largest = 0;  ///< [m]
};

/// Compares two maps on the same planes and angles; throws std::invalid_argument if they are not. The robust
/// measure is the 99th percentile of |dR|: the largest is set by a single ray that passes or meets the edge
/// of one cell or strut, the mean hides growth that is confined to a few struts.
LumenDisplacement displacement(const RadialMap& before, const RadialMap& after);

/// Neointima (model 10): the post-deployment lumen minus the present one.
struct Neointima {
  double meanThickness = 0;          ///< over the section asked for [m]
  double meanAreaFraction = 0;       ///< 1 - lumen / post-deployment lumen area, mean over the section
  std::vector<double> z;             ///< planes of the section [m]
  std::vector<double> thickness;     ///< mean over the angles, by plane [m]
  std::vector<double> areaFraction;  ///< by plane
};

/// Measures the neointima between axial positions `from` and `to` [m]. Thickness is signed: where the lumen
/// has widened it is negative. The plane nearest to the section's middle always belongs to it. Throws
/// std::invalid_argument for maps without planes or on different ones.
Neointima measureNeointima(const RadialMap& postDeployment, const RadialMap& present, double from, double to);

}  // namespace restenosis
