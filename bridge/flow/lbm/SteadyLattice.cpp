#include "bridge/flow/lbm/SteadyLattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bridge/flow/LumenShape.h"
#include "bridge/flow/TubeFlow.h"
#include "bridge/flow/lbm/DevelopedInlet.h"
#include "bridge/flow/lbm/InletLayer.h"
#include "bridge/flow/lbm/SteadyState.h"

namespace restenosis {
namespace {

/// Faces whose stress is followed while the flow settles, at most.
constexpr std::size_t mostSamples = 4000;
/// Lattice velocity beyond which a flow cannot be right any more.
constexpr double runawayVelocity = 1.0;
/// Checks in the time in which the flow settles: that of the mean flow through the lumen or across it, or
/// that of diffusion across it where it is shorter.
constexpr double checksPerPassage = 20.0;
/// Pairs of steps from one change of the viscosity of blood that thins to the next (assumed).
constexpr std::int64_t pairsPerViscosity = 10;

std::optional<ViscosityLaw> inUnits(const std::optional<ViscosityLaw>& law, const LatticeUnits& units) {
  if (!law) return {};
  return law->in(units.dx, units.dt);
}

}  // namespace

SteadyLattice::SteadyLattice(const TriSurface& lumen, const FlowConditions& conditions,
                             const LbmSettings& settings, const FlowEstimate& estimate, double dx)
    : settings_(settings),
      estimate_(estimate),
      lattice_(makeLumenLattice(lumen, dx, settings.maximumNodes)),
      units_(latticeUnits(lattice_.frame.dx, estimate_, conditions, settings.latticeVelocity)),
      thinning_(inUnits(conditions.thinning, units_)),
      stress_(lumen, lattice_, settings.stressRule(),
              (units_.relaxationTime(conditions.kinematicViscosity) - 0.5) / 3.0, thinning_) {
  relaxation_.tau = units_.relaxationTime(conditions.kinematicViscosity);
  relaxation_.magic = settings.magic;
  relaxation_.single = settings.singleRelaxation();
  if (conditions.drive == FlowConditions::Drive::flowRate) givenFlow_ = conditions.flowRate;
  const InletLayer inlet(lattice_, lumen.region);
  for (int x = 0; x < lattice_.frame.size[0]; ++x)
    for (int y = 0; y < lattice_.frame.size[1]; ++y)
      if (inlet.contains(x, y)) inletNodes_.push_back({x, y, inlet.layer()});
  LatticeBoundary surface = boundary(lumen, conditions);
  if (settings.singlePrecision())
    flow_ = std::make_unique<LatticeFlow<float>>(lattice_.layout, std::move(surface), relaxation_);
  else
    flow_ = std::make_unique<LatticeFlow<double>>(lattice_.layout, std::move(surface), relaxation_);
}

LatticeBoundary SteadyLattice::boundary(const TriSurface& lumen, const FlowConditions& conditions) const {
  const WallRule rule = settings_.wallRule();
  LatticeEnds ends;
  const EndPlane outlet = endPlane(lumen, SurfaceRegion::outlet);
  const double gradient = developedGradient(conditions, estimate_.flowRate(), outlet.area);
  ends.outletGradient = -3.0 * gradient * units_.dx / units_.pressure() * outlet.normal;
  if (conditions.drive == FlowConditions::Drive::pressureGradient) {
    ends.inlet = LatticeEnds::Inlet::pressure;
    ends.inletDensity = 3.0 * conditions.pressureGradient * estimate_.length() / units_.pressure();
    return makeBoundary(lattice_, lumen.region, rule, ends);
  }
  const double flowRate = conditions.flowRate / units_.flowRate();
  const DevelopedInlet developed(lattice_, lumen.region, rule, relaxation_, flowRate, thinning_);
  ends.source = [&](const d3q19::Step& node, int direction) { return developed.source(node, direction); };
  LatticeBoundary result = makeBoundary(lattice_, lumen.region, rule, ends);
  result.expectedOutflow = flowRate;
  if (!lattice_.frame.alongZ) result.outletArea = outlet.area / (units_.dx * units_.dx);
  return result;
}

FlowPoint SteadyLattice::at(std::uint32_t place) const {
  const NodeState s = flow_->state(place);
  return {units_.velocity() * s.velocity, units_.pressure() / 3.0 * s.density};
}

void SteadyLattice::start(const std::function<FlowPoint(const Vec3&)>& flow) {
  // Runs are sorted by place, so the run of a place is the last that begins at or before it
  const auto& runs = lattice_.layout.runs();
  flow_->initialise([&](std::uint32_t place) {
    const auto after = std::upper_bound(runs.begin(), runs.end(), place,
                                        [](std::uint32_t p, const NodeRun& run) { return p < run.first; });
    const NodeRun& run = *(after - 1);
    const FlowPoint point =
        flow(lattice_.frame.position({run.x, run.y, run.z + static_cast<int>(place - run.first)}));
    NodeState state;
    state.velocity = point.velocity / units_.velocity();
    state.density = 3.0 * point.pressure / units_.pressure();
    return state;
  });
}

std::int64_t SteadyLattice::checkInterval() const {
  const double mean = 0.5 * estimate_.peakVelocity() / units_.velocity();
  const double length =
      lattice_.frame.alongZ ? static_cast<double>(layers()) : estimate_.length() / units_.dx;
  const double across = std::sqrt(static_cast<double>(nodes()) / length);
  const double passage = std::max(length, across) / mean;
  const double diffusion = 0.75 * across * across / (relaxation_.tau - 0.5);  // radius squared over viscosity
  // Where blood thins and its flow rate is not given, velocity and viscosity settle together, and late
  const double time = thinning_ && !givenFlow_ ? std::max(passage, diffusion) : std::min(passage, diffusion);
  return std::max<std::int64_t>(10, 2 * std::llround(0.5 * time / checksPerPassage));
}

void SteadyLattice::diverged() const {
  throw LatticeDiverged(
      fmt::format("the lattice flow diverged after {} steps, with the relaxation time {:.4f} and {:.3g} "
                  "spacings a step at most: "
                  "choose a smaller dx in [lbm] (it is {:.4g} um), {}; where the lumen is rough, wall = "
                  "\"bounceBack\" bears more",
                  steps_, relaxation_.tau, estimate_.peakVelocity() / units_.velocity(), 1e6 * units_.dx,
                  relaxation_.single ? "or collision = \"trt\"" : "or another latticeVelocity"));
}

void SteadyLattice::advance(std::int64_t pairs) {
  const std::int64_t together = thinning_ ? pairsPerViscosity : pairs;
  for (std::int64_t done = 0; done < pairs; done += together) {
    if (thinning_) thin();
    flow_->advance(static_cast<int>(std::min(together, pairs - done)));
  }
}

void SteadyLattice::thin() {
  flow_->setViscosity([this](std::uint32_t place) {
    const auto stress = flow_->state(place).stress;
    double square = 0.0;
    for (std::size_t k = 0; k < stress.size(); ++k) square += (k < 3 ? 1.0 : 2.0) * stress[k] * stress[k];
    // Twice the viscosity times the rate of strain, whose norm is the shear rate over the root of 2
    return (*thinning_)(std::sqrt(0.5 * square) / flow_->viscosity(place));
  });
}

void SteadyLattice::solve(double tolerance, const Watch& watch) {
  const std::size_t stride = std::max<std::size_t>(1, (stress_.faces() + mostSamples - 1) / mostSamples);
  SteadyState steady;
  const std::int64_t interval = checkInterval();
  double distance = steady.distance();
  for (;;) {
    // Samples must lie equally far apart, so none is taken of the rest
    if (steps_ + interval > settings_.maximumSteps)
      throw LatticeFailed(fmt::format(
          "the wall shear stress did not settle within {} steps: {}, and tolerance is {:.2g}; raise "
          "maximumSteps or tolerance in [lbm]",
          settings_.maximumSteps,
          std::isfinite(distance)
              ? fmt::format("it is estimated to be {:.2g} from its steady state", distance)
              : "too few to estimate how far it is from its steady state",
          tolerance));
    advance(interval / 2);
    steps_ += interval;
    const auto values = stress_.nodeValues(*flow_);
    std::vector<double> sample;
    for (std::size_t f = 0; f < stress_.faces(); f += stride) {
      const Vec3 t = stress_.traction(f, values, 1.0);
      if (!(t.squaredNorm() < runawayVelocity)) diverged();
      sample.insert(sample.end(), {t.x(), t.y(), t.z()});
    }
    steady.add(std::move(sample));
    distance = steady.distance();
    if (!watch(steps_, distance)) return;
    if (distance < tolerance) break;
  }
  double fastest = 0.0;
  for (const NodeRun& run : lattice_.layout.runs())
    for (std::uint32_t n = 0; n < run.count; ++n) {
      const double square = flow_->state(run.first + n).velocity.squaredNorm();
      if (!(square < runawayVelocity)) diverged();
      fastest = std::max(fastest, square);
    }
  nodeReynolds_ = 3.0 * std::sqrt(fastest) / (relaxation_.tau - 0.5);
}

std::vector<WallFace> SteadyLattice::wall() const {
  return stress_.wall(stress_.nodeValues(*flow_), units_.pressure());
}

SteadyLattice::Layer SteadyLattice::sumOf(const std::vector<std::uint32_t>& places) const {
  double flow = 0.0, pressure = 0.0;
  for (const std::uint32_t place : places) {
    const NodeState s = flow_->state(place);
    flow += s.velocity.z();
    pressure += s.density;
  }
  const auto nodes = static_cast<double>(places.size());
  return {flow * units_.flowRate(), pressure / (3.0 * nodes) * units_.pressure()};
}

SteadyLattice::Layer SteadyLattice::layer(int z) const {
  std::vector<std::uint32_t> places;
  for (const NodeRun& run : lattice_.layout.runs())
    if (z >= run.z && z < run.z + static_cast<int>(run.count))
      places.push_back(run.first + static_cast<std::uint32_t>(z - run.z));
  return sumOf(places);
}

std::vector<std::uint32_t> SteadyLattice::behindInlet(int further) const {
  std::vector<std::uint32_t> places;
  for (const d3q19::Step& node : inletNodes_)
    if (lattice_.isFluid({node[0], node[1], node[2] + further}))
      places.push_back(lattice_.layout.place(node[0], node[1], node[2] + further));
  return places;
}

double SteadyLattice::inflow() const { return givenFlow_ ? *givenFlow_ : sumOf(behindInlet(0)).flowRate; }

double SteadyLattice::outflow() const {
  if (lattice_.frame.alongZ) return layer(layers() - 1).flowRate;
  return flow_->openOutflow() * units_.flowRate();
}

double SteadyLattice::pressureDrop() const {
  // From the middle of the first and last layers to the planes of the ends, half a spacing further out
  const auto atPlane = [](double end, double inner) { return end + 0.5 * (end - inner); };
  if (!lattice_.frame.alongZ) {
    const auto inner = behindInlet(1);
    const double first = sumOf(behindInlet(0)).pressure;
    return inner.empty() ? first : atPlane(first, sumOf(inner).pressure);
  }
  const int last = layers() - 1;
  return atPlane(layer(0).pressure, layer(std::min(1, last)).pressure) -
         atPlane(layer(last).pressure, layer(std::max(0, last - 1)).pressure);
}

}  // namespace restenosis
