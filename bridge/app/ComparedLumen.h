#pragma once

#include <Eigen/Geometry>
#include <atomic>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <vector>

#include "bridge/scene/Scene.h"
#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// The lumen that flows are compared in, along z or beginning so (laidLumen), and the day it is of.
struct ComparedLumen {
  TriSurface surface;
  double day = 0.0;
  Eigen::Isometry3d alongZ = Eigen::Isometry3d::Identity();  ///< the motion that laid it so
  bool bent = false;                                         ///< whether it begins along z only
};

/// A lumen from a file that cannot be compared: the file is named, and what is needed.
struct LumenRefused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The lumen of a scene just after deployment, before anything grows: the scene is run for one step, without
/// flow and growth, with `folder` for its results. Throws what Run throws.
ComparedLumen deployedLumen(const Scene& scene, const std::filesystem::path& folder, int threads,
                            const std::atomic<bool>* stopRequested);

/// The lumen that a scene loads from a file. Throws LumenRefused where it is none.
ComparedLumen loadedLumen(const Scene& scene);

/// Places on the middles of a scene's struts where they stand after deployment, close to each other, in a
/// lumen laid by `alongZ`; none without a stent.
std::vector<Vec3> strutMiddles(const Scene& scene, const Eigen::Isometry3d& alongZ);

/// The lumen that a run has recorded nearest to a day, the last one without. Throws LumenRefused.
ComparedLumen finishedLumen(const std::filesystem::path& results, std::optional<double> day);

}  // namespace restenosis
