#include "StlText.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <system_error>

#include "Shown.h"
#include "Trimmed.h"

namespace restenosis {
namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t\v\f\r";

/// Takes the first word off a trimmed text.
std::string_view takeWord(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text = trimmed(text.substr(word.size()), blanks);
  return word;
}

class StlTextParser {
 public:
  StlTextParser(std::string_view text, std::string_view name) : text_(text), name_(name) {
    if (text_.starts_with(byteOrderMark)) text_.remove_prefix(byteOrderMark.size());
    lineEnd_ = text_.find('\n') == std::string_view::npos ? '\r' : '\n';
  }

  StlTriangles parse() {
    while (nextLine()) {
      if (word_ != "solid") refuseLine("'solid'", result_.names.empty() ? ": is it an STL file?" : "");
      result_.names.emplace_back(arguments_);
      while (nextLine() && word_ != "endsolid")
        if (word_ == "facet") {
          parseFacet();
        } else if (word_ != "color") {
          refuseLine("'facet' or 'endsolid'");
        }
    }
    return std::move(result_);
  }

 private:
  /// Goes to the next line that is not empty; false at the end of the text.
  bool nextLine() {
    while (!text_.empty()) {
      ++number_;
      const auto end = text_.find(lineEnd_);
      line_ = trimmed(text_.substr(0, end), blanks);
      text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
      if (line_.empty()) continue;
      arguments_ = line_;
      word_ = takeWord(arguments_);
      std::transform(word_.begin(), word_.end(), word_.begin(),
                     [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
      return true;
    }
    return false;
  }

  void parseFacet() {
    std::array<double, 9> corners{};
    require("outer", "'outer loop'");
    for (auto corner = corners.begin(); corner != corners.end(); corner += 3) {
      require("vertex", "'vertex'");
      parseVertex(&*corner);
    }
    require("endloop", "'endloop' after the three vertices of a triangle");
    require("endfacet", "'endfacet'");
    result_.corners.push_back(corners);
    result_.solid.push_back(static_cast<std::uint32_t>(result_.names.size() - 1));
  }

  void parseVertex(double* coordinates) {
    std::string_view rest = arguments_;
    for (int k = 0; k < 3; ++k) {
      if (rest.empty()) refuseLine("'vertex' and three numbers");
      coordinates[k] = numberOf(takeWord(rest));
    }
    if (!rest.empty()) refuseLine("'vertex' and three numbers");
  }

  double numberOf(std::string_view word) const {
    const char* const last = word.data() + word.size();
    const char* const first = word.starts_with('+') ? word.data() + 1 : word.data();
    double value = 0.0;
    const auto [end, error] = std::from_chars(first, last, value);
    if (error == std::errc::invalid_argument || end != last)
      refuse(fmt::format("{} is not a number{}", shown(word),
                         word.find(',') == std::string_view::npos ? "" : ": its decimals need a point"));
    // As a binary file may hold: with larger ones squares would not be finite
    if (error != std::errc() || !std::isfinite(static_cast<float>(value)))
      refuse(fmt::format("{} is not a finite number of single precision", shown(word)));
    return value;
  }

  void require(std::string_view word, std::string_view expected) {
    if (!nextLine()) refuse(fmt::format("the file is cut off: {} must follow", expected));
    if (word_ != word) refuseLine(expected);
  }

  [[noreturn]] void refuseLine(std::string_view expected, std::string_view remark = "") const {
    refuse(fmt::format("expected {}, found {}{}", expected, shown(line_), remark));
  }

  [[noreturn]] void refuse(std::string_view what) const {
    throw std::runtime_error(fmt::format("{}:{}: {}", name_, number_, what));
  }

  std::string_view text_;  ///< what is left of it
  std::string_view name_;
  char lineEnd_;
  std::size_t number_ = 0;
  std::string_view line_, arguments_;  ///< of this line, without blanks around
  std::string word_;                   ///< the line's first, in lower case
  StlTriangles result_;
};

}  // namespace

StlTriangles parseStlText(std::string_view text, std::string_view name) {
  return StlTextParser(text, name).parse();
}

}  // namespace restenosis
