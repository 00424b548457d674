#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "FlowBackend.h"
#include "LatticeFlow.h"
#include "LumenLattice.h"

namespace restenosis {

/// How the stress of nodes is carried to the wall.
enum class StressRule {
  nearest,  ///< that of the nearest node, as it is
  fitted    ///< a linear function fitted to the nodes around, at the wall
};

/// Carries the viscous stress from fluid nodes to the faces of the wall.
///
/// For each face of wall or struts a linear function is fitted, by weighted least squares, to the stress at
/// the nodes within a few spacings on the lumen's side of the face; its value at the face's centre is the
/// stress at the wall. As the fit is linear in the data, each face keeps its nodes and their weights. Normals
/// are smoothed: the area-weighted mean over the faces around, but not over edges sharper than 45 degrees.
class WallStress {
 public:
  WallStress(const TriSurface& lumen, const LumenLattice& lattice, StressRule rule = StressRule::fitted);

  /// Number of faces of wall and struts, in the order of the surface's triangles.
  std::size_t faces() const { return faces_.size(); }
  /// Faces without any node near them, in crevices narrower than the spacing; their traction is zero.
  std::size_t bareFaces() const { return bare_; }
  /// The nodes whose state is needed, by place.
  const std::vector<std::uint32_t>& nodes() const { return nodes_; }
  /// Traction of the fluid on the wall [Pa] at one face, from the viscous stresses at nodes() times `pascal`.
  Vec3 traction(std::size_t face, const std::vector<std::array<double, 6>>& stress, double pascal) const;
  /// All faces with their traction.
  std::vector<WallFace> wall(const std::vector<std::array<double, 6>>& stress, double pascal) const;
  /// The stresses at nodes() in lattice units.
  std::vector<std::array<double, 6>> stresses(const LatticeFlowBase& flow) const;

 private:
  struct Face {
    Vec3 centre, normal;
    double area;
    SurfaceRegion region;
    std::uint32_t first, count;  ///< of terms_
  };
  struct Term {
    std::uint32_t node;  ///< of nodes_
    double weight;
  };
  std::vector<Face> faces_;
  std::vector<Term> terms_;
  std::vector<std::uint32_t> nodes_;
  std::size_t bare_ = 0;
};

}  // namespace restenosis
