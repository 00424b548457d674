#pragma once

#include <string>

#include "bridge/scene/Scene.h"

namespace restenosis {

/// Memory and time of the one solve in a lumen without tissue, estimated; empty where there is tissue, whose
/// lumen changes. A line.
std::string flowCostText(const Scene& scene);

/// Agents, memory and time of the tissue, or empty where there is none; and what is to be said of a loaded
/// wall. Throws as makeStent does.
std::string tissueCostText(const Scene& scene);

}  // namespace restenosis
