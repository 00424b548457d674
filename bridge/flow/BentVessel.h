#pragma once

#include <memory>

#include "bridge/flow/WrappedBackend.h"
#include "bridge/surface/Centreline.h"

namespace restenosis {

/// Solves in a bent vessel what is given for the straight one: the lumen is bent along the axis, the solution
/// brought back, tractions turned with it. Areas are those of the bent lumen.
class BentVessel : public WrappedBackend {
 public:
  BentVessel(std::unique_ptr<FlowBackend> backend, std::shared_ptr<const Centreline> axis)
      : WrappedBackend(std::move(backend)), axis_(std::move(axis)) {}
  FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                     const std::filesystem::path& caseFolder) override;
  /// At points of the straight vessel.
  std::vector<Vec3> velocities(const std::vector<Vec3>& points) const override;

 private:
  std::shared_ptr<const Centreline> axis_;
};

}  // namespace restenosis
