#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace restenosis {

/// What a terminal may be given of text from files, names and command lines: a byte that is no UTF-8 and a
/// character that is not seen but obeyed (control characters, among them the escape that begins a terminal's
/// commands; marks that turn the direction of writing, have no width or no meaning yet) become escapes as
/// TOML and C++ write them:
/// "\x1b", "\u202e". Line breaks and tabs too, unless `lines` is true, for text of several lines.
std::string printable(std::string_view text, bool lines = false);

/// The bytes of the first character, or 0 where the text is empty or does not begin with one of UTF-8.
std::size_t characterSize(std::string_view text);

}  // namespace restenosis
