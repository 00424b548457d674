#include "tests/support/SyntheticResults.h"

#include <cmath>
#include <numbers>

#include "bridge/output/LumenWriter.h"
#include "bridge/output/ProfileCsv.h"
#include "bridge/output/PvdSeries.h"
#include "bridge/output/StrutWriter.h"
#include "bridge/output/SummaryJson.h"
#include "bridge/output/TimeSeries.h"
#include "bridge/output/TissueWriter.h"
#include "bridge/surface/StrutSurface.h"
#include "bridge/system/AtomicFile.h"
#include "tests/support/Constants.h"
#include "tissue/agents/RandomStream.h"

namespace restenosis {

namespace {

using namespace support;

Vec3 cylindrical(double r, double theta, double z) { return {r * std::cos(theta), r * std::sin(theta), z}; }

}  // namespace

double SyntheticResults::lumenRadius(double z, double theta, double progress) const {
  const double distance = z - 0.5 * length;
  const double stretched = radius + 60e-6 * std::exp(-std::pow(distance / 200e-6, 2));
  const double strut = std::abs(distance) < 45e-6 ? -20e-6 : 0.0;
  const double thickness =
      140e-6 * progress * (1 + 0.3 * std::cos(theta)) * std::exp(-std::pow(distance / 250e-6, 2));
  return thickness > 20e-6 ? stretched - thickness : stretched - thickness + strut;
}

AgentStore SyntheticResults::agents(double progress) const {
  AgentStore store;
  const double spacing = 1.7 * cellRadius;
  const auto shell = [&](AgentKind kind, auto&& radiusAt, double size, double zMin, double zMax,
                         double step) {
    for (double z = zMin; z < zMax; z += step) {
      const int around = static_cast<int>(2 * pi * radius / step);
      for (int k = 0; k < around; ++k) {
        RandomStream random(1, store.nextId, 0, RandomPurpose::packing);
        const double theta = 2 * pi * (k + 0.4 * random.uniform()) / around;
        const double r = radiusAt(z, theta);
        if (r <= 0) continue;
        store.append(kind, cylindrical(r, theta, z + 0.4 * step * random.uniform()), size);
      }
    }
  };
  const auto at = [&](double depth) {
    return [this, depth](double z, double theta) { return lumenRadius(z, theta, 0) + depth; };
  };
  shell(AgentKind::iel, at(cellRadius), cellRadius, 0, length, spacing);
  for (int layer = 1; layer < 4; ++layer)
    shell(AgentKind::smc, at((1 + 1.7 * layer) * cellRadius), cellRadius, 0, length, spacing);
  shell(AgentKind::eel, at((1 + 1.7 * 4) * cellRadius), cellRadius, 0, length, spacing);
  const double half = 0.5 * length;
  for (double height : {22e-6, 67e-6})
    for (double offset : {-22e-6, 22e-6})
      shell(
          AgentKind::strut, [&](double, double) { return radius + 20e-6 + height - 45e-6; }, 22e-6,
          half + offset, half + offset + 1e-6, 40e-6);
  const Index wall = store.size();
  for (int layer = 0; layer < 4; ++layer) {
    shell(
        AgentKind::smc,
        [&](double z, double theta) {
          const double inner = lumenRadius(z, theta, progress) + (1 + 1.7 * layer) * cellRadius;
          return inner < lumenRadius(z, theta, 0) - 0.5 * cellRadius ? inner : 0.0;
        },
        cellRadius, 0, length, spacing);
  }
  for (Index i = 0; i < store.size(); ++i) {
    RandomStream random(2, store.id[i], 0, RandomPurpose::radius);
    store.stress[i] = 1e4 * random.normal();
    if (store.kind[i] != AgentKind::smc) continue;
    const double u = random.uniform();
    store.set(i, daughter, i >= wall);
    store.set(i, synthetic, i >= wall);
    if (i >= wall && u < 0.5) store.state[i] = u < 0.25 ? CycleState::g1 : CycleState::sg2m;
    store.set(i, inhibited, u > 0.7);
    store.set(i, covered, random.uniform() < progress);
    store.wss[i] = 1.6;
    store.nitricOxide[i] = store.has(i, covered) ? 0.003 : 0.0;
  }
  return store;
}

TriSurface SyntheticResults::lumen(double progress) const {
  const int along = 80, around = 180;
  TriSurface surface;
  for (int i = 0; i <= along; ++i) {
    for (int k = 0; k < around; ++k) {
      const double z = length * i / along, theta = 2 * pi * k / around;
      surface.vertices.push_back(cylindrical(lumenRadius(z, theta, progress), theta, z));
    }
  }
  const auto vertex = [&](int i, int k) { return static_cast<std::uint32_t>(i * around + k % around); };
  for (int i = 0; i < along; ++i) {
    for (int k = 0; k < around; ++k) {
      const bool strut = progress < 0.15 && std::abs(length * (i + 0.5) / along - 0.5 * length) < 45e-6;
      for (int side = 0; side < 2; ++side) {
        surface.triangles.push_back(
            side == 0 ? std::array{vertex(i, k), vertex(i, k + 1), vertex(i + 1, k)}
                      : std::array{vertex(i, k + 1), vertex(i + 1, k + 1), vertex(i + 1, k)});
        surface.region.push_back(strut ? SurfaceRegion::strut : SurfaceRegion::wall);
      }
    }
  }
  for (const int end : {0, along}) {
    const auto centre = static_cast<std::uint32_t>(surface.vertices.size());
    surface.vertices.push_back({0, 0, length * end / along});
    for (int k = 0; k < around; ++k) {
      surface.triangles.push_back(end == 0 ? std::array{centre, vertex(end, k + 1), vertex(end, k)}
                                           : std::array{centre, vertex(end, k), vertex(end, k + 1)});
      surface.region.push_back(end == 0 ? SurfaceRegion::inlet : SurfaceRegion::outlet);
    }
  }
  return surface;
}

std::vector<StrutSegment> SyntheticResults::struts() const {
  const int around = 48;
  const double middle = radius + 20e-6;
  std::vector<StrutSegment> ring;
  for (int k = 0; k < around; ++k) {
    const double from = 2 * pi * k / around, to = 2 * pi * (k + 1) / around;
    ring.push_back({.a = cylindrical(middle, from, 0.5 * length),
                    .b = cylindrical(middle, to, 0.5 * length),
                    .radial = cylindrical(1, 0.5 * (from + to), 0),
                    .width = 88e-6,
                    .thickness = 90e-6,
                    .round = false,
                    .overlap = 4e-6,
                    .openA = false,
                    .openB = false});
  }
  return ring;
}

FlowSolution SyntheticResults::flow(const TriSurface& lumen) const {
  FlowSolution solution;
  for (std::size_t t = 0; t < lumen.triangles.size(); t += 3) {
    if (lumen.region[t] != SurfaceRegion::wall && lumen.region[t] != SurfaceRegion::strut) continue;
    const Vec3 centre = lumen.centre(t);
    const double r = std::hypot(centre.x(), centre.y());
    const Vec3 traction(0, 0, 1.6 * std::pow(radius / r, 3));
    solution.wall.push_back({centre, lumen.areaVector(t).norm(), traction, lumen.region[t]});
  }
  return solution;
}

void SyntheticResults::write(const std::filesystem::path& folder) const {
  TimeSeries series(folder / "timeSeries.csv");
  PvdSeries tissue(folder, "tissue"), lumens(folder, "lumen");
  series.begin(), tissue.begin(), lumens.begin();
  TimeSeriesRow row;
  FlowSolution solution;
  for (int frame = 0; frame < frames; ++frame) {
    const double progress = frames > 1 ? frame / (frames - 1.0) : 0.0;
    const auto step = static_cast<std::uint64_t>(24 * daysPerFrame * frame);
    const double time = 3600.0 * static_cast<double>(step);
    const auto store = agents(progress);
    const auto surface = lumen(progress);
    row.flowSolved = frame > 0;
    row.flowSolves += row.flowSolved;
    if (row.flowSolved != 0) solution = flow(surface);
    writeTissue(tissue.dataFile(step), store, time);
    tissue.add(step, time);
    writeLumen(lumens.dataFile(step), surface, &solution, time);
    lumens.add(step, time);

    row.time = time;
    row.agents = store.size();
    row.neointimaThickness = 70e-6 * progress;
    row.neointimaThicknessMax = 140e-6 * progress;
    row.neointimaAreaFraction = 0.2 * progress;
    row.minLumenArea = pi * std::pow(lumenRadius(0.5 * length, pi / 2, progress), 2);
    row.coverage = progress;
    row.smc = row.g0 = store.size();
    if (row.flowSolved != 0) {
      row.wssMean = 1.6 + progress;
      row.wssP5 = 1.2, row.wssP50 = 1.6 + progress, row.wssP95 = 2.2 + 1.5 * progress;
      row.wssLowAreaFraction = 0.02;
    }
    series.append(row);
  }
  writeStruts(folder / "struts.vtp", strutSurface(struts(), length, 15e-6));
  std::vector<ProfileRow> profile;
  for (int i = 0; i <= 60; ++i) {
    const double z = length * i / 60, r = lumenRadius(z, pi / 2, 1), before = lumenRadius(z, pi / 2, 0);
    profile.push_back({z, pi * r * r, 1 - r * r / (before * before), before - r, {}, false});
  }
  writeProfileCsv(folder / "profile.csv", profile);
  atomicWrite(folder / "scene.toml", "[scene]\ntitle = \"Synthetic\"\n");
  Summary summary;
  summary.scene = "synthetic";
  summary.title = "Synthetic results";
  summary.last = row;
  writeSummaryJson(folder / "summary.json", summary);
}

}  // namespace restenosis
