#include "bridge/flow/lbm/LbmBackend.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/flow/LumenShape.h"
#include "bridge/flow/LumenWidth.h"
#include "bridge/flow/lbm/LatticeSampler.h"
#include "bridge/flow/lbm/SteadyLattice.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {
namespace {

/// A coarse lattice only gives a start, so it need not settle as far.
constexpr double coarseTolerance = 10.0;
/// Spacings across the inlet below which nothing can be solved. What a lumen should have before the run is
/// LbmSettings::leastNodesAcross; tissue may narrow it further.
constexpr double fewestSpacings = 2.0;
/// Fewest spacings across the lumen without a remark (docs/model/flow.md).
constexpr double fewestWithoutRemark = 6.0;
/// How often the spacing is halved where the lumen has become too narrow for it, if the lattice has no more
/// nodes than these then. Assumed: a lumen of less than two spacings of the finest is all but closed, and a
/// wide one that is narrow in one place is not to take hours without having been asked for.
constexpr int mostHalvings = 3;
constexpr double mostNodesOfHalved = 1e6;
/// Nodes across the inlet below which a coarser lattice is of no use.
constexpr double fewestNodesAcross = 16.0;
/// How often the time step is halved after a flow that diverges (assumed).
constexpr int mostShorterSteps = 4;
/// Of a case, the flow that the next one may start from.
constexpr const char* fieldFile = "lattice.vti";
/// Difference of inflow and outflow above which the solution is refused, and above which it is remarked on.
constexpr double massLimit = 0.05, massRemark = 0.01;
/// Reynolds number of one spacing (assumed: both methods agree at 2, and at 50 jets are wrong).
constexpr double nodeReynoldsRemark = 10.0;

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

class Log {
 public:
  explicit Log(const std::filesystem::path& folder) {
    if (folder.empty()) return;
    removeIfLink(folder);
    std::filesystem::create_directories(folder);
    file_ = folder / "log.lbm";
    removeIfLink(file_);
    stream_.open(file_);
  }
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    if (stream_.is_open()) {
      fmt::print(stream_, text, std::forward<Arguments>(arguments)...);
      stream_ << std::endl;
    }
  }
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
};

/// Spacings from the coarsest lattice to the finest.
std::vector<double> spacings(const TriSurface& lumen, const LbmSettings& settings) {
  if (!(settings.dx > 0.0) || !std::isfinite(settings.dx))
    throw std::invalid_argument(
        fmt::format("dx in [lbm] is {} m; it must be a positive length", settings.dx));
  const double across = 2.0 * std::sqrt(endPlane(lumen, SurfaceRegion::inlet).area / std::numbers::pi);
  if (across < fewestSpacings * settings.dx)
    throw std::invalid_argument(
        fmt::format("the inlet is {:.4g} mm wide, less than {} spacings of {:.4g} um: choose a smaller dx in "
                    "[lbm], or check "
                    "the lumen's length unit",
                    1e3 * across, fewestSpacings, 1e6 * settings.dx));
  std::vector<double> result{settings.dx};
  for (std::int64_t level = 1; level <= settings.coarseLevels; ++level) {
    if (across < fewestNodesAcross * 2.0 * result.front()) break;
    result.insert(result.begin(), 2.0 * result.front());
  }
  return result;
}

/// Throws std::invalid_argument unless blood flows with these numbers.
void requireFlow(const FlowConditions& conditions) {
  const auto positive = [](double value, const char* what, const char* unit) {
    if (!(value > 0.0) || !std::isfinite(value))
      throw std::invalid_argument(
          fmt::format("the {} is {} {}; it must be a positive number", what, value, unit));
  };
  positive(conditions.density, "density", "kg/m^3");
  positive(conditions.kinematicViscosity, "kinematic viscosity", "m^2/s");
  if (conditions.drive == FlowConditions::Drive::flowRate)
    positive(conditions.flowRate, "flow rate", "m^3/s");
  else
    positive(conditions.pressureGradient, "pressure gradient", "Pa/m");
}

/// Solves on one lattice after the other, each from the flow of the one before.
class LevelSolver {
 public:
  /// Adds times and steps to `solution`. `former`: the flow in a lumen like this one, or null.
  LevelSolver(const TriSurface& lumen, const FlowConditions& conditions, const LbmSettings& settings,
              const LatticeSampler* former, const std::atomic<bool>* stopRequested, Log& log,
              FlowSolution& solution)
      : lumen_(lumen),
        conditions_(conditions),
        settings_(settings),
        former_(former),
        stopRequested_(stopRequested),
        log_(log),
        solution_(solution),
        estimate_(lumen, conditions),
        latticeVelocity_(settings.latticeVelocity) {}
  LevelSolver(const LevelSolver&) = delete;
  LevelSolver& operator=(const LevelSolver&) = delete;

  /// The finest lattice, solved.
  std::unique_ptr<SteadyLattice> solve() {
    if (former_ != nullptr) {
      try {
        log_.line("from the former flow");
        start_ = std::cref(*former_);
        auto lattice = solveSlowly(settings_.dx, settings_.tolerance);
        if (stopped()) throw LatticeFailed("stopped on request");
        return lattice;
      } catch (const LatticeFailed& error) {
        if (stopped()) throw;
        log_.line("  {}; once more from Poiseuille's flow", error.what());
      }
    }
    return solveByLevels();
  }

 private:
  /// From Poiseuille's flow on the coarsest lattice, and so on. Coarser ones that fail are left out.
  std::unique_ptr<SteadyLattice> solveByLevels() {
    latticeVelocity_ = settings_.latticeVelocity;
    start_ = [this](const Vec3& p) {
      return FlowPoint{Vec3(0.0, 0.0, estimate_.velocity(p)), estimate_.pressure(p)};
    };
    const auto levels = spacings(lumen_, settings_);
    for (const double dx : levels) {
      const bool finest = dx == levels.back();
      std::unique_ptr<SteadyLattice> lattice;
      try {
        lattice = solveSlowly(dx, finest ? settings_.tolerance : coarseTolerance * settings_.tolerance);
      } catch (const std::exception& error) {
        if (finest) throw;
        log_.line("  left out: {}", error.what());
        latticeVelocity_ =
            settings_.latticeVelocity;  // what a lattice that is too coarse lacks is no shorter step
        continue;
      }
      if (stopped()) throw LatticeFailed("stopped on request");
      if (finest) return lattice;
      coarser_ = std::make_unique<LatticeSampler>(latticeField(*lattice));
      start_ = [this](const Vec3& p) { return (*coarser_)(p); };
    }
    throw std::logic_error("no lattice to solve on");
  }

  bool stopped() const { return stopRequested_ && *stopRequested_; }

  /// Once more with shorter time steps where the flow diverges: it may be faster somewhere than is known.
  std::unique_ptr<SteadyLattice> solveSlowly(double dx, double tolerance) {
    for (int shorter = 0;; ++shorter) {
      try {
        return solveOn(dx, tolerance);
      } catch (const LatticeDiverged& error) {
        if (shorter == mostShorterSteps) throw;
        log_.line("  {}; once more with half the time step", error.what());
        latticeVelocity_ = 0.5 * velocityUsed_;
      }
    }
  }

  std::unique_ptr<SteadyLattice> solveOn(double dx, double tolerance) {
    auto began = Clock::now();
    LbmSettings settings = settings_;
    // A coarser lattice's stress only tells when its flow has settled
    if (dx > settings.dx) settings.stress = "nearest";
    settings.latticeVelocity = latticeVelocity_;
    auto lattice = std::make_unique<SteadyLattice>(lumen_, conditions_, settings, estimate_, dx);
    velocityUsed_ = estimate_.peakVelocity() / lattice->units().velocity();
    lattice->start(start_);
    solution_.meshSeconds += secondsSince(began);
    log_.line("spacing {:.4g} um: {} nodes, relaxation time {:.4f}, time step {:.4g} s",
              1e6 * lattice->units().dx, lattice->nodes(), lattice->relaxationTime(), lattice->units().dt);
    began = Clock::now();
    lattice->solve(tolerance, [&](std::int64_t steps, double distance) {
      if (std::isfinite(distance))
        log_.line("  {} steps, wall shear stress within {:.3g} of its steady state", steps, distance);
      return !stopped();
    });
    solution_.solveSeconds += secondsSince(began);
    solution_.iterations += static_cast<int>(lattice->steps());
    return lattice;
  }

  const TriSurface& lumen_;
  const FlowConditions& conditions_;
  const LbmSettings& settings_;
  const LatticeSampler* former_;
  const std::atomic<bool>* stopRequested_;
  Log& log_;
  FlowSolution& solution_;
  FlowEstimate estimate_;
  double latticeVelocity_;     ///< LbmSettings::latticeVelocity, or less after a flow that has diverged
  double velocityUsed_ = 0.0;  ///< on the last lattice; less where viscosity sets the time step
  std::unique_ptr<LatticeSampler> coarser_;
  std::function<FlowPoint(const Vec3&)> start_;
};

/// Takes wall, flow and pressure drop from a solved lattice.
void take(FlowSolution& solution, const SteadyLattice& solved) {
  solution.cells = solved.nodes();
  solution.flowRate = solved.inflow();
  solution.wall = solved.wall();
  solution.massImbalance = std::abs(solved.outflow() / solved.inflow() - 1.0);
  solution.pressureDrop = solved.pressureDrop();
}

/// Throws LatticeFailed where too much mass is lost, and remarks on what is not as it should be.
void judge(FlowSolution& solution, const SteadyLattice& solved) {
  if (!(solution.massImbalance < massLimit))
    throw LatticeFailed(fmt::format("outflow and inflow differ by {:.2g} %: choose a smaller dx in [lbm]",
                                    100.0 * solution.massImbalance));
  if (solution.massImbalance > massRemark)
    solution.remarks.push_back(
        fmt::format("outflow and inflow differ by {:.2g} %", 100.0 * solution.massImbalance));
  if (solved.nodeReynolds() > nodeReynoldsRemark)
    solution.remarks.push_back(fmt::format(
        "the Reynolds number of one spacing is up to {:.2g}: a jet may get lobes along the axes of "
        "the lattice; a smaller lbm.dx makes it smaller, and OpenFOAM has no such error",
        solved.nodeReynolds()));
  if (solved.bareFaces() > 0)
    solution.remarks.push_back(fmt::format(
        "{} faces of the wall have no lattice node near them, and no stress", solved.bareFaces()));
}

}  // namespace

std::string_view LbmBackend::name() const { return flowBackendNames::lbm; }

void LbmBackend::startFrom(const std::filesystem::path& formerCase) { former_ = formerCase; }

bool LbmBackend::needsFormerCase() const { return settings_.warmStart; }

std::vector<std::filesystem::path> LbmBackend::filesToStartFrom(
    const std::filesystem::path& formerCase) const {
  if (!std::filesystem::is_regular_file(formerCase / fieldFile))
    throw std::runtime_error(fmt::format("there is no {}", fieldFile));
  return {fieldFile};
}

std::vector<Vec3> LbmBackend::velocities(const std::vector<Vec3>& points) const {
  if (!kept_) return {};
  std::vector<Vec3> result;
  for (const Vec3& p : points) result.push_back((*kept_)(p).velocity);
  return result;
}

FlowSolution LbmBackend::solve(const TriSurface& lumen, const FlowConditions& conditions,
                               const std::filesystem::path& caseFolder) {
  Log log(caseFolder);
  std::string narrow;
  try {
    requireFlow(conditions);
    requireLatticeLumen(lumen);
    narrow = narrownessRemark(lumen, {settings_.dx, "spacings", fewestWithoutRemark,
                                      "a finer scene.fidelity or a smaller lbm.dx resolves it"});
    FlowSolution solution;
    LbmSettings settings = settings_;
    std::string refused;
    std::optional<LatticeSampler> former;
    if (settings_.warmStart && !former_.empty()) {
      const auto file = former_ / fieldFile;
      try {
        former.emplace(readLatticeField(file));
      } catch (const std::runtime_error& error) {
        log.line("{} {}", file.string(), error.what());
      }
    }
    for (int halvings = 0;; ++halvings, settings.dx /= 2) {
      try {
        const auto solved = LevelSolver(lumen, conditions, settings, former ? &*former : nullptr,
                                        stopRequested_, log, solution)
                                .solve();
        take(solution, *solved);
        log.line("mass imbalance {:.3g}, pressure drop {:.5g} Pa", solution.massImbalance,
                 solution.pressureDrop);
        judge(solution, *solved);
        LatticeField field = latticeField(*solved);
        if (!caseFolder.empty()) writeLatticeField(caseFolder / fieldFile, field);
        if (keepVelocities_) kept_ = std::make_shared<LatticeSampler>(std::move(field));
        break;
      } catch (const std::exception& error) {
        // What a finer lattice says of its own is of less use than what is wrong with that of the settings.
        if (refused.empty()) refused = error.what();
        if (stopRequested_ && *stopRequested_) throw;
        const double finerNodes = enclosedVolume(lumen) / std::pow(settings.dx / 2, 3);
        if (narrow.empty() || halvings == mostHalvings || !(finerNodes <= mostNodesOfHalved))
          throw std::runtime_error(refused);
        log.line("  refused: {}; once more with half the spacing", error.what());
        solution.remarks.clear();
      }
    }
    if (!refused.empty()) {
      solution.remarks.push_back(
          fmt::format("solved with spacings of {:.4g} um, for with {:.4g} um, lbm.dx, it was refused: {}",
                      1e6 * settings.dx, 1e6 * settings_.dx, refused));
    }
    if (!narrow.empty()) solution.remarks.push_back(narrow);
    return solution;
  } catch (const std::exception& error) {
    log.line("failed: {}", error.what());
    throw FlowFailed(
        fmt::format("lattice Boltzmann flow: {}{}{}", error.what(), narrow.empty() ? "" : "; ", narrow),
        log.file());
  }
}

}  // namespace restenosis
