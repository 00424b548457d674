#include "bridge/coupling/LumenExtraction.h"

#include <algorithm>
#include <span>

#include "bridge/surface/Histology.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/LumenSurface.h"
#include "bridge/surface/VesselAxis.h"

namespace restenosis {
namespace {

LumenFieldSettings fieldSettings(const CouplingParameters& coupling) {
  LumenFieldSettings settings;
  settings.resolution = coupling.surfaceResolution;
  settings.smoothing = coupling.surfaceSmoothing;
  return settings;
}

/// Planes of the radial map of a lumen without tissue: over the length of a diameter (15 um apart in a vessel
/// of 1.8 mm), and at most in all (assumed).
constexpr double planesADiameter = 120, mostPlanes = 10000;

/// The lumen of a scene without tissue.
RadialMap tubeMap(const VesselParameters& vessel) {
  return RadialMap::ofRound(lumenRadius(vessel), vessel.length,
                            std::max(vessel.lumenDiameter / planesADiameter, vessel.length / mostPlanes));
}

}  // namespace

void LumenExtraction::extract(LumenState& lumen) {
  if (scene_.hasLoadedLumen()) return;  // it never changes, and has no axis to see it from
  auto measurement = timer_.measure("surface");
  release();
  if (scene_.hasTissue()) {
    extractField();
    lumen.present = RadialMap(*field_);
    lumen.detachedPieces = field_->topology().islands;
    lumen.closed = field_->occluded();
  } else {
    lumen.present = tubeMap(scene_.vessel);
  }
  if (lumen.afterDeployment.planes() > 0) return;
  lumen.afterDeployment = lumen.present;
  if (const Histology histology(wall_.agents, wall_.cellRadius); histology.possible())
    lumen.insideIelAfterDeployment = histology.insideIel(lumen.present);
}

void LumenExtraction::extractField() {
  if (!struts_)
    struts_.emplace(stent_ ? std::span<const StrutSegment>(stent_->segments)
                           : std::span<const StrutSegment>());
  field_ = LumenField::fromTissue(wall_.agents, *struts_, wall_.length, fieldSettings(scene_.coupling));
}

void LumenExtraction::release() {
  field_.reset();
  if (!scene_.hasLoadedLumen()) surface_.reset();
}

const TriSurface& LumenExtraction::surface() {
  if (surface_) return *surface_;
  auto measurement = timer_.measure("surface");
  if (scene_.hasLoadedLumen()) {
    surface_ = loadLumen(scene_.vessel, scene_.outlets());
  } else if (scene_.hasTissue()) {
    if (!field_) extractField();
    surface_ = extractSurface(*field_);
  } else {
    surface_ = straightLumen(scene_.vessel);
  }
  field_.reset();
  return *surface_;
}

}  // namespace restenosis
