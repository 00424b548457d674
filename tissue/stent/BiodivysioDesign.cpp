#include <fmt/format.h>

#include <numbers>

#include "tissue/stent/StentDesign.h"

namespace restenosis {

std::vector<StrutSegment> buildBiodivysio(const StentParameters& stent, const StentLayout& layout) {
  using std::numbers::pi;
  std::vector<StrutSegment> segments;
  const auto places = ringPlaces(stent.ringCount, stent.ringAmplitude + stent.strutWidth / 2, stent, layout);
  const auto phaseOf = [](std::size_t ring) { return ring % 2 == 0 ? 0.0 : pi; };
  for (std::size_t ring = 0; ring < places.size(); ++ring) {
    appendRing(segments, places[ring], stent.ringAmplitude, stent.ringWaves, phaseOf(ring), stent, layout);
  }
  for (std::size_t ring = 0; ring + 1 < places.size(); ++ring) {
    for (std::int64_t link = 0; link < stent.linkCount; ++link) {
      const std::int64_t crest = link * stent.ringWaves / stent.linkCount;
      const double angle = (pi / 2 - phaseOf(ring) + 2 * pi * static_cast<double>(crest)) /
                           static_cast<double>(stent.ringWaves);
      appendLine(segments, {angle, places[ring] + stent.ringAmplitude},
                 {angle, places[ring + 1] - stent.ringAmplitude}, stent, layout);
    }
  }
  return segments;
}

std::vector<ParameterProblem> checkBiodivysio(const StentParameters& stent, const VesselParameters&) {
  auto problems = checkRingsOf(stent.strutWidth + 2 * stent.ringAmplitude, stent);
  for (ParameterProblem& problem : problems) problem.others.emplace_back("stent.ringAmplitude");
  if (stent.linkCount > stent.ringWaves) {
    problems.push_back({"stent.linkCount",
                        fmt::format("{} links need as many crests, but a ring has {} (stent.ringWaves)",
                                    stent.linkCount, stent.ringWaves),
                        {"stent.ringWaves"}});
  }
  return problems;
}

}  // namespace restenosis
