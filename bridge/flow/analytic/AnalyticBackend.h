#pragma once

#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// Poiseuille flow from the local radius R = sqrt(A / pi), with A the area of the lumen's cross-section
/// through each face, across the vessel's own axis (LumenProfile): tau = 4 mu Q / (pi R^3) with one flow rate
/// Q, the given one, or for a given pressure gradient G along the distance L between the ends' planes the one
/// that loses G L: Q = G L / (integral of 8 mu / (pi R^4) ds). Along the axis, in the plane of the face.
/// Knows no recirculation: faces of any inclination carry the traction of their cross-section. Triangles
/// longer than a quarter of the mean radius are taken in pieces. Writes no files. docs/model/flow.md eq. 4
class AnalyticBackend : public FlowBackend {
 public:
  /// @param stations number of cross-sections, evenly spaced, between which the area is interpolated; > 1
  explicit AnalyticBackend(int stations = 400) : stations_(stations) {}
  std::string_view name() const override;
  FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                     const std::filesystem::path& caseFolder) override;

 private:
  int stations_;
};

}  // namespace restenosis
