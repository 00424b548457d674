#include "tissue/parameters/Printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace restenosis {
namespace {

struct Range {
  char32_t first, last;
};

/// Characters that are invisible or change how their neighbours are shown: categories Cc, Cf, Zl, Zp, Cs and
/// Co of Unicode 15, its variation selectors, letters without a shape, and noncharacters.
constexpr std::array<Range, 30> invisible = {
    {{0x00, 0x1F},       {0x7F, 0x9F},       {0xAD, 0xAD},       {0x34F, 0x34F},     {0x600, 0x605},
     {0x61C, 0x61C},     {0x6DD, 0x6DD},     {0x70F, 0x70F},     {0x890, 0x891},     {0x8E2, 0x8E2},
     {0x115F, 0x1160},   {0x17B4, 0x17B5},   {0x180B, 0x180F},   {0x200B, 0x200F},   {0x2028, 0x202E},
     {0x2060, 0x206F},   {0x3164, 0x3164},   {0xD800, 0xF8FF},   {0xFDD0, 0xFDEF},   {0xFE00, 0xFE0F},
     {0xFEFF, 0xFEFF},   {0xFFA0, 0xFFA0},   {0xFFF0, 0xFFFB},   {0xFFFE, 0xFFFF},   {0x110BD, 0x110BD},
     {0x110CD, 0x110CD}, {0x13430, 0x1343F}, {0x1BCA0, 0x1BCA3}, {0x1D173, 0x1D17A}, {0xE0000, 0x10FFFF}}};

bool isInvisible(char32_t character) {
  return std::ranges::any_of(
      invisible, [character](const Range& r) { return r.first <= character && character <= r.last; });
}

/// The character of `size` bytes at the beginning of a text.
char32_t decoded(std::string_view text, std::size_t size) {
  constexpr std::array<unsigned char, 5> leadBits = {0, 0x7F, 0x1F, 0x0F, 0x07};
  char32_t character = static_cast<unsigned char>(text[0]) & leadBits[size];
  for (std::size_t k = 1; k < size; ++k)
    character = (character << 6) | (static_cast<unsigned char>(text[k]) & 0x3F);
  return character;
}

}  // namespace

std::size_t characterSize(std::string_view text) {
  if (text.empty()) return 0;
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t size = lead < 0x80                   ? 1
                           : lead >= 0xC2 && lead < 0xE0 ? 2
                           : lead >= 0xE0 && lead < 0xF0 ? 3
                           : lead >= 0xF0 && lead < 0xF5 ? 4
                                                         : 0;
  if (size == 0 || text.size() < size) return 0;
  for (std::size_t k = 1; k < size; ++k)
    if ((static_cast<unsigned char>(text[k]) & 0xC0) != 0x80) return 0;
  // Invalid: an overlong encoding, a UTF-16 surrogate, or past the last character
  constexpr std::array<char32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
  const char32_t character = decoded(text, size);
  const bool valid =
      character >= least[size] && character <= 0x10FFFF && !(character >= 0xD800 && character < 0xE000);
  return valid ? size : 0;
}

std::string printable(std::string_view text, bool lines) {
  std::string result;
  result.reserve(text.size());
  const auto escape = [&result](auto pattern, char32_t value) {
    fmt::format_to(std::back_inserter(result), pattern, static_cast<std::uint32_t>(value));
  };
  while (!text.empty()) {
    const std::size_t size = characterSize(text);
    if (size == 0) {
      escape(FMT_STRING("\\x{:02x}"), static_cast<unsigned char>(text[0]));
      text.remove_prefix(1);
      continue;
    }
    const char32_t character = decoded(text, size);
    if (character == '\n' || character == '\t') {
      if (lines)
        result += text[0];
      else
        result += character == '\n' ? "\\n" : "\\t";
    } else if (!isInvisible(character)) {
      result += text.substr(0, size);
    } else if (character < 0x80) {
      escape(FMT_STRING("\\x{:02x}"), character);
    } else if (character < 0x10000) {
      escape(FMT_STRING("\\u{:04x}"), character);
    } else {
      escape(FMT_STRING("\\U{:08x}"), character);
    }
    text.remove_prefix(size);
  }
  return result;
}

}  // namespace restenosis
