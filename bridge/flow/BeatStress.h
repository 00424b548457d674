#pragma once

#include <span>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// The traction of a beating flow on a face of the wall, over one beat (docs/model/beats.md).
struct BeatStress {
  Vec3 mean = Vec3::Zero();  ///< of the vector over time [Pa]
  double average = 0.0;      ///< TAWSS: of its size over time [Pa]
  double transverse = 0.0;   ///< transWSS: of the size of its part across `mean` [Pa]

  /// OSI = (1 - |mean| / TAWSS) / 2, from 0 to 0.5 (He and Ku 1996). Not a number without any stress.
  double oscillatoryIndex() const;
  /// RRT = 1 / ((1 - 2 OSI) TAWSS) = 1 / |mean| [1/Pa] (Himburg et al. 2004); infinite where nothing is left.
  double residenceTime() const;

  template <class Archive>
  void archive(Archive& a) {
    a(mean.x(), mean.y(), mean.z(), average, transverse);
  }
};

/// Of tractions on a face, at evenly spaced times of one beat. `normal` is the face's unit normal.
BeatStress beatStress(std::span<const Vec3> tractions, const Vec3& normal);

}  // namespace restenosis
