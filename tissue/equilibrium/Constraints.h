#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "tissue/equilibrium/Constraint.h"

namespace restenosis {

/// All constraints of a relaxation as one, applied in their order.
class Constraints {
 public:
  /// They must outlive the object.
  explicit Constraints(std::span<const Constraint* const> all) : all_(all.begin(), all.end()) {}

  void project(AgentKind kind, double radius, Vec3& position) const {
    for (const Constraint* one : all_) one->project(kind, radius, position);
  }
  void release(AgentKind kind, double radius, const Vec3& position, Vec3& force) const {
    for (const Constraint* one : all_) one->release(kind, radius, position, force);
  }
  /// The least of their margins, in single precision and not above it [m].
  float margin(AgentKind kind, double radius, const Vec3& position) const {
    constexpr double shorter = 1 - 1e-5;
    double least = std::numeric_limits<double>::infinity();
    for (const Constraint* one : all_) least = std::min(least, one->margin(kind, radius, position));
    return static_cast<float>(shorter * least);
  }

 private:
  std::vector<const Constraint*> all_;
};

}  // namespace restenosis
