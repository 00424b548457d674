#pragma once

#include "bridge/flow/WrappedBackend.h"

namespace restenosis {

/// Solves by another backend for the shares of several outlets at which what lies behind them ends at one
/// pressure (Outlet::resistance): along each way i from the inlet
///
///     p_inlet - p_i + R_i Q_i = p, the same for all
///
/// With the vessel's own resistance on that way, r_i = (p_inlet - p_i) / Q_i of the last solution, the shares
/// go with 1 / (r_i + R_i); what remains is solved again. Where shares are given, the backend solves as it
/// is.
class OutletResistances : public WrappedBackend {
 public:
  using WrappedBackend::WrappedBackend;
  /// Throws FlowFailed, also where no shares are found.
  FlowSolution solve(const TriSurface& lumen, const FlowConditions& conditions,
                     const std::filesystem::path& caseFolder) override;
};

}  // namespace restenosis
