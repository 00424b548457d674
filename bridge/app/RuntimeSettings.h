#pragma once

namespace restenosis {

/// Makes OpenMP and the C library's memory behave as this program needs, unless the environment says
/// otherwise:
///
/// - Threads that wait for work sleep, after a moment of spinning (OMP_WAIT_POLICY). Threads that go on
///   spinning take the cores that a flow solver, or another run, could use: on a busy machine that costs a
///   factor of ten. Those that sleep at once have to be woken for every loop of a relaxation, which costs up
///   to a twentieth.
/// - Large arrays are of large pages (GLIBC_TUNABLES): a run hands out hundreds of megabytes a day anew, and
///   each page of 4 KiB costs a fault, which virtual machines make dear.
/// - Arrays above a mebibyte go back to the system when they are freed. Left to itself glibc keeps them for
///   later, up to 32 MiB each, and a vessel of half a million agents has a sixth more memory. Of smaller ones
///   32 MiB in all are kept: they are asked for again in every step.
///
/// The first two are read when a program is loaded, so it starts itself again once. Programs that it starts
/// later have the user's GLIBC_TUNABLES, not its own.
void applyRuntimeSettings(char** argv);

}  // namespace restenosis
