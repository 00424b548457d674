#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bridge/flow/lbm/LatticeFlow.h"
#include "bridge/flow/lbm/LatticeUnits.h"
#include "bridge/flow/lbm/LbmSettings.h"
#include "bridge/flow/lbm/WallStress.h"

namespace restenosis {

/// Velocity [m/s] and pressure [Pa] at a point.
struct FlowPoint {
  Vec3 velocity = Vec3::Zero();
  double pressure = 0.0;
};

/// A lattice flow that was found to diverge, or not to converge; `what()` says which setting to change.
struct LatticeFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct LatticeDiverged : LatticeFailed {
  using LatticeFailed::LatticeFailed;
};

/// One lattice in a lumen, solved to its steady state.
class SteadyLattice {
 public:
  /// `estimate` must outlive this. Throws std::invalid_argument where no lattice can be made.
  SteadyLattice(const TriSurface& lumen, const FlowConditions& conditions, const LbmSettings& settings,
                const FlowEstimate& estimate, double dx);

  /// Starts from this flow.
  void start(const std::function<FlowPoint(const Vec3&)>& flow);
  /// What to do between checks with the steps done and the estimated relative distance of WSS from its steady
  /// state; returns whether to go on.
  using Watch = std::function<bool(std::int64_t steps, double distance)>;
  /// Advances until WSS is within `tolerance` of its steady state. Throws LatticeFailed.
  void solve(double tolerance, const Watch& watch);

  std::int64_t steps() const { return steps_; }
  std::size_t nodes() const { return lattice_.layout.fluidNodes(); }
  double relaxationTime() const { return relaxation_.tau; }
  const LatticeUnits& units() const { return units_; }
  const LumenLattice& lattice() const { return lattice_; }
  /// Reynolds number of one spacing where the flow is fastest, once it is solved.
  double nodeReynolds() const { return nodeReynolds_; }
  std::size_t bareFaces() const { return stress_.bareFaces(); }

  std::vector<WallFace> wall() const;
  FlowPoint at(std::uint32_t place) const;
  /// Volume per time, by the drive or as found, and what leaves [m^3/s].
  double inflow() const;
  double outflow() const;
  /// From the inlet to the outlet [Pa].
  double pressureDrop() const;

 private:
  /// Volume per time through nodes of a layer [m^3/s], and the mean pressure in them [Pa].
  struct Layer {
    double flowRate, pressure;
  };
  Layer layer(int z) const;
  Layer sumOf(const std::vector<std::uint32_t>& places) const;
  int layers() const { return lattice_.frame.size[2]; }
  /// The nodes of the inlet's cross-section, so many layers further in where these are fluid.
  std::vector<std::uint32_t> behindInlet(int further) const;
  LatticeBoundary boundary(const TriSurface& lumen, const FlowConditions& conditions) const;
  std::int64_t checkInterval() const;
  void advance(std::int64_t pairs);
  /// Gives every node the viscosity of its shear rate.
  void thin();
  [[noreturn]] void diverged() const;

  LbmSettings settings_;
  const FlowEstimate& estimate_;
  LumenLattice lattice_;
  std::vector<d3q19::Step> inletNodes_;  ///< of InletLayer
  LatticeUnits units_;
  LatticeRelaxation relaxation_;
  std::optional<ViscosityLaw> thinning_;  ///< in lattice units
  WallStress stress_;
  std::unique_ptr<LatticeFlowBase> flow_;
  std::optional<double> givenFlow_;
  std::int64_t steps_ = 0;
  double nodeReynolds_ = 0.0;
};

}  // namespace restenosis
