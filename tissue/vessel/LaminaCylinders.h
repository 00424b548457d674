#pragma once

#include "Constraint.h"

namespace restenosis {

/// For packing: each lamina's agents slide on its cylinder, and cells stay between the two, their centres at
/// least `clearance` from both.
class LaminaCylinders : public Constraint {
 public:
  /// Radii of the cylinders of the IEL's and the EEL's centres, and the clearance [m].
  LaminaCylinders(double ielRadius, double eelRadius, double clearance)
      : ielRadius_(ielRadius), eelRadius_(eelRadius), clearance_(clearance) {}
  void project(AgentKind kind, double radius, Vec3& position) const override;
  void release(AgentKind kind, double radius, const Vec3& position, Vec3& force) const override;

 private:
  double ielRadius_, eelRadius_, clearance_;
};

}  // namespace restenosis
