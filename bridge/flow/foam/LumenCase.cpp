#include "LumenCase.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace restenosis {
namespace {

constexpr double perMetre = 1e3;  // mm in a metre

/// Rows of refined cells on each side of a surface that an estimate of the number of cells counts.
constexpr double refinedRows = 4.0;

double estimatedCells(const LumenCase& lumen, const FoamSettings& s) {
  const auto rows = [&](double area, std::int64_t level) {
    const double size = s.cellSize / std::pow(2.0, static_cast<double>(level));
    return refinedRows * area / (size * size);
  };
  return lumen.volume / std::pow(s.cellSize, 3) + rows(lumen.wallArea, s.wallLevel) +
         rows(lumen.strutArea, s.strutLevel);
}

/// Cells of the background block from the middle of the lumen to either side, one beyond it.
long halfCells(double low, double high, double size) {
  return static_cast<long>(std::ceil(0.5 * (high - low) / size)) + 1;
}

}  // namespace

LumenCase measureLumen(const TriSurface& lumen, const FoamSettings& settings) {
  requireLumen(lumen);
  LumenCase result;
  result.inlet = lumenEnd(lumen, SurfaceRegion::inlet);
  result.outlet = lumenEnd(lumen, SurfaceRegion::outlet);
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
  if (diameter < settings.minimumCellsAcross * settings.cellSize)
    throw std::invalid_argument(fmt::format(
        "the inlet is {:.4g} mm wide, less than {} cells of {:.4g} mm: the lumen is too small for "
        "this fidelity, or its length unit is wrong",
        diameter * perMetre, settings.minimumCellsAcross, settings.cellSize * perMetre));
  if (const double cells = estimatedCells(result, settings); cells > settings.maximumCells)
    throw std::invalid_argument(fmt::format(
        "the lumen ({:.4g} mm wide, {:.4g} mm long) needs about {:.2g} cells, more than the limit of "
        "{:.2g}: choose a lower fidelity, or check its length unit",
        diameter * perMetre, result.length() * perMetre, cells, settings.maximumCells));
  return result;
}

void writeLumenParameters(DictionaryText& parameters, const LumenCase& lumen,
                          const FlowConditions& conditions, const FoamSettings& settings, Effort effort,
                          int ranks) {
  const auto length = [&](std::string_view key, double metres) { parameters.set(key, metres * perMetre); };
  const bool fixedFlow = conditions.drive == FlowConditions::Drive::flowRate;
  parameters.set("kinematicViscosity", conditions.kinematicViscosity * perMetre * perMetre);
  parameters.set("density", conditions.density);
  parameters.set("drive", fixedFlow ? "flowRate" : "pressureGradient");
  parameters.set("flowRate", conditions.flowRate * std::pow(perMetre, 3));
  parameters.set("pressureDrop",
                 conditions.pressureGradient * lumen.length() / conditions.density * perMetre * perMetre);
  length("inletX", lumen.inlet.centre.x());
  length("inletY", lumen.inlet.centre.y());
  length("inletRadius", std::sqrt(lumen.inlet.area / std::numbers::pi));
  length("inletZ", lumen.inlet.z);
  length("outletZ", lumen.outlet.z);

  const double size = settings.cellSize;
  const Vec3 middle = 0.5 * (lumen.low + lumen.high);
  const long halfX = halfCells(lumen.low.x(), lumen.high.x(), size);
  const long halfY = halfCells(lumen.low.y(), lumen.high.y(), size);
  length("xMin", middle.x() - size * static_cast<double>(halfX));
  length("xMax", middle.x() + size * static_cast<double>(halfX));
  length("yMin", middle.y() - size * static_cast<double>(halfY));
  length("yMax", middle.y() + size * static_cast<double>(halfY));
  parameters.set("cellsX", std::to_string(2 * halfX));
  parameters.set("cellsY", std::to_string(2 * halfY));
  parameters.set("cellsZ", std::to_string(std::max(1L, std::lround(lumen.length() / size))));

  // Just inside the inlet, at a fraction of a cell that refinement never makes a face
  const Vec3 inside = (lumen.inlet.centre + size * Vec3(0.131, 0.173, 0.371)) * perMetre;
  parameters.set("insidePoint", fmt::format("({} {} {})", inside.x(), inside.y(), inside.z()));

  const bool robust = effort == Effort::robust;
  parameters.set("struts", lumen.hasStruts() ? "yes" : "no");
  parameters.set("wallLevel", std::to_string(settings.wallLevel));
  parameters.set("strutLevel", std::to_string(settings.strutLevel));
  parameters.set("meshing", robust ? "thorough" : "quick");
  const auto iterations = fixedFlow ? settings.iterations : settings.pressureDrivenIterations;
  parameters.set("iterations", std::to_string(robust ? 2 * iterations : iterations));
  parameters.set("tolerance", settings.tolerance);
  parameters.set("ranks", std::to_string(ranks));
  parameters.set("relaxation", robust ? 0.75 * settings.relaxation : settings.relaxation);
}

}  // namespace restenosis
