#include "tissue/vessel/WallPacking.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "tissue/agents/RandomStream.h"
#include "tissue/vessel/Cylindrical.h"
#include "tissue/vessel/EndPlanes.h"
#include "tissue/vessel/LaminaSurfaces.h"
#include "tissue/vessel/OuterConfinement.h"
#include "tissue/vessel/PoissonScatter.h"
#include "tissue/vessel/WallBonds.h"

namespace restenosis {
namespace {

constexpr double radiusCut = 3;  // standard deviations

double drawRadius(const VesselParameters& vessel, AgentId id, std::uint64_t seed) {
  if (vessel.radiusSpread == 0) return vessel.cellRadius;
  RandomStream stream(seed, id, 0, RandomPurpose::radius);
  double deviation = stream.normal();
  while (std::abs(deviation) > radiusCut) deviation = stream.normal();
  return vessel.cellRadius * (1 + vessel.radiusSpread * deviation);
}

std::vector<Vec3> positions(const AgentStore& agents) {
  std::vector<Vec3> all(agents.size());
  for (Index i = 0; i < agents.size(); ++i) all[i] = agents.position(i);
  return all;
}

/// Measures the displacement of agents from where they were `held`.
void measureRelease(const std::vector<Vec3>& held, const AgentStore& agents, PackingReport& report) {
  double squares = 0, outwards = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    const Vec3 position = agents.position(i);
    squares += (position - held[i]).squaredNorm();
    if (agents.kind[i] == AgentKind::iel) outwards += radiusOf(position) - radiusOf(held[i]);
  }
  if (agents.size() > 0) report.rmsMove = std::sqrt(squares / static_cast<double>(agents.size()));
  if (report.counts.iel > 0) report.ielDrift = outwards / static_cast<double>(report.counts.iel);
}

Index countExpelled(const Wall& wall) {
  const RadiusMap iel(wall.agents, AgentKind::iel, 2 * wall.cellRadius);
  const RadiusMap eel(wall.agents, AgentKind::eel, 2 * wall.cellRadius);
  Index expelled = 0;
  for (Index i = 0; i < wall.agents.size(); ++i) {
    if (wall.agents.kind[i] != AgentKind::smc) continue;
    const Vec3 position = wall.agents.position(i);
    const double radius = radiusOf(position);
    expelled += radius < iel.at(position) || radius > eel.at(position);
  }
  return expelled;
}

}  // namespace

Wall scatterWall(const VesselParameters& vessel, const WallShape& shape, std::uint64_t seed,
                 const std::function<void()>& meanwhile) {
  const AgentCounts counts = countAgents(vessel, shape);
  Wall wall = emptyWall(vessel);
  const double widest = radiusCut * vessel.radiusSpread * vessel.cellRadius;
  PoissonScatter scatter(seed, vessel.length, shape.eel.greatest(), counts.total(),
                         vessel.cellRadius + widest);
  scatter.setCallback(meanwhile);
  wall.agents.reserve(counts.total());
  const auto add = [&](AgentKind kind, Index count, const SurfaceFromAxis& from, const SurfaceFromAxis& to) {
    scatter.add(
        wall.agents, kind, count, [&](AgentId id) { return drawRadius(vessel, id, seed); }, from, to);
  };
  add(AgentKind::iel, counts.iel, shape.iel, shape.iel);
  add(AgentKind::eel, counts.eel, shape.eel, shape.eel);
  add(AgentKind::smc, counts.smc, shape.inner, shape.outer);
  wall.bonds.resize(wall.agents.size());
  return wall;
}

Wall packWall(const VesselParameters& vessel, const MechanicsParameters& mechanics,
              const RelaxationParameters& relaxation, std::uint64_t seed, PackingReport* report) {
  return packWall(vessel, cylindricalShape(vessel), mechanics, relaxation, seed, report);
}

Wall packWall(const VesselParameters& vessel, const WallShape& shape, const MechanicsParameters& mechanics,
              const RelaxationParameters& asked, std::uint64_t seed, PackingReport* report,
              const std::function<void()>& meanwhile) {
  PackingReport done;
  done.counts = countAgents(vessel, shape);
  Wall wall = scatterWall(vessel, shape, seed, meanwhile);
  orderInSpace(wall);

  // Packing always runs to equilibrium: the scene's effort and mobility are for deployment and growth.
  RelaxationParameters settings = asked;
  settings.minimiser = RelaxationParameters().minimiser;
  settings.axialForceFactor = 1;
  settings.maximumIterations = std::max<std::int64_t>(asked.maximumIterations, 20000);
  settings.stopAtMaximum = false;
  Relaxation relaxation(mechanics, settings, vessel.cellRadius);
  relaxation.setCallback(meanwhile);
  const auto relax = [&](std::span<const Constraint* const> constraints) {
    try {
      return relaxation.relax(wall.agents, wall.bonds, constraints);
    } catch (const RelaxationFailed& failure) {
      throw RelaxationFailed(
          fmt::format(
              "the packed wall did not come to rest: after {} iterations agent {} would still move by {:.3g} "
              "of its radius, and relaxation.tolerance = {}. Choose a larger tolerance, relaxation.stepLimit "
              "(now {}) or relaxation.maximumIterations",
              failure.report.iterations, failure.worstAgent, failure.report.residual, asked.tolerance,
              asked.stepLimit),
          failure.report, failure.worstAgent);
    }
  };

  const EndPlanes ends(vessel.length);
  const LaminaSurfaces surfaces(shape);
  const std::array<const Constraint*, 2> packing = {&surfaces, &ends};
  done.packed = relax(packing);

  // Bonds are made before the laminae are released: those of the IEL then carry the pressure that its surface
  // carried, which would otherwise push it some micrometres into the lumen.
  orderInSpace(wall);
  done.bonds = bondWall(wall, vessel.bondRange);
  const std::vector<Vec3> held = positions(wall.agents);
  const OuterConfinement outside(wall.agents, vessel.cellRadius);
  const std::array<const Constraint*, 2> released = {&outside, &ends};
  done.released = relax(released);
  measureRelease(held, wall.agents, done);
  done.expelled = countExpelled(wall);
  fixEnds(wall, vessel.fixedEnds);
  if (report) *report = done;
  return wall;
}

Wall adoptWall(const VesselParameters& vessel, AgentStore agents) {
  Wall wall = emptyWall(vessel);
  wall.agents = std::move(agents);
  orderInSpace(wall);
  bondWall(wall, vessel.bondRange);
  fixEnds(wall, vessel.fixedEnds);
  return wall;
}

}  // namespace restenosis
