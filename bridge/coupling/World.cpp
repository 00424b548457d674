#include "bridge/coupling/World.h"

#include <algorithm>

#include "bridge/scene/SceneFingerprint.h"
#include "bridge/surface/CylinderSurface.h"
#include "bridge/surface/LoadedLumen.h"
#include "bridge/surface/LumenSurface.h"

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
  return RadialMap::ofRound([&](double z) { return cylinderRadius(vessel, z); }, vessel.length,
                            std::max(vessel.lumenDiameter / planesADiameter, vessel.length / mostPlanes));
}

}  // namespace

World::World(const Scene& s, const ResultsFolder& f, Progress& p)
    : scene(s), folder(f), progress(p), wall(emptyWall(s.vessel)), biology(biologySettings(s)) {}

void World::remark(const std::string& text) {
  if (text.empty()) return;
  remarks.push_back(text);
  progress.message(text);
}

bool World::lastFlowHasTheseSettings() const {
  return flow.solves == 0 || flow.settings == flowSettings(scene);
}

void World::takeLumen() {
  if (hasLoadedLumen()) return;  // it never changes, and has no axis to see it from
  auto measurement = timer.measure("surface");
  forgetLumen();
  if (!scene.hasTissue()) {
    lumen.present = tubeMap(scene.vessel);
    return;
  }
  const auto struts =
      stent ? std::span<const StrutSegment>(stent->segments) : std::span<const StrutSegment>();
  field_ = LumenField::fromTissue(wall.agents, struts, wall.length, fieldSettings(scene.coupling));
  lumen.present = RadialMap(*field_);
  lumen.detachedPieces = field_->topology().islands;
  lumen.closed = field_->occluded();
}

void World::updateLumen() {
  takeLumen();
  if (lumen.afterDeployment.planes() == 0) lumen.afterDeployment = lumen.present;
}

void World::forgetLumen() {
  field_.reset();
  if (!hasLoadedLumen()) surface_.reset();
}

const TriSurface& World::lumenSurface() {
  if (surface_) return *surface_;
  if (scene.hasTissue() && !field_) takeLumen();
  auto measurement = timer.measure("surface");
  if (hasLoadedLumen())
    surface_ = loadLumen(scene.vessel);
  else
    surface_ = scene.hasTissue() ? extractSurface(*field_) : cylinderSurface(scene.vessel);
  field_.reset();
  return *surface_;
}

std::pair<double, double> World::measuredSection() const {
  if (!stent || stent->segments.empty()) return {0.0, wall.length};
  double from = wall.length, to = 0.0, width = 0.0;
  for (const auto& segment : stent->segments) {
    from = std::min({from, segment.a.z(), segment.b.z()});
    to = std::max({to, segment.a.z(), segment.b.z()});
    width = std::max(width, segment.width);
  }
  // The tissue beside the outermost struts belongs to the stented section (assumed: 2.5 strut widths from
  // their centre).
  const double margin = 2.5 * width;
  return {std::max(0.0, from - margin), std::min(wall.length, to + margin)};
}

BiologySettings biologySettings(const Scene& scene) {
  BiologySettings settings;
  settings.cellCycle = scene.cellCycle;
  settings.contactInhibition = scene.contactInhibition;
  settings.endothelium = scene.endothelium;
  settings.denuded = !scene.injury || scene.injury->denuded();
  settings.seed = static_cast<std::uint64_t>(scene.scene.seed);
  settings.step = scene.scene.step;
  settings.vesselLength = scene.vessel.length;
  return settings;
}

}  // namespace restenosis
