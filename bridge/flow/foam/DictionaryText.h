#pragma once

#include <string>
#include <string_view>

namespace restenosis {

/// The text of an OpenFOAM dictionary with one entry a line, whose values are replaced while its comments and
/// layout stay.
class DictionaryText {
 public:
  explicit DictionaryText(std::string text) : text_(std::move(text)) {}
  /// The value of a top-level entry, as written. Throws std::invalid_argument where there is none.
  std::string get(std::string_view key) const;
  /// Replaces the value. Throws std::invalid_argument where there is no such entry.
  void set(std::string_view key, std::string_view value);
  /// The same with a number, written so that it reads back unchanged.
  void set(std::string_view key, double value);
  const std::string& text() const { return text_; }

 private:
  /// Start and length of the value in the text.
  std::pair<std::size_t, std::size_t> find(std::string_view key) const;
  std::string text_;
};

}  // namespace restenosis
