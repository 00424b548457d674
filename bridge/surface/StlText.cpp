#include "bridge/surface/StlText.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>

#include "tissue/parameters/Shown.h"
#include "tissue/parameters/Trimmed.h"

namespace restenosis {
namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t\v\f\r";
constexpr std::string_view lineEnds = "\r\n", endsolid = "endsolid";
constexpr std::size_t binaryHeader = 84;

/// Takes the first word off a trimmed text.
std::string_view takeWord(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text = trimmed(text.substr(word.size()), blanks);
  return word;
}

std::string inLowerCase(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

/// Where the first of these words, in lower case, stands behind the first word of a text; its size if
/// nowhere.
std::size_t placeOfNext(std::string_view text, std::span<const std::string_view> words) {
  for (std::size_t at = text.find_first_of(blanks); at != std::string_view::npos;) {
    at = text.find_first_not_of(blanks, at);
    if (at == std::string_view::npos) break;
    const auto end = text.find_first_of(blanks, at);
    const std::string_view word = text.substr(at, end == std::string_view::npos ? end : end - at);
    // Numbers are the most of it
    if (std::isalpha(static_cast<unsigned char>(word.front())) != 0 &&
        std::ranges::find(words, inLowerCase(word)) != words.end())
      return at;
    at = end;
  }
  return text.size();
}

class StlTextParser {
 public:
  StlTextParser(std::string_view text, std::string_view name, bool (*isRest)(std::string_view),
                FileTriangles& result)
      : text_(text), name_(name), isRest_(isRest), result_(result) {
    if (text_.starts_with(byteOrderMark)) text_.remove_prefix(byteOrderMark.size());
  }

  /// Returns what is left of the text.
  std::string_view parse() {
    while (textFollows() && nextStatement()) {
      if (word_ != "solid") refuseLine("'solid'", result_.names.empty() ? ": is it an STL file?" : "");
      const std::string_view name = arguments_;
      result_.names.emplace_back(name);
      while (nextStatement() && word_ != "endsolid")
        if (word_ == "facet") {
          parseFacet();
        } else if (word_ != "color") {
          refuseLine("'facet' or 'endsolid'");
        }
      if (word_ == "endsolid") leaveSolid(name);
    }
    return text_;
  }

 private:
  bool textFollows() const { return isRest_ == nullptr || !line_.empty() || beginsAsStlText(text_); }

  /// Goes to the next line that is not empty; false at the end of the text.
  bool nextLine() {
    while (!text_.empty()) {
      ++number_;
      wholeLine_ = text_;
      const auto end = text_.find_first_of(lineEnds);
      line_ = trimmed(text_.substr(0, end), blanks);
      const bool both = end != std::string_view::npos && text_.substr(end).starts_with("\r\n");
      text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + (both ? 2 : 1));
      if (!line_.empty()) return true;
    }
    return false;
  }

  /// Goes to the next statement, which has a line to itself or shares it with others; false at the end of the
  /// text.
  bool nextStatement() {
    word_.clear();
    if (line_.empty() && !nextLine()) return false;
    if (inLowerCase(line_.substr(0, endsolid.size())) == endsolid) {
      word_ = endsolid;
      statement_ = line_;
      arguments_ = trimmed(line_.substr(endsolid.size()), blanks);
      line_ = {};
      return true;
    }
    constexpr std::array<std::string_view, 7> statements{"facet",    "outer",  "vertex", "endloop",
                                                         "endfacet", endsolid, "color"};
    arguments_ = line_;
    word_ = inLowerCase(takeWord(arguments_));
    const std::size_t end = word_ == "solid" ? endOfName(line_) : placeOfNext(line_, statements);
    statement_ = trimmed(line_.substr(0, end), blanks);
    line_.remove_prefix(end);
    arguments_ = statement_;
    takeWord(arguments_);
    return true;
  }

  /// The name of a solid ends with its line, or in it before the first facet or the end of the solid.
  static std::size_t endOfName(std::string_view line) {
    constexpr std::array<std::string_view, 2> next{"facet", endsolid};
    for (std::size_t at = 0; at < line.size();) {
      at += placeOfNext(line.substr(at), next);
      std::string_view behind = line.substr(at);
      if (inLowerCase(takeWord(behind)) != "facet" || inLowerCase(takeWord(behind)) == "normal") return at;
    }
    return line.size();
  }

  /// Whether a line that may begin a solid does so: its first facet, or its end, follows.
  bool beginsSolid(std::string_view line) const {
    if (endOfName(line) < line.size()) return true;
    const auto next = text_.find_first_not_of(" \t\v\f\r\n");
    if (next == std::string_view::npos) return false;
    const std::string word = inLowerCase(text_.substr(next, endsolid.size()));
    return word.starts_with("facet") || word.starts_with("color") || word == endsolid;
  }

  /// Finds what follows an "endsolid" in its line: mostly nothing but the name. Where files were joined of
  /// which one did not end with a line, the next one follows.
  void leaveSolid(std::string_view name) {
    const auto begin = static_cast<std::size_t>(statement_.data() - wholeLine_.data());
    const std::string_view behindWord = wholeLine_.substr(begin + endsolid.size());
    std::string_view behindName = behindWord;
    behindName.remove_prefix(std::min(behindName.find_first_not_of(blanks), behindName.size()));
    if (name.empty() || !behindName.starts_with(name)) {
      behindName = behindWord;
    } else {
      behindName.remove_prefix(name.size());
    }
    const auto lineOf = [](std::string_view text) { return text.substr(0, text.find_first_of(lineEnds)); };
    if (trimmed(lineOf(behindName), blanks).empty()) return;
    for (const std::string_view rest : {behindName, behindWord}) {
      const std::string_view line = trimmed(lineOf(rest), blanks);
      if (inLowerCase(rest.substr(0, 5)) == "solid" && beginsSolid(line)) {
        line_ = line;
        return;
      }
      if (isRest_ != nullptr && !beginsAsStlText(rest) && isRest_(rest)) {
        text_ = rest;
        return;
      }
    }
    constexpr std::array<std::string_view, 1> solid{"solid"};
    const std::string_view line = lineOf(behindName);
    const std::string_view next = trimmed(line.substr(placeOfNext(line, solid)), blanks);
    if (!next.empty() && beginsSolid(next)) line_ = next;
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
    if (!nextStatement()) refuse(fmt::format("the file is cut off: {} must follow", expected));
    if (word_ != word) refuseLine(expected);
  }

  [[noreturn]] void refuseLine(std::string_view expected, std::string_view remark = "") const {
    refuse(fmt::format("expected {}, found {}{}", expected, shown(statement_), remark));
  }

  [[noreturn]] void refuse(std::string_view what) const {
    throw std::runtime_error(fmt::format("{}:{}: {}", name_, number_, what));
  }

  std::string_view text_;  ///< what is left of it behind this line
  std::string_view name_;
  bool (*isRest_)(std::string_view);
  FileTriangles& result_;
  std::size_t number_ = 0;                  ///< of this line
  std::string_view wholeLine_;              ///< from its beginning to the end of the text
  std::string_view line_;                   ///< what is left of it behind this statement
  std::string_view statement_, arguments_;  ///< without blanks around
  std::string word_;                        ///< the statement's first, in lower case
};

}  // namespace

bool beginsAsStlText(std::string_view content) {
  const std::string_view head = content.substr(0, binaryHeader);
  return std::none_of(head.begin(), head.end(),
                      [](unsigned char c) { return c < ' ' && (c < '\t' || c > '\r'); });
}

void takeStlText(std::string_view& content, std::string_view name, bool (*isRest)(std::string_view),
                 FileTriangles& triangles) {
  content = StlTextParser(content, name, isRest, triangles).parse();
}

FileTriangles parseStlText(std::string_view text, std::string_view name) {
  FileTriangles result;
  takeStlText(text, name, nullptr, result);
  return result;
}

}  // namespace restenosis
