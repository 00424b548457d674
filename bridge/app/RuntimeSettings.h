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
/// - Arrays of up to 16 MiB stay with the program when they are freed, as does the end of the heap up to
///   64 MiB: every step asks for them again, and what goes back to the system comes back a fault a page.
///   Larger ones go back. Left to itself glibc keeps those of up to 32 MiB, and a vessel of 640,000 agents
///   has a tenth more memory.
///
/// The first two are read when a program is loaded, and large pages cannot be asked of the C library in any
/// other way, so it starts itself again once, under its own name. Programs that it starts
/// later have the user's GLIBC_TUNABLES, not its own.
void applyRuntimeSettings(char** argv);

}  // namespace restenosis
