#include "tissue/biology/NitricOxideArrest.h"

#include <fmt/format.h>

#include <cmath>

#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

std::unique_ptr<const ArrestRule> NitricOxideArrest::make(const BiologySettings& settings) {
  if (!settings.endothelium) return nullptr;
  const Endothelium endothelium(*settings.endothelium, settings.seed, settings.denuded);
  return std::make_unique<NitricOxideArrest>(*settings.endothelium, endothelium.onset());
}

NitricOxideArrest::NitricOxideArrest(const EndotheliumParameters& parameters, double endotheliumOnset)
    : law_(parameters), onset_(endotheliumOnset) {}

std::string NitricOxideArrest::readsNoWssUntil(double time) const {
  if (std::isinf(onset_)) return "the endothelium never returns";
  if (onset_ > time)
    return fmt::format("endothelium returns after the end of the run (day {:g})", onset_ / secondsPerDay);
  return {};
}

std::string NitricOxideArrest::whenWssIsRead() const {
  return fmt::format(
      "from the first covered cell (not before day {:g}), when a covered cell could still cycle",
      onset_ / secondsPerDay);
}

}  // namespace restenosis
