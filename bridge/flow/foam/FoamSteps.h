#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bridge/flow/FlowBackend.h"
#include "bridge/flow/foam/FoamExecution.h"

namespace restenosis {

/// A step that failed in a way that another attempt may mend.
struct FoamStepFailed : FlowFailed {
  FoamStepFailed(std::string what, std::filesystem::path logFile);
  /// What failed, naming its log in the folder that another attempt keeps it in.
  std::string withLogIn(const std::filesystem::path& folder) const;

  std::string problem;  ///< without the log
};

/// Runs OpenFOAM's programs in the folder of a case, each with its log there. Throws FoamStepFailed where a
/// program fails, FlowFailed where another attempt would be vain (a program missing, an interruption, one
/// that was killed or hangs), and WriteFailed where there is no room left.
class FoamSteps {
 public:
  enum class On { oneProcess, allRanks };
  /// `execution` must outlive this.
  FoamSteps(std::filesystem::path folder, const FoamExecution& execution)
      : folder_(std::move(folder)), execution_(execution) {}
  /// Returns the seconds it took.
  double run(const std::string& program, const std::vector<std::string>& arguments, On on) const;
  /// Throws FoamStepFailed, or WriteFailed where there is no room left, which may be why.
  [[noreturn]] void fail(const std::string& program, const std::string& reason) const;
  std::filesystem::path log(const std::string& program) const { return folder_ / ("log." + program); }
  /// The folders with the mesh and the fields: those of the ranks, or the case itself.
  std::vector<std::filesystem::path> parts() const;

 private:
  void requireRoomAfter(const std::string& program) const;

  std::filesystem::path folder_;
  const FoamExecution& execution_;
};

}  // namespace restenosis
