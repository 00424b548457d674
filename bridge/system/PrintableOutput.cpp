#include "bridge/system/PrintableOutput.h"

#include <iostream>
#include <streambuf>
#include <string>
#include <string_view>

#include "tissue/parameters/Printable.h"

namespace restenosis {
namespace {

/// The bytes at the end of a text that a character begins with, the rest of which is still to come.
std::size_t begunAtEnd(std::string_view text) {
  for (std::size_t k = 1; k <= 3 && k <= text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[text.size() - k]);
    if ((byte & 0xC0) == 0x80) continue;
    return byte >= 0xF0 ? (k < 4 ? k : 0) : byte >= 0xE0 ? (k < 3 ? k : 0) : byte >= 0xC0 && k < 2 ? k : 0;
  }
  return 0;
}

}  // namespace

class PrintableOutput::Buffer : public std::streambuf {
 public:
  explicit Buffer(std::ostream& stream) : stream_(stream), target_(stream.rdbuf()) { stream.rdbuf(this); }
  ~Buffer() override {
    const auto state = stream_.rdstate();
    if (!state) stream_.flush();
    const auto after = stream_.rdstate();
    stream_.rdbuf(target_);  // takes the stream for good again
    stream_.clear(after);
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  std::streambuf* target() const { return target_; }

 protected:
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char byte = traits_type::to_char_type(c);
    return xsputn(&byte, 1) == 1 ? c : traits_type::eof();
  }

  std::streamsize xsputn(const char* text, std::streamsize size) override {
    begun_.append(text, static_cast<std::size_t>(size));
    return write(begun_.size() - begunAtEnd(begun_)) ? size : 0;
  }

  int sync() override { return write(begun_.size()) && target_->pubsync() == 0 ? 0 : -1; }

 private:
  bool write(std::size_t size) {
    const std::string text = printable(std::string_view(begun_).substr(0, size), true);
    begun_.erase(0, size);
    return target_->sputn(text.data(), static_cast<std::streamsize>(text.size())) ==
           static_cast<std::streamsize>(text.size());
  }

  std::ostream& stream_;
  std::streambuf* target_;
  std::string begun_;  ///< of a character
};

PrintableOutput::PrintableOutput()
    : out_(std::make_unique<Buffer>(std::cout)), errors_(std::make_unique<Buffer>(std::cerr)) {}

PrintableOutput::~PrintableOutput() = default;

std::ostream& PrintableOutput::terminal() {
  static std::ostream stream(nullptr);
  const auto* filter = dynamic_cast<const Buffer*>(std::cerr.rdbuf());
  if (filter == nullptr) return std::cerr;
  if (stream.rdbuf() != filter->target()) stream.rdbuf(filter->target());
  return stream;
}

}  // namespace restenosis
