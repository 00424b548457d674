#pragma once

namespace restenosis {

/// The exit status of a command that has written to standard output: `status`, or ExitStatus::failed where
/// the command was done but its output could not be written, which is told on standard error. A reader that
/// has read enough (`| head -1`) is no failure.
int statusWithOutput(int status);

}  // namespace restenosis
