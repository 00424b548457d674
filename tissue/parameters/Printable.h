#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace restenosis {

/// Text of files, names and command lines, made safe for a terminal. A byte that is no UTF-8 and an invisible
/// character (control characters, among them the escape that begins a terminal's commands; marks that change
/// the direction of writing, have no width or no meaning yet) become escapes as in TOML and C++: "\x1b",
/// "\u202e". Line breaks and tabs too, unless `lines` is true, for text of several lines.
std::string printable(std::string_view text, bool lines = false);

/// Number of bytes of the first character; 0 where the text is empty or does not begin with valid UTF-8.
std::size_t characterSize(std::string_view text);

}  // namespace restenosis
