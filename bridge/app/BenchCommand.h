#pragma once

#include <CLI/CLI.hpp>

namespace restenosis {

/// `bench [NAME]`: throughput of the kernels beside this machine's limits, measured in the same run.
void addBenchCommand(CLI::App& app, int& status);

}  // namespace restenosis
