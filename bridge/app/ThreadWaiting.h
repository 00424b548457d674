#pragma once

namespace restenosis {

/// Makes OpenMP threads that wait for work sleep instead of spin, unless the environment says otherwise
/// (OMP_WAIT_POLICY). Spinning threads take the cores that a flow solver, or another run, could use: on a
/// busy machine that costs a factor of ten. The setting is read when the program is loaded, so it starts
/// itself again once.
void waitWithoutSpinning(char** argv);

}  // namespace restenosis
