#include "bridge/flow/foam/FoamBinary.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <stdexcept>

#include "bridge/flow/foam/FoamLog.h"

namespace restenosis {

static_assert(std::endian::native == std::endian::little, "the files' numbers begin with the low byte");

namespace {

template <class T>
std::vector<T> copied(std::string_view bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

template <class T>
std::string listOf(const std::vector<T>& values, std::size_t components) {
  std::string text = fmt::format("{}\n(", values.size() / components);
  text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  return text += ')';
}

}  // namespace

FoamBinary::FoamBinary(const std::filesystem::path& file) : FoamBinary(file, foamLog::read(file)) {}

FoamBinary::FoamBinary(const std::filesystem::path& file, std::string content)
    : file_(file), text_(std::move(content)) {
  if (text_.empty()) fail("is missing or empty");
  skipPast("FoamFile");
  const auto end = text_.find('}', at_);
  if (end == std::string::npos) fail("has no header");
  const std::string_view header = std::string_view(text_).substr(at_, end - at_);
  for (const std::string_view word : {"binary;", "LSB;label=32;scalar=64"})
    if (header.find(word) == std::string_view::npos) fail(fmt::format("is not of the format '{}'", word));
  at_ = end + 1;
}

void FoamBinary::fail(std::string_view what) const {
  throw std::runtime_error(fmt::format("{} {}", file_.string(), what));
}

void FoamBinary::skipPast(std::string_view words) {
  const auto found = text_.find(words, at_);
  if (found == std::string::npos) fail(fmt::format("has no '{}'", words));
  at_ = found + words.size();
}

std::string_view FoamBinary::list(std::size_t entry) {
  const auto blank = [&] { at_ = std::min(text_.find_first_not_of(" \t\n", at_), text_.size()); };
  blank();
  while (text_.compare(at_, 2, "//") == 0) {
    at_ = std::min(text_.find('\n', at_), text_.size());
    blank();
  }
  const auto end = std::min(text_.find_first_not_of("0123456789", at_), text_.size());
  if (end == at_ || end - at_ > 10) fail("has no list where one is expected");
  const std::size_t count = std::stoull(text_.substr(at_, end - at_));
  at_ = end;
  blank();
  const std::size_t size = count * entry;
  if (at_ >= text_.size() || text_[at_] != '(' || text_.size() - at_ < size + 2 ||
      text_[at_ + 1 + size] != ')')
    fail("has a list that is cut off");
  const std::string_view bytes = std::string_view(text_).substr(at_ + 1, size);
  at_ += size + 2;
  return bytes;
}

std::vector<double> FoamBinary::numbers(std::size_t components) {
  return copied<double>(list(components * sizeof(double)));
}

std::vector<std::int32_t> FoamBinary::labels() { return copied<std::int32_t>(list(sizeof(std::int32_t))); }

std::string foamBinaryList(const std::vector<double>& numbers, std::size_t components) {
  return listOf(numbers, components);
}

std::string foamBinaryList(const std::vector<std::int32_t>& labels) { return listOf(labels, 1); }

}  // namespace restenosis
