#pragma once

namespace restenosis {

/// Makes the process independent of how its starter has left it:
///
/// - SIGINT and SIGTERM end it, also where it was started to ignore them, as a script's `&` does.
/// - A pipe whose reader has gone, and a file larger than the system allows, fail to be written instead of
///   ending it.
/// - Standard input, output and error are open, so that no file of results takes the place of one. What is
///   written to one that was closed fails to be written.
///
/// And makes freed arrays of up to 16 MiB stay with the program, as the end of the heap up to 64 MiB does,
/// where the C library is glibc: every step asks for them again, and each page of what went back to the
/// system costs a fault when it comes again. Larger ones go back; glibc, left to itself, keeps those of up to
/// 32 MiB, and a vessel of 640,000 agents has a tenth more memory.
void setUpProcess();

}  // namespace restenosis
