#pragma once

#include <cmath>
#include <nanoflann.hpp>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// The points nearest to a place, among those given.
class PointTree {
 public:
  explicit PointTree(std::vector<Vec3> points) : cloud_{std::move(points)}, tree_(3, cloud_) {
    tree_.buildIndex();
  }
  PointTree(const PointTree&) = delete;
  PointTree& operator=(const PointTree&) = delete;

  bool empty() const { return cloud_.points.empty(); }
  struct Near {
    std::size_t index;
    double distance;  ///< [m]
  };
  /// At most `count` of them, the nearest first; equally near ones in the tree's order, which is fixed.
  std::vector<Near> nearest(const Vec3& place, std::size_t count) const {
    std::vector<std::uint32_t> index(count);
    std::vector<double> square(count);
    const std::size_t found = empty() ? 0 : tree_.knnSearch(place.data(), count, index.data(), square.data());
    std::vector<Near> result;
    for (std::size_t i = 0; i < found; ++i) result.push_back({index[i], std::sqrt(square[i])});
    return result;
  }

  /// All of them nearer than `distance` [m], in the tree's order, which is fixed.
  std::vector<Near> within(const Vec3& place, double distance) const {
    std::vector<std::pair<std::uint32_t, double>> found;
    if (!empty())
      tree_.radiusSearch(place.data(), distance * distance, found, nanoflann::SearchParams(0, 0.0f, false));
    std::vector<Near> result;
    for (const auto& [index, square] : found) result.push_back({index, std::sqrt(square)});
    return result;
  }

  /// Whether `condition(index)` holds for one of them nearer than `distance` [m]. Asks none after that one.
  template <class Condition>
  bool anyWithin(const Vec3& place, double distance, Condition condition) const {
    struct Search {
      double square;
      Condition& condition;
      bool found = false;
      double worstDist() const { return square; }
      bool full() const { return true; }
      bool addPoint(double, std::uint32_t index) {
        found = condition(std::size_t{index});
        return !found;
      }
    } search{distance * distance, condition};
    if (!empty()) tree_.findNeighbors(search, place.data(), nanoflann::SearchParams(0, 0.0f, false));
    return search.found;
  }

 private:
  struct Cloud {
    std::vector<Vec3> points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const {
      return points[i][static_cast<Eigen::Index>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };
  Cloud cloud_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3> tree_;
};

}  // namespace restenosis
