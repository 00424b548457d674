#include "bridge/coupling/CrossCheck.h"

#include <array>

#include "bridge/compare/CarriedTraction.h"
#include "bridge/compare/ComparedParts.h"
#include "bridge/compare/FieldDifference.h"
#include "bridge/sampling/WssSampling.h"

namespace restenosis {
namespace {

std::optional<StressDifference> differenceOf(const FieldDifferenceSum& sum) {
  const FieldDifference found = sum.result();
  if (found.count == 0) return std::nullopt;
  return StressDifference{found.meanDifference, found.relativeL2};
}

/// By agent: whether it is covered and rests by the stress of this flow.
std::vector<bool> coveredAndAtRest(AgentStore& agents, const Biology& biology, const FlowSolution& flow) {
  agents.wss = sampleWss(agents, flow.wall).wss;
  biology.updateNitricOxide(agents);
  std::vector<bool> atRest(agents.size());
  for (Index i = 0; i < agents.size(); ++i)
    atRest[i] = agents.has(i, covered) && biology.rules().arrest(agents, i);
  return atRest;
}

}  // namespace

CrossCheckRecord stressDifferences(const TriSurface& lumen, std::span<const Vec3> struts,
                                   const FlowSolution& own, const FlowSolution& other) {
  const ComparedFaces faces = comparedFaces(lumen, struts);
  const auto a = carriedTraction(lumen, faces, own), b = carriedTraction(lumen, faces, other);
  std::array<FieldDifferenceSum, comparedParts.size()> parts;
  for (std::size_t i = 0; i < faces.size(); ++i)
    parts[static_cast<std::size_t>(faces.part[i])].add(a[i].norm(), b[i].norm(), faces.area[i]);
  const auto of = [&](ComparedPart part) { return differenceOf(parts[static_cast<std::size_t>(part)]); };
  CrossCheckRecord record;
  record.smoothWall = of(ComparedPart::smoothWall);
  record.nearStruts = of(ComparedPart::betweenStruts);
  record.struts = of(ComparedPart::strut);
  return record;
}

std::optional<double> decidedOtherwise(const AgentStore& agents, const Biology& biology,
                                       const FlowSolution& own, const FlowSolution& other) {
  AgentStore trial = agents;
  const auto before = coveredAndAtRest(trial, biology, own), after = coveredAndAtRest(trial, biology, other);
  std::size_t cells = 0, otherwise = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    cells += agents.has(i, covered) ? 1 : 0;
    otherwise += before[i] != after[i] ? 1 : 0;
  }
  if (cells == 0) return std::nullopt;
  return static_cast<double>(otherwise) / static_cast<double>(cells);
}

}  // namespace restenosis
