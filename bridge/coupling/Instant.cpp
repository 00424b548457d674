#include "bridge/coupling/Instant.h"

#include <cmath>

#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

std::uint32_t stepCount(const SceneParameters& scene) {
  return static_cast<std::uint32_t>(std::lround(scene.duration / scene.step));
}

Instant instantOf(const Scene& scene, std::uint32_t step) {
  Instant now;
  now.step = step;
  now.time = step * scene.scene.step;
  now.last = step == stepCount(scene.scene);
  now.endsDay = nextToMultiple(now.time, secondsPerDay, scene.scene.step);
  now.recorded = now.last || step == 0 || nextToMultiple(now.time, scene.output.interval, scene.scene.step);
  now.takesLumen =
      now.recorded || now.endsDay || nextToMultiple(now.time, scene.coupling.lumenInterval, scene.scene.step);
  return now;
}

bool nextToMultiple(double time, double interval, double step) {
  // Of a number of intervals: less is rounding, which must not decide whether halfway has been reached.
  constexpr double roundingOfIntervals = 1e-9;
  if (interval <= step) return true;  // and the quotient may be beyond all numbers
  const auto multiplesUntil = [&](double t) { return std::floor(t / interval + roundingOfIntervals); };
  return multiplesUntil(time + step / 2) > multiplesUntil(time - step / 2);
}

}  // namespace restenosis
