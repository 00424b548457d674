#pragma once

#include <cstdint>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// Which biological step is being made.
struct Instant {
  std::uint32_t step = 0;  ///< steps made before this one
  double time = 0;         ///< at the start of the step [s]
  bool recorded = false;   ///< whether the state is recorded in this step
  bool takesLumen = true;  ///< whether the lumen is taken anew: see `coupling.lumenInterval`
  bool endsDay = false;    ///< whether a day of growth is over: see LumenPart
  bool last = false;  ///< whether the run ends here: the state is brought up to date, but not carried further
};

/// Number of biological steps of a scene.
std::uint32_t stepCount(const SceneParameters& scene);

/// The instant of a scene's step.
Instant instantOf(const Scene& scene, std::uint32_t step);

/// Whether a multiple of the interval lies nearer to this step than to any other; halfway counts for the
/// first.
bool nextToMultiple(double time, double interval, double step);

}  // namespace restenosis
