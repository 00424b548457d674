#pragma once

#include <memory>

#include "bridge/flow/WrappedBackend.h"

namespace restenosis {

/// The lumen with both ends carried on straight, along their outward normals, by `length` [m] > 0, as region
/// `wall`. The lumen must pass requireLumenWithPlanarEnds; throws std::invalid_argument where an end is
/// missing or not planar.
TriSurface withStraightEnds(const TriSurface& lumen, double length);

/// Throws std::invalid_argument, naming the place, where straight ends of this `length` [m] run into the
/// lumen or into each other.
void requireRoomForStraightEnds(const TriSurface& lumen, double length);

/// The longest straight ends that a lumen has room for [m], to a tenth of `length`, which has none.
double longestStraightEnds(const TriSurface& lumen, double length);

/// Solves by another backend in the lumen with straight ends, so that what is given at the inlet and outlet
/// (a developed profile, a uniform pressure) holds upstream and downstream of the lumen instead of in it. The
/// wall of the solution is the lumen's alone; pressure drop and mesh are those of the whole.
class StraightEnds : public WrappedBackend {
 public:
  /// `rings` of triangles make each of the ends: several where the surface is bent afterwards.
  StraightEnds(std::unique_ptr<FlowBackend> backend, double length, int rings = 1)
      : WrappedBackend(std::move(backend)), length_(length), rings_(rings) {}
  FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                     const std::filesystem::path& caseFolder) override;

 private:
  double length_;  ///< of each straight end [m]
  int rings_;
};

}  // namespace restenosis
