#include "bridge/compare/FlowComparison.h"

#include <chrono>

namespace restenosis {
namespace {

FieldDifference alongVessel(const SolvedFlow& reference, const SolvedFlow& other, std::size_t first,
                            std::size_t count) {
  FieldDifferenceSum sum;
  for (std::size_t i = first; i < first + count; ++i)
    sum.add(reference.velocities[i].z(), other.velocities[i].z(), 1.0);
  return sum.result();
}

}  // namespace

SolvedFlow solveForComparison(FlowBackend& backend, const TriSurface& lumen, const ProbeLines& lines,
                              const FlowConditions& conditions, const std::filesystem::path& caseFolder) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  SolvedFlow flow;
  flow.backend = backend.name();
  flow.solution = backend.solve(lumen, conditions, caseFolder);
  flow.seconds = std::chrono::duration<double>(Clock::now() - began).count();
  flow.velocities = backend.velocities(lines.points());
  return flow;
}

FlowComparison compareFlows(const TriSurface& lumen, const ProbeLines& lines, const SolvedFlow& reference,
                            const SolvedFlow& other, std::span<const Vec3> struts) {
  FlowComparison c;
  c.faces = comparedFaces(lumen, struts);
  c.traction = {carriedTraction(lumen, c.faces, reference.solution),
                carriedTraction(lumen, c.faces, other.solution)};
  std::array<FieldDifferenceSum, comparedParts.size()> parts;
  FieldDifferenceSum wall, strut;
  for (std::size_t i = 0; i < c.faces.size(); ++i) {
    const double a = c.traction[0][i].norm(), b = c.traction[1][i].norm();
    const ComparedPart part = c.faces.part[i];
    parts[static_cast<std::size_t>(part)].add(a, b, c.faces.area[i]);
    if (part == ComparedPart::strut) strut.add(a, b, c.faces.area[i]);
    if (part == ComparedPart::smoothWall || part == ComparedPart::betweenStruts)
      wall.add(a, b, c.faces.area[i]);
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    c.parts[p] = parts[p].result();
    c.unknownFaces += parts[p].unknown();
  }
  c.wall = wall.result();
  c.strut = strut.result();
  c.lines = lines;
  c.hasVelocities = !reference.velocities.empty() && !other.velocities.empty();
  if (!c.hasVelocities) return c;
  c.axis = alongVessel(reference, other, 0, lines.axis.size());
  std::size_t first = lines.axis.size();
  for (const auto& plane : lines.planes) {
    c.planes.push_back(alongVessel(reference, other, first, plane.points.size()));
    first += plane.points.size();
  }
  return c;
}

}  // namespace restenosis
