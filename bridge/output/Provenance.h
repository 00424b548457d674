#pragma once

#include <string>

namespace restenosis {

/// How and where a run was started, for people who find its results later.
struct Provenance {
  std::string command;        ///< as a shell would read it
  std::string workingFolder;  ///< that the command was given in
  std::string host;
  std::string started;  ///< of the last start, where it was resumed; as 2026-01-31T23:59:59Z

  /// That of this process, now.
  static Provenance ofThisProcess();
};

/// The time of day, as `Provenance::started` has it.
std::string timeNow();

}  // namespace restenosis
