#pragma once

#include <filesystem>
#include <string>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/foam/FoamExecution.h"
#include "bridge/flow/foam/FoamSettings.h"
#include "bridge/flow/foam/FoamStart.h"
#include "bridge/flow/foam/FoamSteps.h"
#include "bridge/flow/foam/LumenCase.h"

namespace restenosis {

/// A mesh that cannot be moved or laid onto the lumen; `reason` is a category, without numbers, that can be
/// counted.
struct MeshRefused : std::runtime_error {
  MeshRefused(std::string category, const std::string& details)
      : std::runtime_error(details), reason(std::move(category)) {}
  std::string reason;
};

/// One attempt at a case: runs OpenFOAM's programs in a folder that holds a filled template, and checks what
/// each has done. The steps throw FoamStepFailed, FlowFailed where another attempt would be vain or would
/// change a sound result (a program missing, an interruption, a program that was killed, a closed lumen), and
/// WriteFailed where there is no room left. On several ranks the case is decomposed before
/// meshing and put together again after simpleFoam, so that what is left opens like a serial one.
class FoamRun {
 public:
  FoamRun(std::filesystem::path folder, const LumenCase& lumen, const FlowConditions& conditions,
          const FoamSettings& settings, const FoamExecution& execution);
  /// blockMesh, snappyHexMesh, checkMesh; the mesh as expected.
  void mesh();
  /// The mesh of a case that has been solved, moved onto the lumen, and checkMesh; the mesh as expected and
  /// within the limits of FoamSettings. Returns where its cells are. Throws MeshRefused as well.
  std::vector<Vec3> morph(const PolyMesh& former, const std::filesystem::path& formerCase,
                          const TriSurface& surface);
  /// An O-grid (OGrid.h) and checkMesh; the mesh as expected. Throws MeshRefused as well.
  void layOGrid(const TriSurface& surface);
  /// simpleFoam, from rest or from another flow; the solution as expected.
  void solve(const FoamStart* start);
  /// What the solver has left in the folder.
  FlowSolution result() const { return solution_; }

 private:
  void run(const std::string& program, const std::vector<std::string>& arguments, FoamSteps::On on);
  void checkPatches();
  /// The mesh's largest non-orthogonality [degrees].
  double checkMesh();
  /// Whether the ends of the mesh are those of the lumen.
  void checkEnds();
  void checkFlow();
  /// Notes what goes through each of several outlets, and returns the sum of those beside the first [m^3/s].
  double checkOutlets(double throughFirst);
  void readWall();
  void putTogether();
  double reported(const std::string& function) const;

  std::filesystem::path folder_;
  const LumenCase& lumen_;
  const FlowConditions& conditions_;
  const FoamSettings& settings_;
  const FoamExecution& execution_;
  FoamSteps steps_;
  FlowSolution solution_;
  bool meshHasStruts_ = false;
};

}  // namespace restenosis
