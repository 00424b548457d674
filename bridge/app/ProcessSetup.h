#pragma once

namespace restenosis {

/// Makes the process independent of how its starter has left it:
///
/// - SIGINT and SIGTERM end it, also where it was started to ignore them, as a script's `&` does.
/// - A pipe whose reader has gone, and a file larger than the system allows, fail to be written instead of
///   ending it.
/// - Standard input, output and error are open, so that no file of results takes the place of one. What is
///   written to one that was closed fails to be written.
void setUpProcess();

}  // namespace restenosis
