#pragma once

#include <string>

#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// The template's system/outlets with the outlets beside the first: their patches, what flows through them,
/// and what is reported of them. As it is where there is one outlet. Throws std::invalid_argument for a text
/// that lacks one of its entries.
std::string outletsText(std::string text, const FlowConditions& conditions);

}  // namespace restenosis
