#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// The rigid motion that lays a lumen along z, its inlet in the plane z = 0 with the centre in the origin.
/// Nothing where there is none: it has several outlets, the ends are not parallel within 0.1 degrees
/// (assumed), or part of the lumen lies beyond the plane of an end. The lumen must pass
/// requireLumenWithPlanarEnds.
std::optional<Eigen::Isometry3d> frameAlongZ(const TriSurface& lumen);

/// The lumen moved so, its ends exactly planes of constant z.
TriSurface movedAlongZ(const TriSurface& lumen, const Eigen::Isometry3d& frame);

/// The rigid motion that puts the inlet into the plane z = 0, its centre in the origin, the flow through it
/// along z; the lumen may bend as it likes behind it.
Eigen::Isometry3d frameOfInlet(const TriSurface& lumen);

/// A lumen where backends solve in it, and the motion that has laid it there.
struct LaidLumen {
  TriSurface surface;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
};

/// The lumen laid along z, or, where there is no such motion, so that it begins along z (frameOfInlet).
/// Throws std::invalid_argument for a surface that is no lumen (requireLumenWithPlanarEnds).
LaidLumen laidLumen(const TriSurface& lumen);

/// Solves in lumens that point in any direction by a backend for lumens along z: the lumen is moved, the
/// solution moved back. A lumen that cannot be laid along z begins along z; backends that cannot solve in it
/// say so.
class AnyDirection : public FlowBackend {
 public:
  explicit AnyDirection(std::unique_ptr<FlowBackend> backend) : backend_(std::move(backend)) {}
  std::string_view name() const override { return backend_->name(); }
  FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                     const std::filesystem::path& caseFolder) override;
  std::vector<Vec3> velocities(const std::vector<Vec3>& points) const override;

 private:
  std::unique_ptr<FlowBackend> backend_;
  Eigen::Isometry3d frame_ = Eigen::Isometry3d::Identity();  ///< of the last solution
};

}  // namespace restenosis
