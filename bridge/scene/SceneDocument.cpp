#include "SceneDocument.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace restenosis {
namespace {
/// The parser has met what it takes for impossible: a header whose name begins with no character of a name.
struct ParserAtALoss {};
constexpr void expectedByParser(bool fulfilled) {
  if (!fulfilled) throw ParserAtALoss();
}
}  // namespace
}  // namespace restenosis

// Its assertions would abort the program
#define TOML_ASSERT(expr) restenosis::expectedByParser(static_cast<bool>(expr))
// A scene has no value in a value; the parser's own limit leaves room for so many times as many names
#define TOML_MAX_NESTED_VALUES 16
#include <toml++/toml.h>

#include "NearestName.h"
#include "TomlDepth.h"
#include "Trimmed.h"

namespace restenosis {
namespace {

ScenePlace placeIn(const std::string& file, const toml::source_region& region) {
  return {file, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

decltype(GivenValue::value) valueOf(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::boolean:
      return **node.as_boolean();
    case toml::node_type::integer:
      return **node.as_integer();
    case toml::node_type::floating_point:
      return **node.as_floating_point();
    case toml::node_type::string:
      return **node.as_string();
    case toml::node_type::array:
      return UnusableValue{"a list"};
    case toml::node_type::table:
      return UnusableValue{"a table"};
    default:
      return UnusableValue{"a date or time"};
  }
}

/// A value as typed after `--set key=`: TOML if it is one value of TOML, else the bare text.
decltype(GivenValue::value) typedValue(std::string_view text) {
  try {
    const std::string assignment = fmt::format("value = {}", text);
    if (lineOfDeepName(assignment) != 0) return std::string(text);
    const toml::table table = toml::parse(assignment);
    if (table.size() == 1) return valueOf(table.begin()->second);
  } catch (const toml::parse_error&) {
    // Not TOML, then: a bare word or quantity.
  } catch (const ParserAtALoss&) {
    // Nor this.
  }
  return std::string(text);
}

bool isUtf8(std::string_view text) {
  std::string comment = "# " + std::string(text);
  std::ranges::replace(comment, '\n', ' ');
  try {
    static_cast<void>(toml::parse(comment));
    return true;
  } catch (const toml::parse_error&) {
    return false;
  }
}

/// The first line that begins with a bracket but names no section, from 1.
int lineOfBadHeader(std::string_view toml) {
  for (int line = 1;; ++line) {
    const auto end = toml.find('\n');
    const std::string_view text = trimmed(toml.substr(0, end), " \t\r");
    const std::string_view name = trimmed(text.substr(std::min(text.size(), text.find_first_not_of("[ \t"))));
    const bool named = !name.empty() && (std::isalnum(static_cast<unsigned char>(name.front())) ||
                                         std::string_view("_-\"'").find(name.front()) != name.npos);
    if (text.starts_with('[') && !named) return line;
    if (end == std::string_view::npos) return 1;
    toml.remove_prefix(end + 1);
  }
}

/// "vessel.length or stent.length": the keys, with their sections, that are called `name` or, if there is no
/// such key, by the nearest name. Empty if none is near.
std::string keysCalled(std::string_view name, const KeysOfSections& known) {
  std::vector<std::string_view> all;
  for (const auto& [section, keys] : known) all.insert(all.end(), keys.begin(), keys.end());
  const std::string meant =
      std::ranges::find(all, name) != all.end() ? std::string(name) : nearestName(name, all);
  std::string list;
  for (const auto& [section, keys] : known) {
    if (std::ranges::find(keys, meant) == keys.end()) continue;
    list += fmt::format("{}{}.{}", list.empty() ? "" : " or ", section, meant);
  }
  return list;
}

bool hasSection(const KeysOfSections& known, std::string_view name) {
  return std::ranges::any_of(known, [name](const auto& section) { return section.first == name; });
}

/// What the parser says, and where it speaks of characters only, what to look for.
std::string explained(const toml::parse_error& error) {
  const std::string_view what = error.description();
  const bool unquoted = what.find("expected a comment or whitespace") != std::string_view::npos;
  const bool unclosed = what.find("parsing string") != std::string_view::npos;
  return fmt::format("{}{}", what,
                     unclosed   ? "; is the closing quote missing?"
                     : unquoted ? "; a text, or a number with a unit, stands in quotes: \"1.2 mm\""
                                : "");
}

}  // namespace

SceneDocument::SceneDocument(std::string_view toml, const std::string& file,
                             std::vector<Diagnostic>& diagnostics)
    : file_(file) {
  if (const int line = lineOfDeepName(toml); line != 0) {
    broken_ = true;
    diagnostics.push_back(
        {file, line, 1,
         fmt::format("a name of more than {} parts with points between them; keys are named "
                     "by themselves, below a header such as [vessel]",
                     mostNameParts)});
    return;
  }
  toml::table root;
  try {
    root = toml::parse(toml);
  } catch (const toml::parse_error& error) {
    broken_ = true;
    const ScenePlace place = placeIn(file, error.source());
    diagnostics.push_back({file, place.line, place.column,
                           fmt::format("not valid TOML (column {}): {}", place.column, explained(error))});
    return;
  } catch (const ParserAtALoss&) {
    broken_ = true;
    diagnostics.push_back({file, lineOfBadHeader(toml), 1,
                           "not valid TOML: a section's header names it between brackets, as [vessel]"});
    return;
  }
  for (const auto& [key, node] : root) {
    const std::string name(key.str());
    const ScenePlace place = placeIn(file, key.source());
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      diagnostics.push_back({file, place.line, place.column,
                             node.is_array_of_tables()
                                 ? fmt::format("[[{}]] is a list; write [{}]", name, name)
                                 : fmt::format("'{}' stands outside of any section; keys belong under a "
                                               "header such as [vessel]",
                                               name)});
      continue;
    }
    GivenSection& section = sections_[name];
    section.place = place;
    for (const auto& [entryKey, entry] : *table) {
      section.values[std::string(entryKey.str())] = {valueOf(entry), placeIn(file, entryKey.source()), {}};
    }
  }
}

void SceneDocument::apply(const SceneOverride& override, std::vector<Diagnostic>& diagnostics,
                          const KeysOfSections& known) {
  const std::string_view text = override.text;
  const auto equals = text.find('=');
  const std::string_view name = trimmed(text.substr(0, equals));
  const std::string set = fmt::format("--set {}", name.empty() ? "''" : name);
  const ScenePlace place{override.place.empty() ? set : override.place, 0, 0};
  const auto complain = [&](std::string message) {
    diagnostics.push_back({place.file, 0, 0, std::move(message)});
  };
  if (equals == std::string_view::npos) {
    return complain("no value; write section.key=value, section=absent or section=present");
  }
  const std::string_view value = trimmed(text.substr(equals + 1));
  if (!isUtf8(text)) return complain("is not text in UTF-8 without control characters");
  const auto dot = name.find('.');
  const std::string section(trimmed(name.substr(0, dot)));
  if (section.empty()) return complain("no section; write section.key=value");

  if (dot == std::string_view::npos) {
    if (value == "absent") {
      sections_.erase(section);
      removed_.emplace(section, place);
    } else if (value == "present") {
      sections_.try_emplace(section, GivenSection{place, {}});
    } else if (const std::string meant = keysCalled(section, known);
               !meant.empty() && !hasSection(known, section)) {
      complain(fmt::format("no section; write section.key=value; did you mean {}?", meant));
    } else {
      complain(fmt::format("write {}.key=value for a key, or {}=absent or {}=present for the whole section",
                           section, section, section));
    }
    return;
  }
  const std::string key(trimmed(name.substr(dot + 1)));
  if (key.empty()) return complain("no key; write section.key=value");
  sections_.try_emplace(section, GivenSection{place, {}}).first->second.values[key] = {
      typedValue(value), place, std::string(value)};
}

const GivenSection* SceneDocument::find(std::string_view section) const {
  const auto found = sections_.find(section);
  return found == sections_.end() ? nullptr : &found->second;
}

const GivenValue* SceneDocument::find(std::string_view section, std::string_view key) const {
  const GivenSection* given = find(section);
  if (given == nullptr) return nullptr;
  const auto found = given->values.find(key);
  return found == given->values.end() ? nullptr : &found->second;
}

ScenePlace SceneDocument::placeOf(std::string_view section, std::string_view key) const {
  if (const GivenValue* value = find(section, key)) return value->place;
  const GivenSection* given = find(section);
  return given == nullptr ? ScenePlace{file_, 1, 1} : given->place;
}

}  // namespace restenosis
