#include "bridge/coupling/StentedSection.h"

#include <algorithm>

namespace restenosis {
namespace {

constexpr double marginWidths = 2.5;

struct Struts {
  Section section;  ///< between the outermost centrelines
  double margin;
};

Struts outermost(const Stent& stent, double length) {
  Struts struts{.section = {length, 0.0}, .margin = 0.0};
  for (const auto& segment : stent.segments) {
    struts.section.from = std::min({struts.section.from, segment.a.z(), segment.b.z()});
    struts.section.to = std::max({struts.section.to, segment.a.z(), segment.b.z()});
    struts.margin = std::max(struts.margin, marginWidths * segment.width);
  }
  return struts;
}

}  // namespace

Section stentedSection(const std::optional<Stent>& stent, double length) {
  if (!stent || stent->segments.empty()) return {0.0, length};
  const auto [section, margin] = outermost(*stent, length);
  return {std::max(0.0, section.from - margin), std::min(length, section.to + margin)};
}

Section histologySection(const std::optional<Stent>& stent, double length) {
  if (!stent || stent->segments.empty()) return {0.0, length};
  const auto [section, margin] = outermost(*stent, length);
  return section.to - section.from < 2 * margin ? stentedSection(stent, length) : section;
}

}  // namespace restenosis
