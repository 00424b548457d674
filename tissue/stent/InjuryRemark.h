#pragma once

#include <string>

#include "tissue/stent/Injury.h"

namespace restenosis {

/// Remark on an injury that makes no cell synthetic, so that none can ever cycle: its cause and the settings
/// that matter. Empty where some cell may cycle.
std::string remarkOnInjury(const InjuryReport& injury, const InjuryParameters& parameters);

}  // namespace restenosis
