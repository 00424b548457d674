#include "bridge/flow/foam/FoamBeats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "bridge/flow/foam/BeatSteps.h"
#include "bridge/flow/foam/FoamLog.h"
#include "bridge/flow/foam/FoamSteps.h"
#include "bridge/flow/foam/WallPatch.h"
#include "bridge/flow/foam/WallSamples.h"
#include "bridge/surface/PointTree.h"
#include "bridge/system/AtomicFile.h"

namespace restenosis {

namespace fs = std::filesystem;

namespace {

constexpr const char* solver = "pimpleFoam";

/// Relative L2 norm of the change of TAWSS in the last beat (assumed: where cells are skew, the correction
/// for it may grow from step to step; a second attempt corrects less).
constexpr double mostChange = 0.1;

/// The stress on a face over the last beat, and TAWSS over the one before.
struct SampledFace {
  Vec3 centre;
  BeatStress last;
  double before;
};

/// Times and values of a surfaceFieldValue.dat; what is no number there is none here.
std::vector<std::pair<double, double>> readSeries(const fs::path& file) {
  std::vector<std::pair<double, double>> series;
  std::istringstream lines(foamLog::read(file));
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    double time = 0;
    std::string value;
    words >> time >> value;  // a stream reads no "nan"
    series.emplace_back(time, std::strtod(value.c_str(), nullptr));
  }
  return series;
}

/// One case of beats, in the folder `beats` of a steady one.
class Beats {
 public:
  Beats(const fs::path& caseFolder, const FlowConditions& conditions, const FoamSettings& settings,
        const FoamExecution& execution)
      : steady_(caseFolder),
        folder_(caseFolder / beatsFolder),
        conditions_(conditions),
        beating_(*conditions.beating),
        settings_(settings),
        execution_(execution),
        stepping_(beating_.waveform.period, beating_.beats, settings),
        steps_(folder_, execution) {}

  void prepare();
  void solve();
  /// The faces of a region's patch.
  std::vector<SampledFace> sampled(const std::string& patch) const;
  void cleanUp() const;
  /// Throws where TAWSS has changed so much in the last beat that it may grow without bound.
  void requireRepeated(double change) const;
  double seconds() const { return seconds_; }

 private:
  void checkFlow() const;
  void run(const std::string& program, const std::vector<std::string>& arguments, FoamSteps::On on) {
    seconds_ += steps_.run(program, arguments, on);
  }

  fs::path steady_, folder_;
  const FlowConditions& conditions_;
  const Beating& beating_;
  const FoamSettings& settings_;
  const FoamExecution& execution_;
  BeatSteps stepping_;
  FoamSteps steps_;
  double seconds_ = 0.0;
};

void Beats::prepare() {
  fs::create_directory_symlink(fs::path("..") / "constant", folder_ / "constant");
  fs::copy(steady_ / "0.orig", folder_ / "0", fs::copy_options::recursive);
  atomicWrite(folder_ / "case.foam", "");
  run("mapFields", {"..", "-consistent", "-sourceTime", "latestTime"}, FoamSteps::On::oneProcess);
  fs::remove(folder_ / "0/wallShearStress");
  if (execution_.parallel()) run("decomposePar", {}, FoamSteps::On::oneProcess);
}

void Beats::solve() {
  run(solver, {}, FoamSteps::On::allRanks);
  checkFlow();
  if (!execution_.parallel()) return;
  run("reconstructPar", {"-latestTime"}, FoamSteps::On::oneProcess);
  for (const auto& part : steps_.parts()) fs::remove_all(part);
}

void Beats::checkFlow() const {
  const fs::path tables = folder_ / "postProcessing";
  const auto in = readSeries(tables / "inletFlow/0/surfaceFieldValue.dat");
  const auto out = readSeries(tables / "outletFlow/0/surfaceFieldValue.dat");
  if (in.empty() || in.size() != out.size()) steps_.fail(solver, "there is no table of the flow rates");
  double most = 0;
  for (const auto& [time, flowRate] : in)
    most = std::max(most, conditions_.flowRate * std::abs(beating_.waveform(time)));
  const double tolerance = settings_.massTolerance * most;
  for (std::size_t n = 0; n < in.size(); ++n) {
    const double wanted = conditions_.flowRate * beating_.waveform(in[n].first);
    if (in[n].first < stepping_.end - beating_.waveform.period) continue;
    if (!(std::abs(in[n].second + wanted) <= tolerance))
      steps_.fail(solver, fmt::format("{:.4g} m^3/s flow in at {:.4g} s instead of {:.4g}", -in[n].second,
                                      in[n].first, wanted));
    if (!(std::abs(in[n].second + out[n].second) <= tolerance))
      steps_.fail(solver, fmt::format("{:.4g} m^3/s flow in at {:.4g} s but {:.4g} out", -in[n].second,
                                      in[n].first, out[n].second));
  }
}

std::vector<SampledFace> Beats::sampled(const std::string& patch) const try {
  const fs::path tables = folder_ / "postProcessing";
  const auto ends = sampleFolders(tables / "surface");
  if (ends.empty()) throw std::runtime_error(fmt::format("{} is missing", (tables / "surface").string()));
  const auto faces = readWallPatch(ends.back() / (patch + ".vtp"));
  const auto folders = sampleFolders(tables / "samples" / patch);
  const auto samples = static_cast<std::size_t>(stepping_.samples);
  if (folders.size() != 2 * samples)
    throw std::runtime_error(fmt::format("{} holds {} samples instead of {}",
                                         (tables / "samples" / patch).string(), folders.size(), 2 * samples));
  std::vector<std::vector<Vec3>> stresses;
  for (const fs::path& folder : folders) {
    stresses.push_back(readWallSample(folder / "wallShearStress"));
    if (stresses.back().size() != faces.size())
      throw std::runtime_error(fmt::format("{} does not belong to its patch", folder.string()));
  }
  std::vector<SampledFace> result;
  std::vector<Vec3> tractions(2 * samples);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!(faces[f].areaVector.norm() > 0)) continue;
    for (std::size_t n = 0; n < tractions.size(); ++n)
      tractions[n] = faces[f].traction(conditions_.density, stresses[n][f]);
    const Vec3 normal = faces[f].areaVector.normalized();
    const std::span<const Vec3> all(tractions);
    result.push_back({faces[f].centre, beatStress(all.last(samples), normal),
                      beatStress(all.first(samples), normal).average});
  }
  return result;
} catch (const std::runtime_error& error) {
  steps_.fail(solver, error.what());
}

void Beats::cleanUp() const { fs::remove_all(folder_ / "postProcessing/samples"); }

void Beats::requireRepeated(double change) const {
  if (!(change <= mostChange))
    steps_.fail(solver,
                fmt::format("the stress of the last beat differs from that of the one before by {:.2g} %: "
                            "time steps are not stable in this mesh, or more flow.beats are needed",
                            100 * change));
}

/// Sums over faces for BeatSummary.
struct Differences {
  double area = 0, average = 0, steady = 0, square = 0, changed = 0, different = 0;

  void add(double weight, double steadyStress, const SampledFace& face) {
    area += weight;
    average += weight * face.last.average;
    steady += weight * steadyStress;
    square += weight * std::pow(face.last.average, 2);
    changed += weight * std::pow(face.last.average - face.before, 2);
    different += weight * std::pow(face.last.average - steadyStress, 2);
  }
};

}  // namespace

void solveBeats(const fs::path& caseFolder, const FlowConditions& conditions, const FoamSettings& settings,
                const FoamExecution& execution, FlowSolution& solution) {
  Beats beats(caseFolder, conditions, settings, execution);
  beats.prepare();
  beats.solve();
  Differences sums;
  for (const auto& [region, patch] :
       {std::pair{SurfaceRegion::wall, "wall"}, {SurfaceRegion::strut, "strut"}}) {
    if (std::ranges::find(solution.wall, region, &WallFace::region) == solution.wall.end()) continue;
    const std::vector<SampledFace> faces = beats.sampled(patch);
    std::vector<Vec3> centres;
    for (const SampledFace& face : faces) centres.push_back(face.centre);
    const PointTree tree(centres);
    for (WallFace& face : solution.wall) {
      if (face.region != region) continue;
      const SampledFace& same = faces[tree.nearest(face.centre, 1).front().index];
      face.beat = same.last;
      sums.add(face.area, face.traction.norm(), same);
      if (conditions.beating->meanStress && face.beat.mean.norm() > 0)
        face.traction = face.beat.average * face.beat.mean.normalized();
    }
  }
  beats.cleanUp();
  const double change = std::sqrt(sums.changed / sums.square);
  beats.requireRepeated(change);
  solution.solveSeconds += beats.seconds();
  solution.beats = {.beats = conditions.beating->beats,
                    .period = conditions.beating->waveform.period,
                    .meanStress = sums.average / sums.area,
                    .change = change,
                    .steadyMean = sums.steady / sums.average - 1,
                    .steadyDifference = std::sqrt(sums.different / sums.square),
                    .seconds = beats.seconds()};
}

}  // namespace restenosis
