#pragma once

#include <filesystem>
#include <vector>

#include "bridge/surface/TriSurface.h"

namespace restenosis {

/// The axis of a vessel as a file has it, from its inlet to its outlet.
struct CentrelinePoints {
  std::vector<Vec3> points;   ///< [m]
  std::vector<double> radii;  ///< of the lumen there [m]; none where the file has none

  template <class Archive>
  void archive(Archive& a) {
    std::vector<double> flat;
    for (const Vec3& p : points) flat.insert(flat.end(), {p.x(), p.y(), p.z()});
    a(flat, radii);
    points.clear();
    for (std::size_t n = 0; n + 2 < flat.size(); n += 3)
      points.emplace_back(flat[n], flat[n + 1], flat[n + 2]);
  }
};

/// Reads a centreline: a table with the line `x,y,z` or `x,y,z,radius` and then a line a point, or, where the
/// name ends in .vtp, VTK's polygonal data with one line, as VMTK writes it, and the radii in its array
/// MaximumInscribedSphereRadius, if it has that. Of more than 400 points (assumed) some evenly in between are
/// left out. Throws std::runtime_error, which names the file and the line of a table.
CentrelinePoints readCentreline(const std::filesystem::path& file, double metresPerUnit);

}  // namespace restenosis
