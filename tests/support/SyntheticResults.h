#pragma once

#include <filesystem>
#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "bridge/surface/TriSurface.h"
#include "tissue/agents/AgentStore.h"
#include "tissue/stent/Stent.h"

namespace restenosis {

/// A made-up run with known shapes, for tests of what reads results: a vessel of lumen radius 0.9 mm and
/// length 1.2 mm, one strut ring pressed 110 um in, and a neointima that grows as a bell around the ring and
/// is thicker on one side.
struct SyntheticResults {
  double length = 1.2e-3;
  double radius = 0.9e-3;
  double cellRadius = 30e-6;
  int frames = 3;
  int daysPerFrame = 5;

  /// Lumen radius [m] at a place and a time in [0, 1].
  double lumenRadius(double z, double theta, double progress) const;
  AgentStore agents(double progress) const;
  TriSurface lumen(double progress) const;
  std::vector<StrutSegment> struts() const;
  FlowSolution flow(const TriSurface& lumen) const;
  /// Writes timeSeries.csv, profile.csv, summary.json, scene.toml, struts.vtp and both series.
  void write(const std::filesystem::path& folder) const;
};

}  // namespace restenosis
