#include "bridge/flow/foam/FoamRun.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "bridge/flow/foam/FoamLog.h"
#include "bridge/flow/foam/MeshMorph.h"
#include "bridge/flow/foam/OGrid.h"
#include "bridge/flow/foam/WallPatch.h"
#include "bridge/surface/StlFile.h"
#include "bridge/system/AtomicFile.h"
#include "tissue/parameters/LengthUnits.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {
constexpr double cubicMillimetre = mm * mm * mm, squareMillimetre = mm * mm;

/// Part of the wall's cells along an end's rim that snapping may leave out of the end: it makes the rim a
/// polygon, and cuts off corners (assumed).
constexpr double cornersCut = 0.5;

/// Struts of which the lumen shows no more than so many faces of cells may be missing in the mesh: tissue has
/// covered them (assumed).
constexpr double mostFacesOfLostStruts = 100;

/// Mean thickness of an O-grid's layers over the length of its cells (assumed).
constexpr double layerOverCell = 0.7;

/// Cells as long and as wide as the core's of another mesh, and layers over the half of the radius that the
/// square core leaves.
OGridSize oGridSize(const LumenCase& lumen, const FoamSettings& settings) {
  const double cell = settings.cellSize, length = lumen.length();
  const double radius = std::sqrt(lumen.volume / (std::numbers::pi * length));
  const auto count = [](double distance, double size) {
    return std::max(1, static_cast<int>(std::lround(distance / size)));
  };
  return {.around = 4 * count(0.5 * std::numbers::pi * radius, cell),
          .layers = count(0.5 * radius, layerOverCell * cell),
          .along = count(length, cell)};
}
}  // namespace

FoamRun::FoamRun(fs::path folder, const LumenCase& lumen, const FlowConditions& conditions,
                 const FoamSettings& settings, const FoamExecution& execution)
    : folder_(std::move(folder)),
      lumen_(lumen),
      conditions_(conditions),
      settings_(settings),
      execution_(execution),
      steps_(folder_, execution) {}

void FoamRun::run(const std::string& program, const std::vector<std::string>& arguments, FoamSteps::On on) {
  (program == "simpleFoam" ? solution_.solveSeconds : solution_.meshSeconds) +=
      steps_.run(program, arguments, on);
}

void FoamRun::mesh() {
  run("blockMesh", {}, FoamSteps::On::oneProcess);
  if (execution_.parallel()) run("decomposePar", {}, FoamSteps::On::oneProcess);
  run("snappyHexMesh", {"-overwrite"}, FoamSteps::On::allRanks);
  if (const auto problem = foamLog::meshingProblem(foamLog::read(steps_.log("snappyHexMesh"))))
    steps_.fail("snappyHexMesh", *problem);
  checkPatches();
  checkMesh();
}

double FoamRun::checkMesh() {
  run("checkMesh", {}, FoamSteps::On::allRanks);
  const auto report = foamLog::meshReport(foamLog::read(steps_.log("checkMesh")));
  const double volume = report.volume;
  if (!(std::abs(volume - lumen_.volume) <= settings_.volumeTolerance * lumen_.volume))
    steps_.fail(
        "checkMesh",
        fmt::format(
            "the mesh's volume of {:.5g} mm^3 is not the surface's of {:.5g} mm^3: part of the lumen is "
            "cut off, the surface leaks, or the cells are too large for so narrow a lumen",
            volume / cubicMillimetre, lumen_.volume / cubicMillimetre));
  // A few skew faces cost accuracy beside them alone; whether the solution suffered is checked after it.
  const bool fewSkewFaces = report.skewFaces > 0 &&
                            report.skewFaces <= static_cast<std::size_t>(settings_.skewFaces) &&
                            report.skewness <= settings_.skewness;
  if (fewSkewFaces) {
    solution_.remarks.push_back(fmt::format("the mesh has highly skew faces: {}, of a skewness up to {:.3g}",
                                            report.skewFaces, report.skewness));
  } else if (!report.ok) {
    steps_.fail("checkMesh", report.problem);
  }
  checkEnds();
  solution_.cells = report.cells;
  return report.nonOrthogonality;
}

void FoamRun::checkEnds() {
  std::vector<PolyMesh> meshes;
  for (const auto& part : steps_.parts()) meshes.push_back(readPolyMesh(part));
  std::vector<std::pair<std::string_view, const EndPlane*>> ends{{"inlet", &lumen_.inlet},
                                                                 {"outlet", &lumen_.outlet}};
  for (std::size_t n = 0; n < lumen_.furtherOutlets.size(); ++n)
    ends.emplace_back(regionName(outletRegion(n + 1)), &lumen_.furtherOutlets[n]);
  for (const auto& [name, end] : ends) {
    double area = 0.0;
    for (const PolyMesh& mesh : meshes) area += mesh.patchArea(name);
    const double cutCorners = cornersCut * settings_.wallCell() * end->perimeter;
    const double tolerance = settings_.endAreaTolerance * end->area;
    if (area > end->area + tolerance || !(area >= end->area - tolerance - cutCorners))
      steps_.fail(
          "checkMesh",
          fmt::format("the mesh's {} of {:.4g} mm^2 is not the surface's of {:.4g} mm^2: cells of another "
                      "part of the lumen were taken for it, or its own for the wall",
                      name, area / squareMillimetre, end->area / squareMillimetre));
  }
}

std::vector<Vec3> FoamRun::morph(const PolyMesh& former, const fs::path& formerCase,
                                 const TriSurface& surface) {
  const auto begin = std::chrono::steady_clock::now();
  if (lumen_.ends != LumenEnds::cut)
    throw MeshRefused("the lumen does not lie along z", "the mesh's ends cannot be kept in their planes");
  const auto* strut = former.patch("strut");
  meshHasStruts_ = strut != nullptr && strut->faces > 0;
  if (meshHasStruts_ != lumen_.hasStruts())
    throw MeshRefused("struts have been covered or laid bare altogether", "the mesh's patches do not fit");
  PolyMesh mesh = former;
  try {
    MeshMorph moved = morphOnto(former, surface);
    const double cell = settings_.wallCell();
    const auto require = [&](double distance, double limit, const char* reason) {
      if (!(distance <= limit * cell))
        throw MeshRefused(reason,
                          fmt::format("{:.3g} um, more than {:.3g} um", distance / um, limit * cell / um));
    };
    require(moved.movement, settings_.morphMovement, "the wall moved too far");
    require(moved.departure, settings_.morphDeparture, "the moved mesh does not follow the lumen");
    mesh.points = std::move(moved.points);
    copyPolyMesh(formerCase, folder_, mesh.points);
  } catch (const MeshRefused&) {
    throw;
  } catch (const WriteFailed&) {  // a new mesh would need more room
    throw;
  } catch (const std::exception& error) {
    throw MeshRefused("the mesh could not be moved", error.what());
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  solution_.meshSeconds += seconds.count();
  if (execution_.parallel()) run("decomposePar", {}, FoamSteps::On::oneProcess);
  if (const double angle = checkMesh(); !(angle <= settings_.morphNonOrthogonality))
    throw MeshRefused(
        "the moved mesh is too non-orthogonal",
        fmt::format("{:.3g} degrees, more than {:.3g}", angle, settings_.morphNonOrthogonality));
  solution_.meshMoved = true;
  return mesh.cellCentres();
}

void FoamRun::layOGrid(const TriSurface& surface) {
  const auto begin = std::chrono::steady_clock::now();
  if (lumen_.ends != LumenEnds::cut)
    throw MeshRefused("the lumen does not lie along z", "an O-grid's ends are planes of constant z");
  if (lumen_.hasStruts()) throw MeshRefused("struts are in view", "an O-grid makes ramps of their sides");
  try {
    writePolyMesh(folder_, oGrid(surface, oGridSize(lumen_, settings_)));
  } catch (const std::invalid_argument& error) {
    throw MeshRefused("an O-grid does not fit the lumen", error.what());
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  solution_.meshSeconds += seconds.count();
  if (execution_.parallel()) run("decomposePar", {}, FoamSteps::On::oneProcess);
  checkMesh();
}

void FoamRun::checkPatches() {
  std::map<std::string, std::size_t> faces;
  for (const auto& part : steps_.parts())
    for (const auto& [patch, count] : foamLog::patchFaces(foamLog::read(part / "constant/polyMesh/boundary")))
      faces[patch] += count;
  if (faces["sides"] > 0)
    steps_.fail(
        "snappyHexMesh",
        fmt::format("the lumen surface leaks: {} faces of the mesh lie outside of it", faces["sides"]));
  if (faces["outlet"] == 0 || faces["inlet"] == 0)
    throw FlowFailed(
        fmt::format("snappyHexMesh: the mesh does not reach the {}: the lumen is closed (occluded) "
                    "(see {})",
                    faces["outlet"] == 0 ? "outlet" : "inlet", steps_.log("snappyHexMesh").string()),
        steps_.log("snappyHexMesh"));
  for (std::size_t n = 1; n <= lumen_.furtherOutlets.size(); ++n)
    if (const std::string name(regionName(outletRegion(n))); faces[name] == 0)
      throw FlowFailed(
          fmt::format("snappyHexMesh: the mesh does not reach the outlet '{}': its branch is closed, or "
                      "too narrow for these cells (see {})",
                      conditions_.outlets[n].name, steps_.log("snappyHexMesh").string()),
          steps_.log("snappyHexMesh"));
  if (faces["wall"] == 0) steps_.fail("snappyHexMesh", "the mesh has no faces on the wall");
  meshHasStruts_ = faces["strut"] > 0;
  if (!lumen_.hasStruts() || meshHasStruts_) return;
  const double seen = lumen_.strutArea / (settings_.strutCell() * settings_.strutCell());
  if (seen > mostFacesOfLostStruts)
    steps_.fail(
        "snappyHexMesh",
        "the mesh has no faces on the struts: its cells are too large for what is left of them in the lumen; "
        "choose a finer scene.fidelity, or a higher strutLevel in [foam]");
  solution_.remarks.push_back(
      fmt::format("tissue covers the struts but for {:.3g} um^2, less than the mesh can show: taken for wall",
                  1e12 * lumen_.strutArea));
}

void FoamRun::solve(const FoamStart* start) {
  fs::remove_all(folder_ / "postProcessing");
  for (const auto& part : steps_.parts()) {
    fs::remove_all(part / "0");
    fs::copy(folder_ / "0.orig", part / "0", fs::copy_options::recursive);
    if (start != nullptr) start->write(part);
  }
  run("simpleFoam", {}, FoamSteps::On::allRanks);
  const auto iterations = foamLog::convergedAfter(foamLog::read(steps_.log("simpleFoam")));
  if (!iterations) steps_.fail("simpleFoam", "the solution has not converged within the iterations allowed");
  solution_.iterations = *iterations;
  checkFlow();
  readWall();
  if (execution_.parallel()) putTogether();
}

double FoamRun::reported(const std::string& function) const {
  const auto file = folder_ / "postProcessing" / function / "0/surfaceFieldValue.dat";
  const auto value = foamLog::lastValue(foamLog::read(file));
  if (!value || !std::isfinite(*value))
    steps_.fail("simpleFoam", fmt::format("no valid number in {}", file.string()));
  return *value;
}

void FoamRun::checkFlow() {
  const double in = -reported("inletFlow");
  double out = reported("outletFlow");
  if (!(in > 0.0))
    steps_.fail("simpleFoam", fmt::format("blood leaves through the inlet ({:.4g} m^3/s)", -in));
  solution_.flowRate = in;
  out += checkOutlets(out);
  solution_.massImbalance = std::abs(out - in) / in;
  if (!(solution_.massImbalance <= settings_.massTolerance))
    steps_.fail("simpleFoam", fmt::format("{:.4g} m^3/s flow in but {:.4g} out", in, out));
  if (conditions_.drive == FlowConditions::Drive::flowRate &&
      !(std::abs(in - conditions_.flowRate) <= settings_.massTolerance * conditions_.flowRate))
    steps_.fail("simpleFoam",
                fmt::format("{:.4g} m^3/s flow in instead of {:.4g}", in, conditions_.flowRate));
  solution_.pressureDrop = (reported("inletPressure") - reported("outletPressure")) * conditions_.density;
  // Blood that slows down in a wider outlet regains pressure: at most the kinetic energy that a parabolic
  // profile brings in (docs/model/flow.md)
  const double velocity = in / lumen_.inlet.area;
  const double mostRegained = conditions_.density * velocity * velocity;
  if (!(solution_.pressureDrop > -mostRegained))
    steps_.fail(
        "simpleFoam",
        fmt::format("the pressure rises along the flow, by {:.4g} Pa, more than blood that slows down can "
                    "regain ({:.4g} Pa)",
                    -solution_.pressureDrop, mostRegained));
}

double FoamRun::checkOutlets(double throughFirst) {
  if (lumen_.furtherOutlets.empty()) return 0;
  const double ownPressure = reported("outletPressure");
  solution_.outlets = {{.flowRate = throughFirst}};
  double sum = 0;
  for (std::size_t n = 1; n <= lumen_.furtherOutlets.size(); ++n) {
    const std::string name(regionName(outletRegion(n)));
    const double flowRate = reported(name + "Flow"), pressure = reported(name + "Pressure") - ownPressure;
    solution_.outlets.push_back({flowRate, conditions_.density * pressure});
    sum += flowRate;
  }
  for (std::size_t n = 0; n < solution_.outlets.size(); ++n) {
    const double is = solution_.outlets[n].flowRate,
                 should = conditions_.outlets[n].share * conditions_.flowRate;
    if (!(std::abs(is - should) <= settings_.massTolerance * conditions_.flowRate))
      steps_.fail("simpleFoam", fmt::format("{:.4g} m^3/s leave through the outlet '{}' instead of {:.4g}",
                                            is, conditions_.outlets[n].name, should));
  }
  return sum;
}

void FoamRun::readWall() {
  const auto samples =
      folder_ / "postProcessing/surface" / std::to_string(solution_.iterations);  // none of another iteration
  try {
    appendWallPatch(samples / "wall.vtp", SurfaceRegion::wall, conditions_.density, solution_.wall);
    if (meshHasStruts_)
      appendWallPatch(samples / "strut.vtp", SurfaceRegion::strut, conditions_.density, solution_.wall);
  } catch (const std::runtime_error& error) {
    steps_.fail("simpleFoam", error.what());
  }
}

void FoamRun::putTogether() {
  run("reconstructParMesh", {"-constant"}, FoamSteps::On::oneProcess);
  run("reconstructPar", {"-latestTime"}, FoamSteps::On::oneProcess);
  fs::copy(folder_ / "0.orig", folder_ / "0", fs::copy_options::recursive);
  for (const auto& part : steps_.parts()) fs::remove_all(part);
}

}  // namespace restenosis
