#include "bridge/flow/foam/LumenCase.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "bridge/flow/EndClearance.h"
#include "bridge/flow/TubeFlow.h"
#include "bridge/flow/foam/BeatSteps.h"
#include "bridge/flow/foam/CellEstimate.h"
#include "bridge/flow/foam/InsidePoint.h"
#include "bridge/flow/foam/PowersOfW.h"
#include "bridge/flow/foam/WomersleyProfile.h"
#include "tissue/parameters/LengthUnits.h"

namespace restenosis {
namespace {

/// Cells at the wall across the inlet below which there is nothing to mesh. What a lumen should have before
/// the run is FoamSettings::minimumCellsAcross; tissue may narrow it as far as it can be meshed.
constexpr double leastCellsAcross = 2.0;

/// The second attempt (assumed): FoamSettings::nonOrthogonal, what its relaxation is multiplied by, and how
/// many times the iterations of snapping and of the solver it may take.
constexpr double robustNonOrthogonal = 0.5, robustRelaxation = 0.75;
constexpr std::int64_t robustIterations = 2;

/// Most cells of the background block; beyond, its cells are doubled and halved again inside the lumen.
constexpr double blockCells = 1e6;

/// How near to the plane of an end that is cut anything else may come, over the block's cells (assumed):
/// cells with a face in that plane must be the end's own.
constexpr double clearCells = 1.5;

/// How often the cells of a background block around the whole lumen are doubled.
int blockLevel(const LumenCase& lumen, double size) {
  const double cells = (lumen.high - lumen.low).prod() / (size * size * size);
  return std::max(0, static_cast<int>(std::ceil(std::log2(cells / blockCells) / 3.0)));
}

/// Whether the lumen begins along z, and none of it lies below the inlet.
bool beginsAlongZ(const TriSurface& lumen, const EndPlane& inlet) {
  const double slack = 1e-6 * std::sqrt(inlet.area);  // of round-off
  const auto above = [&](const auto& triangle) {
    return std::ranges::all_of(triangle,
                               [&](auto v) { return lumen.vertices[v].z() >= inlet.centre.z() - slack; });
  };
  return inlet.normal.z() < -1 + 1e-9 && std::ranges::all_of(lumen.triangles, above);
}

/// Which ends the planes of the block cut, and its coarsening. A block that cuts both is never much larger
/// than the lumen.
std::pair<LumenEnds, int> endsAndLevel(const TriSurface& lumen, const LumenCase& measured, double size) {
  const int level = blockLevel(measured, size);
  const auto isClear = [&](SurfaceRegion end, double cell) {
    return !strangerNearEnd(lumen, end, clearCells * cell);
  };
  if (liesAlongZ(lumen) && isClear(SurfaceRegion::inlet, size) && isClear(SurfaceRegion::outlet, size))
    return {LumenEnds::cut, 0};
  if (beginsAlongZ(lumen, measured.inlet) && isClear(SurfaceRegion::inlet, size * std::exp2(level)))
    return {LumenEnds::inletCut, level};
  return {LumenEnds::caps, level};
}

/// Cells of the background block from the middle of the lumen to either side, one beyond it.
long halfCells(double low, double high, double size) {
  return static_cast<long>(std::ceil(0.5 * (high - low) / size)) + 1;
}

/// The background block: along the vessel from plane to plane where the ends are cut, elsewhere about the
/// middle of the lumen. Cells of the core have this size.
BackgroundBlock blockAround(const LumenCase& lumen, int level, double coreSize) {
  BackgroundBlock block;
  block.level = level;
  const double size = coreSize * std::exp2(level);
  const Vec3 middle = 0.5 * (lumen.low + lumen.high);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == 2 && lumen.ends != LumenEnds::caps) {
      const double low = lumen.inlet.centre.z();
      const bool both = lumen.ends == LumenEnds::cut;
      block.cells[2] = both ? std::max(1L, std::lround(lumen.length() / size))
                            : static_cast<long>(std::ceil((lumen.high.z() - low) / size)) + 1;
      block.low.z() = low;
      block.high.z() = both ? lumen.outlet.centre.z() : low + size * static_cast<double>(block.cells[2]);
      continue;
    }
    const long half = halfCells(lumen.low[axis], lumen.high[axis], size);
    block.low[axis] = middle[axis] - size * static_cast<double>(half);
    block.high[axis] = middle[axis] + size * static_cast<double>(half);
    block.cells[axis] = 2 * half;
  }
  return block;
}

/// A number that OpenFOAM's expressions use: as text, for of numbers they get ten decimals, whatever their
/// size.
void setInExpression(DictionaryText& parameters, std::string_view key, double value) {
  parameters.set(key, fmt::format("\"{}\"", value));
}

void writeViscosity(DictionaryText& parameters, const std::optional<ViscosityLaw>& law) {
  const bool casson = law && law->kind == ViscosityLaw::Kind::casson;
  parameters.set("viscosityModel", !law ? "Newtonian" : casson ? "Casson" : "BirdCarreau");
  if (!law) return;
  parameters.set("zeroShearViscosity", law->zeroShear);
  parameters.set("infiniteShearViscosity", law->infiniteShear);
  parameters.set("carreauTime", law->time);
  parameters.set("carreauIndex", law->index);
  parameters.set("yieldStress", law->yieldStress);
}

/// What flows, and what drives it.
void writeFlow(DictionaryText& parameters, const LumenCase& lumen, const FlowConditions& conditions) {
  const bool fixedFlow = conditions.drive == FlowConditions::Drive::flowRate;
  parameters.set("kinematicViscosity", conditions.kinematicViscosity);
  writeViscosity(parameters, conditions.thinning);
  parameters.set("density", conditions.density);
  parameters.set("drive", fixedFlow ? "flowRate" : "pressureGradient");
  setInExpression(parameters, "flowRate", conditions.flowRate);
  parameters.set("pressureDrop", conditions.pressureGradient * lumen.length() / conditions.density);
}

/// Where blood thins, the inlet's profile is flatter by as much as in a circle of its area.
void writeInlet(DictionaryText& parameters, const InletProfile& profile, const FlowConditions& conditions) {
  const auto direction = [&](std::string_view key, const Vec3& v) {
    parameters.set(key, fmt::format("\"{}, {}, {}\"", v.x(), v.y(), v.z()));
  };
  direction("inletCentre", profile.centre);
  direction("inletDirection", profile.direction);
  direction("inletXAxis", profile.xAxis);
  direction("inletYAxis", profile.yAxis);
  setInExpression(parameters, "inletRadius", profile.radius);
  parameters.set("inletShape", fmt::format("\"{}\"", profile.expression()));
  double peak = 1;
  std::string thinned = "w";
  if (conditions.thinning && conditions.drive == FlowConditions::Drive::flowRate) {
    peak = profile.peak();
    const auto flow = TubeFlow::ofFlowRate(*conditions.thinning, conditions.flowRate, profile.radius);
    thinned = PowersOfW([&](double share) {
                return flow.velocity(share * profile.radius) / flow.velocity(0);
              }).expression();
  }
  setInExpression(parameters, "inletPeak", peak);
  parameters.set("inletProfile", fmt::format("\"{}\"", thinned));
}

/// Beats after the steady flow, with the inlet of a circle of its area.
void writeBeats(DictionaryText& parameters, double radius, const FlowConditions& conditions,
                const FoamSettings& settings) {
  if (!conditions.beating) return;
  const int beats = conditions.beating->beats;
  const BeatSteps steps(conditions.beating->waveform.period, beats, settings);
  parameters.set("beats", std::to_string(beats));
  parameters.set("beatsEnd", steps.end);
  parameters.set("beatStep", steps.step);
  parameters.set("sampleFrom", steps.sampleFrom);
  parameters.set("sampleSteps", std::to_string(steps.sampleSteps));
  parameters.set("outerCorrectors", std::to_string(settings.beatCorrectors));
  const WomersleyProfile profile = womersleyProfile(conditions, radius);
  for (std::size_t n = 0; n < profile.velocities.size(); ++n)
    parameters.set(fmt::format("womersley{}", n + 1), fmt::format("\"{}\"", profile.velocities[n]));
  parameters.set("womersleyFlow", fmt::format("\"{}\"", profile.flowRate));
}

void writeBlock(DictionaryText& parameters, const LumenCase& lumen) {
  parameters.set("ends", lumen.ends == LumenEnds::cut        ? "cut"
                         : lumen.ends == LumenEnds::inletCut ? "inletCut"
                                                             : "caps");
  for (const auto& [axis, name] : {std::pair{0, 'x'}, {1, 'y'}, {2, 'z'}}) {
    parameters.set(fmt::format("{}Min", name), lumen.block.low[axis]);
    parameters.set(fmt::format("{}Max", name), lumen.block.high[axis]);
    parameters.set(fmt::format("cells{}", static_cast<char>(std::toupper(name))),
                   std::to_string(lumen.block.cells[axis]));
  }
}

/// What the mesher refines, and where the lumen is: elsewhere at the second attempt.
void writeMesh(DictionaryText& parameters, const LumenCase& lumen, const FoamSettings& settings,
               bool robust) {
  const int level = lumen.block.level;
  const Vec3 inside = robust ? lumen.inside.back() : lumen.inside.front();
  parameters.set("insidePoint", fmt::format("({} {} {})", inside.x(), inside.y(), inside.z()));
  parameters.set("struts", lumen.hasStruts() ? "yes" : "no");
  parameters.set("coreLevel", std::to_string(level));
  parameters.set("wallLevel", std::to_string(level + settings.wallLevel));
  parameters.set("strutLevel", std::to_string(level + settings.strutLevel));
  parameters.set("bufferCells", std::to_string(settings.bufferCells));
  parameters.set("meshing", robust ? "thorough" : "quick");
  parameters.set("snapIterations", std::to_string(robust ? robustIterations * settings.snapIterations
                                                         : settings.snapIterations));
  parameters.set("skewFaces", std::to_string(settings.skewFaces));
  parameters.set("skewness", settings.skewness);
}

void writeSolver(DictionaryText& parameters, bool fixedFlow, const FoamSettings& settings, bool robust) {
  const auto iterations = fixedFlow ? settings.iterations : settings.pressureDrivenIterations;
  parameters.set("iterations", std::to_string(robust ? robustIterations * iterations : iterations));
  parameters.set("tolerance", fixedFlow ? settings.tolerance : settings.pressureDrivenTolerance);
  parameters.set("nonOrthogonal", robust ? robustNonOrthogonal : settings.nonOrthogonal);
  parameters.set("relaxation", robust ? robustRelaxation * settings.relaxation : settings.relaxation);
}

}  // namespace

double LumenCase::length() const {
  if (ends == LumenEnds::cut) return outlet.centre.z() - inlet.centre.z();
  return volume / (0.5 * (inlet.area + outlet.area));
}

LumenCase measureLumen(const TriSurface& lumen, const FoamSettings& settings) {
  requireLumenWithPlanarEnds(lumen);
  LumenCase result;
  result.inlet = endPlane(lumen, SurfaceRegion::inlet);
  result.outlet = endPlane(lumen, SurfaceRegion::outlet);
  for (std::size_t n = 1; n < lumen.outletCount(); ++n)
    result.furtherOutlets.push_back(endPlane(lumen, outletRegion(n)));
  result.profile = developedProfile(lumen);
  result.volume = enclosedVolume(lumen);
  result.low = result.high = lumen.vertices[lumen.triangles.front()[0]];
  for (const auto& t : lumen.triangles)
    for (const auto v : t) {
      result.low = result.low.cwiseMin(lumen.vertices[v]);
      result.high = result.high.cwiseMax(lumen.vertices[v]);
    }
  for (std::size_t i = 0; i < lumen.triangles.size(); ++i) {
    if (lumen.region[i] == SurfaceRegion::wall) result.wallArea += lumen.areaVector(i).norm();
    if (lumen.region[i] == SurfaceRegion::strut) result.strutArea += lumen.areaVector(i).norm();
  }

  const double diameter = 2.0 * std::sqrt(result.inlet.area / std::numbers::pi);
  if (diameter < leastCellsAcross * settings.wallCell())
    throw std::invalid_argument(fmt::format(
        "the inlet is {:.4g} mm wide, less than {} cells of {:.4g} mm: the lumen is too small for "
        "this fidelity, or its length unit is wrong",
        diameter * mmPerMetre, leastCellsAcross, settings.wallCell() * mmPerMetre));
  if (const double cells = expectedCells({result.volume, result.wallArea, result.strutArea}, settings);
      cells > settings.maximumCells)
    throw std::invalid_argument(fmt::format(
        "the lumen ({:.4g} mm wide, {:.4g} mm long) needs about {:.2g} cells, more than the limit of "
        "{:.2g}: choose a lower fidelity, or check its length unit",
        diameter * mmPerMetre, result.length() * mmPerMetre, cells, settings.maximumCells));
  int level = 0;
  std::tie(result.ends, level) = endsAndLevel(lumen, result, settings.cellSize);
  result.block = blockAround(result, level, settings.cellSize);
  const auto finest = std::max(settings.wallLevel, settings.strutLevel);
  result.inside = insidePoints(lumen, result.block, level, level + static_cast<int>(finest));
  return result;
}

void writeLumenParameters(DictionaryText& parameters, const LumenCase& lumen,
                          const FlowConditions& conditions, const FoamSettings& settings, Effort effort,
                          int ranks) {
  const bool robust = effort == Effort::robust;
  writeFlow(parameters, lumen, conditions);
  writeInlet(parameters, lumen.profile, conditions);
  writeBeats(parameters, lumen.profile.radius, conditions, settings);
  writeBlock(parameters, lumen);
  writeMesh(parameters, lumen, settings, robust);
  writeSolver(parameters, conditions.drive == FlowConditions::Drive::flowRate, settings, robust);
  parameters.set("ranks", std::to_string(ranks));
}

}  // namespace restenosis
