#pragma once

#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <string>

namespace restenosis {

/// What `check` of an option wants: returns what is wrong with its text, or nothing.
using OptionCheck = std::function<std::string(const std::string& text)>;

/// Refuses an empty text, which a shell makes of "$UNSET". `expected` says what to write instead.
inline OptionCheck notEmpty(std::string expected) {
  return [expected = std::move(expected)](const std::string& text) {
    return text.empty() ? fmt::format("is empty; expected: {}", expected) : std::string();
  };
}

/// Of options that name the folder to write into.
inline OptionCheck aFolder() { return notEmpty("a folder, or no such option for the default"); }

/// Refuses all but the whole numbers from 1 to `most`, as people write them.
inline OptionCheck countUpTo(int most) {
  return [most](const std::string& text) {
    int count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    const bool whole =
        error == std::errc() && end == text.data() + text.size() && text == std::to_string(count);
    return whole && count >= 1 && count <= most
               ? std::string()
               : fmt::format("is \"{}\"; a whole number from 1 to {} is expected", text, most);
  };
}

}  // namespace restenosis
