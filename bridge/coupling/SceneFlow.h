#pragma once

#include <memory>
#include <string_view>

#include "bridge/coupling/PartContext.h"
#include "bridge/flow/backends/FlowBackends.h"

namespace restenosis {

/// What the backend of a run's flow is given.
FlowBackendOptions flowBackendOptions(const PartContext& context);

/// A backend that solves in the lumens of the run's scene; null for "none".
std::unique_ptr<FlowBackend> flowBackendFor(const Scene& scene, std::string_view name,
                                            const FlowBackendOptions& options);

}  // namespace restenosis
