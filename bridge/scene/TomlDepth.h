#pragma once

#include <string_view>

namespace restenosis {

/// What a scene's text may nest, assumed: a scene has sections and keys in them, two. The parser makes a
/// table for every part of a dotted name, and takes them down one within the other: hundreds of thousands
/// would use up its stack.
constexpr int mostNameParts = 16;

/// The line, from 1, of the first name of more than `mostNameParts` parts, in a header, before an equals sign
/// or in an inline table; 0 where there is none. Texts in quotes and comments hold no names. Of text that is
/// no TOML it may name a line that is no name, or none: then the parser stops at an earlier line.
int lineOfDeepName(std::string_view toml);

}  // namespace restenosis
