#pragma once

namespace restenosis {

/// What the program's exit status means.
struct ExitStatus {
  static constexpr int done = 0;
  static constexpr int failed = 1;
  static constexpr int wrongInput = 2;
};

}  // namespace restenosis
