#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "bridge/flow/lbm/LatticeFlow.h"
#include "bridge/flow/lbm/WallStress.h"
#include "tests/support/TubeSurface.h"

namespace restenosis::support {

/// What a solved lattice flow is off from Poiseuille's, relative: velocity in L2 over the nodes; wall shear
/// stress in the area-weighted mean and rms over the faces, then both from the ratio of velocity to wall
/// distance everywhere, the rms from the velocity gradient everywhere and from the nearest node's stress.
struct TubeErrors {
  double velocity, stressMean, stressRms, ratioMean, ratioRms, gradientRms, nearestRms;
};

/// Where each place of a layout is [m].
inline std::vector<Vec3> placePositions(const LumenLattice& lattice) {
  std::vector<Vec3> position(lattice.layout.places(), Vec3::Zero());
  for (const NodeRun& run : lattice.layout.runs())
    for (std::uint32_t n = 0; n < run.count; ++n)
      position[run.first + n] = lattice.frame.position({run.x, run.y, run.z + static_cast<int>(n)});
  return position;
}

/// Poiseuille flow in a tube of `diameter` nodes along the lattice, four layers long, periodic and driven by
/// a force, run from the exact velocity for 5 e-folding times of its slowest mode, and 400 steps.
template <class Real = double>
TubeErrors periodicTube(double diameter, WallRule rule, LatticeRelaxation relaxation, double peak = 0.05) {
  constexpr int layers = 4, sides = 256;
  constexpr double radius = 0.5;
  const double dx = 1.0 / diameter, nu = (relaxation.tau - 0.5) / 3.0, lattices = 0.5 * diameter;
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= layers; ++i) profile.push_back({radius, i * dx});
  const TriSurface surface = revolve(profile, sides);
  const LumenLattice lattice = makeLumenLattice(surface, dx);
  LatticeEnds ends;
  ends.inlet = LatticeEnds::Inlet::periodic;
  relaxation.force = Vec3(0.0, 0.0, 4.0 * nu * peak / (lattices * lattices));
  LatticeFlow<Real> flow(lattice.layout, makeBoundary(lattice, surface.region, rule, ends), relaxation);
  const auto position = placePositions(lattice);
  const auto exact = [&](std::uint32_t place) {
    return peak * (1.0 - position[place].head<2>().squaredNorm() / (radius * radius));
  };
  flow.initialise([&](std::uint32_t place) {
    NodeState s;
    s.velocity.z() = exact(place);
    return s;
  });
  flow.advance(200 + static_cast<int>(2.5 * lattices * lattices / 5.78 / nu));

  TubeErrors e{};
  double norm = 0.0;
  for (const NodeRun& run : lattice.layout.runs())
    for (std::uint32_t place = run.first; place < run.first + run.count; ++place) {
      e.velocity += (flow.state(place).velocity - Vec3(0.0, 0.0, exact(place))).squaredNorm();
      norm += exact(place) * exact(place);
    }
  e.velocity = std::sqrt(e.velocity / norm);
  const double stress = 2.0 * nu * peak / lattices;
  const auto over = [&](StressRule carried, double* mean, double& rms) {
    const WallStress wallStress(surface, lattice, carried, nu);
    double area = 0.0, sum = 0.0, square = 0.0;
    for (const WallFace& f : wallStress.wall(wallStress.nodeValues(flow), 1.0)) {
      const double error = f.traction.norm() / stress - 1.0;
      area += f.area, sum += f.area * error, square += f.area * error * error;
    }
    if (mean != nullptr) *mean = sum / area;
    rms = std::sqrt(square / area);
  };
  over(StressRule::adaptive, &e.stressMean, e.stressRms);
  over(StressRule::ratio, &e.ratioMean, e.ratioRms);
  over(StressRule::gradient, nullptr, e.gradientRms);
  over(StressRule::nearest, nullptr, e.nearestRms);
  return e;
}

/// A straight tube whose axis is turned by `angle` from z towards y, between two planes of constant z [m].
inline TriSurface turnedTube(double radius, double length, double angle, std::uint32_t sides = 256) {
  constexpr int pieces = 40;
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= pieces; ++i) profile.push_back({radius, length * i / pieces});
  TriSurface s = revolve(profile, sides);
  // Circles across the axis become ellipses in the planes of the ends
  for (Vec3& v : s.vertices) v.y() = v.y() / std::cos(angle) + v.z() * std::tan(angle);
  return s;
}

}  // namespace restenosis::support
