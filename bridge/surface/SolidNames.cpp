#include "bridge/surface/SolidNames.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "tissue/parameters/Shown.h"

namespace restenosis {
namespace {

using Meanings = std::vector<SurfaceRegion>;

constexpr std::array<std::pair<std::string_view, SurfaceRegion>, 14> certain{
    {{"inlet", SurfaceRegion::inlet},
     {"inlets", SurfaceRegion::inlet},
     {"inflow", SurfaceRegion::inlet},
     {"inflows", SurfaceRegion::inlet},
     {"outlet", SurfaceRegion::outlet},
     {"outlets", SurfaceRegion::outlet},
     {"outflow", SurfaceRegion::outlet},
     {"outflows", SurfaceRegion::outlet},
     {"wall", SurfaceRegion::wall},
     {"walls", SurfaceRegion::wall},
     {"stent", SurfaceRegion::strut},
     {"stents", SurfaceRegion::strut},
     {"strut", SurfaceRegion::strut},
     {"struts", SurfaceRegion::strut}}};
constexpr std::array<std::string_view, 7> places{"lumen",   "vessel", "artery", "segment",
                                                 "section", "region", "zone"};
constexpr std::array<std::pair<std::string_view, SurfaceRegion>, 2> directions{
    {{"in", SurfaceRegion::inlet}, {"out", SurfaceRegion::outlet}}};

// Of ASCII, so that no locale matters; what else there is belongs to words
bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isLetter(char c) { return isUpper(c) || (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) > '~'; }

template <std::size_t n>
std::optional<SurfaceRegion> among(const std::array<std::pair<std::string_view, SurfaceRegion>, n>& known,
                                   std::string_view word) {
  for (const auto& [text, region] : known)
    if (text == word) return region;
  return std::nullopt;
}

bool isPlace(std::string_view word) { return std::ranges::find(places, word) != places.end(); }

/// Words of a name in lower case; a number is none.
std::vector<std::string> wordsOf(std::string_view name) {
  std::vector<std::string> words;
  bool within = false;
  for (std::size_t k = 0; k < name.size(); ++k) {
    const char c = name[k];
    if (!isLetter(c)) {
      within = false;
      continue;
    }
    // "vesselInlet", and "STLInlet"
    const bool hump =
        isUpper(c) && k > 0 &&
        (!isUpper(name[k - 1]) || (k + 1 < name.size() && isLetter(name[k + 1]) && !isUpper(name[k + 1])));
    if (!within || hump) words.emplace_back();
    within = true;
    words.back() += isUpper(c) ? static_cast<char>(c - 'A' + 'a') : c;
  }
  // "InFlow", "out-let"
  for (std::size_t k = 0; k + 1 < words.size(); ++k)
    if (among(directions, words[k]) && among(certain, words[k] + words[k + 1])) {
      words[k] += words[k + 1];
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(k + 1));
    }
  return words;
}

void add(Meanings& meanings, SurfaceRegion region) {
  if (std::ranges::find(meanings, region) == meanings.end()) meanings.push_back(region);
}

}  // namespace

Meanings meaningsOf(std::string_view name) {
  const std::vector<std::string> words = wordsOf(name);
  Meanings said;
  for (const auto& word : words)
    if (const auto region = among(certain, word)) add(said, *region);
  const bool anyPlace = std::ranges::any_of(words, isPlace);
  if (std::ranges::find(said, SurfaceRegion::strut) != said.end()) {
    bool inStent = false;
    for (std::size_t k = 0; k + 1 < words.size(); ++k)
      inStent = inStent || (words[k] == "in" && among(certain, words[k + 1]) == SurfaceRegion::strut);
    if (anyPlace || inStent) add(said, SurfaceRegion::wall);
  }
  if (!said.empty() || words.empty()) return said;
  for (const auto& word : {words.front(), words.back()})
    if (const auto region = among(directions, word)) add(said, *region);
  if (said.empty() && anyPlace) said.push_back(SurfaceRegion::wall);
  return said;
}

std::string shownSolids(const std::vector<std::string>& names, const std::vector<std::uint32_t>& solids) {
  constexpr std::size_t mostShown = 3;
  std::vector<std::string> list;
  for (const auto solid : solids) {
    if (list.size() == mostShown) break;
    list.push_back(names[solid].empty() ? fmt::format("{}", solid + 1) : shown(names[solid]));
  }
  if (solids.size() > mostShown)
    return fmt::format("{} solids ({}, ...)", solids.size(), fmt::join(list, ", "));
  if (solids.size() == 1) return "the solid " + list.front();
  const std::string last = list.back();
  list.pop_back();
  return fmt::format("the solids {} and {}", fmt::join(list, ", "), last);
}

std::string shownSolids(const SurfaceSolids& file, std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> solids;
  for (const auto t : triangles)
    if (t < file.solid.size()) solids.push_back(file.solid[t]);
  std::ranges::sort(solids);
  solids.erase(std::unique(solids.begin(), solids.end()), solids.end());
  if (solids.empty() || (file.names.size() == 1 && file.names.front().empty())) return {};
  return shownSolids(file.names, solids);
}

}  // namespace restenosis
