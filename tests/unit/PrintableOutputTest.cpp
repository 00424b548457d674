#include <gtest/gtest.h>

#include <iostream>
#include <sstream>

#include "bridge/system/PrintableOutput.h"

namespace restenosis {
namespace {

/// What arrives at one of the standard streams, in place of a terminal.
class Received {
 public:
  explicit Received(std::ostream& stream) : stream_(stream), former_(stream.rdbuf(text_.rdbuf())) {}
  ~Received() { stream_.rdbuf(former_); }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::ostream& stream_;
  std::streambuf* former_;
};

TEST(PrintableOutput, EscapesWhatIsWrittenWhileItLives) {
  const Received out(std::cout), errors(std::cerr);
  {
    const PrintableOutput output;
    std::cout << "title: \x1b]0;mine\x07\n";
    std::cerr << "key \x1b[2J\r\n";
    PrintableOutput::terminal() << "\rday 1\x1b[K";
  }
  std::cout << "\x1b";
  EXPECT_EQ(out.text(), "title: \\x1b]0;mine\\x07\n\x1b");
  EXPECT_EQ(errors.text(), "key \\x1b[2J\\x0d\n\rday 1\x1b[K");
}

TEST(PrintableOutput, PutsTogetherCharactersThatComeInPieces) {
  const Received out(std::cout);
  {
    const PrintableOutput output;
    for (const char byte : std::string("Gefäß ❤ 🫀 \xe2\x9d")) std::cout << byte;
    EXPECT_EQ(out.text(), "Gefäß ❤ 🫀 ");
  }
  EXPECT_EQ(out.text(), "Gefäß ❤ 🫀 \\xe2\\x9d");
}

TEST(PrintableOutput, SaysWhatCouldNotBeWritten) {
  struct Full : std::streambuf {
  } full;
  std::streambuf* const former = std::cout.rdbuf(&full);
  {
    const PrintableOutput output;
    std::cout << "lost\n" << std::flush;
    EXPECT_FALSE(std::cout.good());
  }
  EXPECT_FALSE(std::cout.good());
  std::cout.rdbuf(former);
}

}  // namespace
}  // namespace restenosis
