#include "bridge/scene/ArteryWidth.h"

#include <fmt/format.h>

#include "bridge/surface/LengthUnit.h"

namespace restenosis {
namespace {

/// Widths of coronary arteries [m]: assumed, a decade, so that no other decimal unit makes a sound width of
/// another one.
constexpr double narrowestArtery = 0.8e-3, widestArtery = 8e-3;

bool isCoronary(double diameter) { return diameter >= narrowestArtery && diameter <= widestArtery; }

}  // namespace

std::string remarkOnWidth(const Scene& scene, double diameter) {
  if (isCoronary(diameter)) return {};
  const VesselParameters& vessel = scene.vessel;
  const std::string width = fmt::format("{:.4g} mm wide; coronary arteries are {:g} to {:g} mm wide",
                                        1e3 * diameter, 1e3 * narrowestArtery, 1e3 * widestArtery);
  if (vessel.lumenSurface.empty())
    return fmt::format("the lumen is {}: is the unit of vessel.lumenDiameter right?", width);
  std::string other;
  for (const char* unit : {"m", "cm", "mm", "um"})
    if (const double then = diameter / metresPer(vessel.lumenSurfaceUnit) * metresPer(unit); isCoronary(then))
      other = fmt::format(" In {} it would be {:.4g} mm.", unit, 1e3 * then);
  return fmt::format("the inlet of {} is {}. Is vessel.lumenSurfaceUnit, {}, right?{}", vessel.lumenSurface,
                     width, vessel.lumenSurfaceUnit, other);
}

}  // namespace restenosis
