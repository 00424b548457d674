#pragma once

#include "bridge/flow/WrappedBackend.h"

namespace restenosis {

/// Solves by another backend for the flow rate at which the pressure that is given is lost, part of it along
/// the lumen and part in what lies behind it (FlowConditions::distal):
///
///     Q R_d + dp(Q) = p
///
/// A lumen that narrows loses flow by this, as it does in people: little until its own resistance dp / Q
/// comes near R_d. dp / Q is taken to be a line in Q, as for a stenosis (Young 1979), through the last two
/// solutions; what remains is solved again. Where nothing is distal, the backend solves as it is.
class DistalResistance : public WrappedBackend {
 public:
  using WrappedBackend::WrappedBackend;
  /// Throws FlowFailed, also where no flow rate is found.
  FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                     const std::filesystem::path& caseFolder) override;
};

}  // namespace restenosis
