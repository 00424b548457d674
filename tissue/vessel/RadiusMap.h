#pragma once

#include <limits>
#include <span>
#include <vector>

#include "tissue/agents/AgentStore.h"

namespace restenosis {

/// A lamina as a smooth surface: its distance from the axis over angle and place along the vessel, averaged
/// from its agents with a weight that falls off over a few radii and interpolated bilinearly.
class RadiusMap {
 public:
  RadiusMap() = default;
  /// Averages the agents of one kind. `smoothing` is the standard deviation of the weight [m], at least half
  /// the spacing of the agents; beyond three of it from all of them the nearest values are continued.
  RadiusMap(const AgentStore& agents, AgentKind kind, double smoothing);
  /// The map with these values [m], `around` of them for each of the places zLow, zLow + zStep, ... [m]; the
  /// first of each is that in the direction -x, the next ones follow counterclockwise.
  RadiusMap(int around, double zLow, double zStep, std::vector<double> values);

  /// Whether there were no agents; `at` is then infinite.
  bool empty() const { return values_.empty(); }
  /// Distance of the surface from the axis at the point's angle and place along the vessel [m].
  double at(const Vec3& point) const;
  /// Unit vector out of the surface at the point's angle and place along the vessel, from differences over
  /// the spacing of the map.
  Vec3 normalAt(const Vec3& point) const;
  /// Distances of the nodes of the map from the axis [m].
  std::span<const double> values() const { return values_; }
  /// Lower bound of `at` at a point [m], found without an angle; infinite without agents.
  double lowestNear(double x, double y, double z) const;
  /// Lower bound of `at` everywhere [m]; infinite without agents.
  double lowest() const { return lowestOfAll_; }

  /// A map built again may differ by rounding: it sums over agents in the order of the store.
  template <class Archive>
  void archive(Archive& a) {
    a(around_, along_, zLow_, zStep_, values_, lowest_, lowestOfAll_);
  }

 private:
  double& value(int around, int along) { return values_[static_cast<std::size_t>(along) * around_ + around]; }
  double value(int around, int along) const {
    return values_[static_cast<std::size_t>(along) * around_ + around];
  }
  void continueIntoGaps(std::vector<double>& weight);
  void bound();
  /// Sector of a direction, increasing with its angle.
  static int sectorOf(double x, double y);
  /// Interval along the vessel, between two nodes of the map.
  int intervalOf(double z) const;

  int around_ = 0, along_ = 0;
  double zLow_ = 0, zStep_ = 1;
  std::vector<double> values_;
  std::vector<double> lowest_;  ///< by interval along the vessel and sector
  double lowestOfAll_ = std::numeric_limits<double>::infinity();
};

}  // namespace restenosis
