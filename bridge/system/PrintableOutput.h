#pragma once

#include <memory>
#include <ostream>

namespace restenosis {

/// While it lives, whatever is written to std::cout and std::cerr arrives as `printable` leaves it: no title,
/// name or line of a log can command the terminal. Of the program's own only the progress line needs a
/// terminal's commands; it goes to `terminal()`.
class PrintableOutput {
 public:
  PrintableOutput();
  /// Writes what is left. Flush std::cout before, to learn whether it could be written.
  ~PrintableOutput();
  PrintableOutput(const PrintableOutput&) = delete;
  PrintableOutput& operator=(const PrintableOutput&) = delete;

  /// Standard error as it is, for those who make their text printable themselves.
  static std::ostream& terminal();

 private:
  class Buffer;
  std::unique_ptr<Buffer> out_, errors_;
};

}  // namespace restenosis
