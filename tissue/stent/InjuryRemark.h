#pragma once

#include <string>

#include "tissue/stent/Injury.h"

namespace restenosis {

/// What is to be said of an injury that makes no cell synthetic, so that none can ever cycle: what it lacked,
/// and which settings count. Empty where some cell may cycle.
std::string remarkOnInjury(const InjuryReport& injury, const InjuryParameters& parameters);

}  // namespace restenosis
