#include "bridge/flow/BeatStress.h"

#include <cmath>

namespace restenosis {

double BeatStress::oscillatoryIndex() const { return 0.5 * (1 - mean.norm() / average); }

double BeatStress::residenceTime() const { return 1 / mean.norm(); }

BeatStress beatStress(std::span<const Vec3> tractions, const Vec3& normal) {
  BeatStress stress;
  const auto share = 1.0 / static_cast<double>(tractions.size());
  for (const Vec3& traction : tractions) {
    stress.mean += share * traction;
    stress.average += share * traction.norm();
  }
  const Vec3 across = normal.cross(stress.mean);
  if (const double size = across.norm(); size > 0)
    for (const Vec3& traction : tractions) stress.transverse += share * std::abs(traction.dot(across) / size);
  return stress;
}

}  // namespace restenosis
