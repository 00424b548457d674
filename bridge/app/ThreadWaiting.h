#pragma once

namespace restenosis {

/// Makes OpenMP threads that wait for work sleep, after a moment of spinning, unless the environment says
/// otherwise (OMP_WAIT_POLICY). Threads that go on spinning take the cores that a flow solver, or another
/// run, could use: on a busy machine that costs a factor of ten. Those that sleep at once have to be woken
/// for every loop of a relaxation, which costs up to a twentieth. The settings are read when the program is
/// loaded, so it starts itself again once.
void letWaitingThreadsSleep(char** argv);

}  // namespace restenosis
