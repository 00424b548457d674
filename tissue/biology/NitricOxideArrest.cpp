#include "tissue/biology/NitricOxideArrest.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

std::unique_ptr<const ArrestRule> NitricOxideArrest::make(const BiologySettings& settings) {
  if (!settings.endothelium) return nullptr;
  const Endothelium endothelium(*settings.endothelium, settings.seed, settings.denuded);
  return std::make_unique<NitricOxideArrest>(*settings.endothelium, endothelium.onset());
}

NitricOxideArrest::NitricOxideArrest(const EndotheliumParameters& parameters, double endotheliumOnset)
    : law_(parameters),
      onset_(endotheliumOnset),
      reaches_(parameters.nitricOxideReach > 0),
      matures_(parameters.maturationTime > 0) {}

double NitricOxideArrest::decidingWss() const {
  if (reaches_ || matures_) return std::numeric_limits<double>::infinity();
  return law_.wssForNitricOxide(law_.threshold());
}

bool NitricOxideArrest::undecided(const AgentStore& agents, Index cell, double margin) const {
  if (reaches_) return agents.nitricOxide[cell] < margin * law_.threshold();
  const double maturity = matures_ ? agents.maturity[cell] : 1.0F;
  return agents.wss[cell] < margin * law_.wssForNitricOxide(law_.threshold() / maturity);
}

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
