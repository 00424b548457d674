#pragma once

#include <memory>
#include <span>
#include <vector>

#include "bridge/coupling/Part.h"
#include "bridge/coupling/PartContext.h"
#include "bridge/output/PlannedPart.h"

namespace restenosis {

/// A part of the loop: what it says of itself for a scene, and how it is made; null where the scene has none.
struct PartEntry {
  std::vector<PlannedPart> (*explain)(const Scene& scene);
  std::unique_ptr<Part> (*make)(const PartContext& context);
};

/// The parts of a step of growth, in the order in which they run.
std::span<const PartEntry> growthStep();

}  // namespace restenosis
