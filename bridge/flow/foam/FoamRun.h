#pragma once

#include <filesystem>
#include <string>

#include "FlowBackend.h"
#include "FoamSettings.h"
#include "LumenCase.h"

namespace restenosis {

/// A step that failed in a way that another attempt may mend.
struct FoamStepFailed : FlowFailed {
  using FlowFailed::FlowFailed;
};

/// One attempt at a case: runs OpenFOAM's programs in a folder that holds a filled template, and checks what
/// each has done. The steps throw FoamStepFailed, or FlowFailed where another attempt would be vain: a
/// program missing, an interruption, a closed lumen.
class FoamRun {
 public:
  FoamRun(std::filesystem::path folder, const LumenCase& lumen, const FlowConditions& conditions,
          const FoamSettings& settings);
  /// blockMesh, snappyHexMesh, checkMesh; the mesh as expected.
  void mesh();
  /// simpleFoam; the solution as expected.
  void solve();
  /// What the solver has left in the folder.
  FlowSolution result() const { return solution_; }

 private:
  void run(const std::string& program, const std::vector<std::string>& arguments);
  std::filesystem::path log(const std::string& program) const { return folder_ / ("log." + program); }
  [[noreturn]] void fail(const std::string& program, const std::string& reason) const;
  void checkPatches();
  void checkFlow();
  void readWall();
  double reported(const std::string& function) const;

  std::filesystem::path folder_;
  const LumenCase& lumen_;
  const FlowConditions& conditions_;
  const FoamSettings& settings_;
  FlowSolution solution_;
};

}  // namespace restenosis
