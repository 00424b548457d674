#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>

#include "bridge/compare/FlowComparison.h"

namespace restenosis {

/// What was compared.
struct ComparedCase {
  std::string scene;  ///< name of the scene
  std::string fidelity;
  double day = 0.0;             ///< of the lumen
  double latticeSpacing = 0.0;  ///< [m]
  /// The motion that laid the lumen along z before it was compared. Files say where things lay before it.
  bool bent = false;  ///< whether the lumen begins along z only
  Eigen::Isometry3d alongZ = Eigen::Isometry3d::Identity();
};

/// compare.json: WSS by part, pressure drop, velocities, cost. Throws WriteFailed.
void writeComparisonJson(const std::filesystem::path& file, const ComparedCase& what,
                         const FlowComparison& comparison, const SolvedFlow& reference,
                         const SolvedFlow& other);

/// compare.vtp: the lumen's wall and struts with, on each triangle, part (ComparedPart), WSS and traction of
/// either backend and their difference [Pa]. Throws WriteFailed.
void writeComparisonSurface(const std::filesystem::path& file, const TriSurface& lumen,
                            const FlowComparison& comparison, const SolvedFlow& reference,
                            const SolvedFlow& other, const ComparedCase& what);

/// compareVelocity.csv: where (axis, plane1, ...), point [mm] and the velocity of either backend [m/s].
/// Writes nothing where a backend gave none. Throws WriteFailed.
void writeComparedVelocities(const std::filesystem::path& file, const FlowComparison& comparison,
                             const SolvedFlow& reference, const SolvedFlow& other, const ComparedCase& what);

}  // namespace restenosis
