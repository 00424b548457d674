#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/lbm/LatticeFlow.h"
#include "bridge/flow/lbm/LumenLattice.h"
#include "bridge/flow/lbm/WallFit.h"

namespace restenosis {

class WallDistances;

/// How the stress on a face of the wall follows from the nodes near it.
enum class StressRule {
  adaptive,  ///< fitted where the wall is smooth on the scale of the spacing; elsewhere ratio, on struts
             ///< gradient
  gradient,  ///< of the velocity along the normal, fitted to the nodes that face it, with none on the wall
  ratio,     ///< of the velocity to the distance from the wall, fitted to the nodes around, at the wall
  fitted,    ///< a linear function fitted to the stress of the nodes around, at the wall
  nearest    ///< the stress of the nearest node, as it is
};

/// Finds the stress on the faces of wall and struts.
///
/// Every rule is linear in what the nodes within a few spacings on the lumen's side of a face hold, so each
/// face keeps its nodes and their weights. Normals are smoothed (SmoothNormals).
class WallStress {
 public:
  /// @param viscosity kinematic, in lattice units  @param thinning what it is where it falls with the rate
  WallStress(const TriSurface& lumen, const LumenLattice& lattice, StressRule rule, double viscosity,
             const std::optional<ViscosityLaw>& thinning = {});

  /// Number of faces of wall and struts: the surface's triangles in their order, long ones in pieces.
  std::size_t faces() const { return faces_.size(); }
  /// Faces without any node near them, in crevices narrower than the spacing; their traction is zero.
  std::size_t bareFaces() const { return bare_; }

  /// What is taken from a node: its viscous stress and its velocity.
  using NodeValue = std::array<double, 9>;
  /// Of the nodes near the wall, in lattice units.
  std::vector<NodeValue> nodeValues(const LatticeFlowBase& flow) const;
  /// Traction of the fluid on the wall at one face: in lattice units times `pascal`.
  Vec3 traction(std::size_t face, const std::vector<NodeValue>& values, double pascal) const;
  /// All faces with their traction.
  std::vector<WallFace> wall(const std::vector<NodeValue>& values, double pascal) const;

 private:
  struct Face {
    Vec3 centre, normal;
    double area;
    SurfaceRegion region;
    std::uint32_t first, count;  ///< of terms_
    StressRule rule;             ///< not adaptive
    bool ofVelocity() const { return rule == StressRule::gradient || rule == StressRule::ratio; }
  };
  struct Term {
    std::uint32_t node;  ///< of nodes_
    float weight;        ///< half the memory of a double, of which a stented vessel takes 300 MB
  };
  using NodesOfFaces = std::vector<std::vector<NearNode>>;

  void listFaces(const TriSurface& lumen, StressRule rule, double dx);
  /// Decides each face's rule.
  void decideRules(StressRule rule, double dx);
  /// Makes the weights of the faces' nodes those of the stress, by each face's rule.
  static void weigh(std::span<const Face> faces, NodesOfFaces& found, const WallDistances& distances);
  /// Adds to terms_, by place.
  void keep(std::span<Face> faces, const NodesOfFaces& found);
  /// Fills nodes_, and lets terms_ name them.
  void numberNodes(std::size_t places);

  double viscosity_;
  std::optional<ViscosityLaw> thinning_;
  std::vector<Face> faces_;
  std::vector<Term> terms_;
  std::vector<std::uint32_t> nodes_;  ///< places
  std::size_t bare_ = 0;
};

}  // namespace restenosis
