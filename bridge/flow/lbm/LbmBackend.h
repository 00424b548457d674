#pragma once

#include <atomic>
#include <memory>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/lbm/LbmSettings.h"

namespace restenosis {

class LatticeSampler;
class SteadyLattice;

/// Steady laminar flow by a D3Q19 lattice Boltzmann method (docs/model/flow.md): an independent check on the
/// OpenFOAM backend, with the same surface, flow rate and viscosity. Wall faces are the triangles of the
/// surface.
///
/// The flow starts from Poiseuille's in every cross-section, on a coarse lattice, and each lattice from the
/// one before; with the case of a former solve (startFrom), from its flow, on its own lattice at once. It is
/// converged when the wall shear stress is. Divergence, a lumen that the lattice does not resolve and a flow
/// that does not settle end by FlowFailed, which names the setting to change. Writes `log.lbm` and
/// `lattice.vti` (writeLatticeField).
class LbmBackend : public FlowBackend {
 public:
  /// @param keepVelocities of the last solution, about 40 bytes a node
  explicit LbmBackend(const LbmSettings& settings, const std::atomic<bool>* stopRequested = nullptr,
                      bool keepVelocities = false)
      : settings_(settings), stopRequested_(stopRequested), keepVelocities_(keepVelocities) {}
  std::string_view name() const override;
  FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                     const std::filesystem::path& caseFolder) override;
  void startFrom(const std::filesystem::path& formerCase) override;
  bool needsFormerCase() const override;
  std::vector<std::filesystem::path> filesToStartFrom(const std::filesystem::path& formerCase) const override;
  std::vector<Vec3> velocities(const std::vector<Vec3>& points) const override;

 private:
  LbmSettings settings_;
  const std::atomic<bool>* stopRequested_;
  bool keepVelocities_;
  std::filesystem::path former_;  ///< case that the next solve starts from; empty for none
  std::shared_ptr<const LatticeSampler> kept_;
};

}  // namespace restenosis
