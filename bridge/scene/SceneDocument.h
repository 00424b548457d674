#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "bridge/scene/Diagnostic.h"
#include "bridge/scene/SceneOverride.h"

namespace restenosis {

/// A value of a kind that no key has: a table, a list, a date.
struct UnusableValue {
  std::string kind;  ///< "a list"
};

/// One value as given, and where.
struct GivenValue {
  std::variant<bool, std::int64_t, double, std::string, UnusableValue> value;
  ScenePlace place;
  std::string raw;  ///< of an override, its text as typed: words may come without quotes there
};

/// One section as given.
struct GivenSection {
  ScenePlace place;
  std::map<std::string, GivenValue, std::less<>> values;
};

/// Names of all sections and their keys, in the order of the contract.
using KeysOfSections = std::vector<std::pair<std::string_view, std::vector<std::string_view>>>;

/// What a scene file and the overrides say, before anyone asks what it means. Nothing of TOML beyond this.
class SceneDocument {
 public:
  /// Reads TOML. What is wrong is added to `diagnostics`; broken TOML gives one message and an empty
  /// document.
  SceneDocument(std::string_view toml, const std::string& file, std::vector<Diagnostic>& diagnostics);

  /// Applies what the command line says over what the file says:
  ///
  ///   section.key=VALUE   VALUE in TOML, or a word or quantity without quotes (`vessel.length=1.2 mm`);
  ///                       adds the section where the scene has none
  ///   section=present     adds the section with its defaults, if the scene has none
  ///   section=absent      takes the section out of the scene
  ///
  /// Of a key without its section the message says what may be meant among `known`.
  void apply(const SceneOverride& override, std::vector<Diagnostic>& diagnostics,
             const KeysOfSections& known = {});

  /// Puts keys of one section into another that does not give them itself; returns which.
  std::vector<std::string> moveKeys(std::string_view from, std::string_view to,
                                    std::span<const std::string_view> keys);

  const std::string& file() const { return file_; }
  const std::map<std::string, GivenSection, std::less<>>& sections() const { return sections_; }
  /// The sections that were taken out, whether there were such or not, and what took them out.
  const std::map<std::string, ScenePlace, std::less<>>& removed() const { return removed_; }
  /// The section, or null when it is not given.
  const GivenSection* find(std::string_view section) const;
  /// The value given for a key, or null.
  const GivenValue* find(std::string_view section, std::string_view key) const;
  /// Where the key is given, else its section, else the file's first line. An empty key asks for the section.
  ScenePlace placeOf(std::string_view section, std::string_view key) const;
  bool broken() const { return broken_; }

 private:
  std::string file_;
  std::map<std::string, GivenSection, std::less<>> sections_;
  std::map<std::string, ScenePlace, std::less<>> removed_;
  bool broken_ = false;
};

}  // namespace restenosis
