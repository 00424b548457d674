#include "bridge/flow/foam/DictionaryText.h"

#include <fmt/format.h>

#include <stdexcept>

namespace restenosis {

std::pair<std::size_t, std::size_t> DictionaryText::find(std::string_view key) const {
  for (std::size_t line = 0; line < text_.size();) {
    const auto end = std::min(text_.find('\n', line), text_.size());
    const std::string_view content = std::string_view(text_).substr(line, end - line);
    if (content.starts_with(key) && content.size() > key.size() &&
        (content[key.size()] == ' ' || content[key.size()] == '\t')) {
      const auto value = content.find_first_not_of(" \t", key.size());
      const auto semicolon = content.find(';');
      if (value != std::string_view::npos && semicolon != std::string_view::npos && semicolon > value)
        return {line + value, semicolon - value};
    }
    line = end + 1;
  }
  throw std::invalid_argument(fmt::format("the dictionary has no entry '{}'", key));
}

std::string DictionaryText::get(std::string_view key) const {
  const auto [start, length] = find(key);
  return text_.substr(start, length);
}

void DictionaryText::set(std::string_view key, std::string_view value) {
  const auto [start, length] = find(key);
  text_.replace(start, length, value);
}

void DictionaryText::set(std::string_view key, double value) { set(key, fmt::format("{}", value)); }

}  // namespace restenosis
