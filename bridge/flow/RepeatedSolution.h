#pragma once

#include <filesystem>

#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// Solutions in one lumen under conditions that change from one to the next: each takes the case folder of
/// the one before, and is said to have cost what all of them have.
class RepeatedSolution {
 public:
  RepeatedSolution(FlowBackend& backend, const TriSurface& lumen, const std::filesystem::path& caseFolder)
      : backend_(backend), lumen_(lumen), caseFolder_(caseFolder) {}

  /// Throws FlowFailed.
  FlowSolution next(const FlowConditions& conditions) {
    if (!isFirst_ && !caseFolder_.empty()) std::filesystem::remove_all(caseFolder_);
    isFirst_ = false;
    FlowSolution solution = backend_.solve(lumen_, conditions, caseFolder_);
    solution.iterations = iterations_ += solution.iterations;
    solution.meshSeconds = meshSeconds_ += solution.meshSeconds;
    solution.solveSeconds = solveSeconds_ += solution.solveSeconds;
    return solution;
  }

 private:
  FlowBackend& backend_;
  const TriSurface& lumen_;
  const std::filesystem::path& caseFolder_;
  bool isFirst_ = true;
  int iterations_ = 0;
  double meshSeconds_ = 0, solveSeconds_ = 0;
};

}  // namespace restenosis
