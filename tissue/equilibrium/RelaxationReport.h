#pragma once

#include <cstdint>

namespace restenosis {

/// What a relaxation did.
struct RelaxationReport {
  int iterations = 0;
  double residual = 0;                 ///< largest AgentForce::residual of a free agent
  std::uint64_t agentEvaluations = 0;  ///< forces computed, one an agent
  bool converged = false;

  /// Another relaxation has followed this one.
  void append(const RelaxationReport& next) {
    iterations += next.iterations;
    agentEvaluations += next.agentEvaluations;
    residual = next.residual, converged = next.converged;
  }

  template <class Archive>
  void archive(Archive& a) {
    a(iterations, residual, agentEvaluations, converged);
  }
};

}  // namespace restenosis
