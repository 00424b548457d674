#include "bridge/app/RunTradeoff.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "bridge/app/RankOptions.h"
#include "bridge/coupling/Run.h"
#include "bridge/output/Progress.h"
#include "bridge/output/ResultsFolder.h"
#include "bridge/output/Version.h"
#include "bridge/scene/SceneFingerprint.h"
#include "bridge/scene/SceneWriter.h"
#include "bridge/scene/Units.h"
#include "bridge/system/AtomicFile.h"
#include "bridge/system/FileContent.h"
#include "bridge/system/PrintableOutput.h"
#include "tissue/equilibrium/Relaxation.h"

namespace restenosis {
namespace {

namespace fs = std::filesystem;

/// What is read off a run's summary.json.
struct Outcome {
  std::string status;
  double seconds = 0;
  double day = 0;
  double thickness = 0;  ///< of the neointima [um]
  double area = 0;       ///< smallest of the lumen [mm^2]
  std::string version, fingerprint;
  bool ended() const { return status == "finished" || status == "occluded"; }
  /// Whether this program would find the same for the scene: its files may have changed, or the program.
  bool holdsFor(const Scene& scene) const {
    return ended() && version == restenosis::version() && fingerprint == sceneFingerprint(scene);
  }
};

/// Empty where there is no such file.
std::string contentIfThere(const fs::path& file) { return fs::exists(file) ? contentOf(file) : ""; }

/// Throws nlohmann::json::exception where `summary` is none of a run.
Outcome outcomeOf(const nlohmann::json& summary) {
  const auto final = summary.at("final");
  const auto number = [&final](const char* name) {
    return final.at(name).is_number() ? final.at(name).get<double>() : 0.0;
  };
  return {.status = summary.at("status"),
          .seconds = summary.at("totalSeconds"),
          .day = number("day"),
          .thickness = number("neointimaThickness_um"),
          .area = number("minLumenArea_mm2"),
          .version = summary.at("version"),
          .fingerprint = summary.value("sceneFingerprint", "")};
}

/// Of no status where the folder has no summary, or one that cannot be read.
Outcome outcomeIn(const fs::path& folder) {
  try {
    return outcomeOf(nlohmann::json::parse(contentIfThere(folder / "summary.json")));
  } catch (const nlohmann::json::exception&) {
    return {};
  }
}

/// Runs the scene, from its checkpoint if it `goesOn`.
Outcome ranIn(const fs::path& folder, const Scene& scene, const std::string& text,
              const TradeoffOptions& options, bool goesOn) {
  const auto results = goesOn ? ResultsFolder::existing(folder) : ResultsFolder::fresh(folder);
  Progress progress(PrintableOutput::terminal(), Progress::onTerminal(), scene.scene.duration);
  Run run(scene, results, progress,
          {.threads = options.threads,
           .ranks = rankCount(scene, options.ranks),
           .stopRequested = options.stopRequested});
  if (goesOn) run.resume();
  atomicWrite(results.scene(), text);
  run.go();
  return outcomeIn(folder);
}

Outcome madeIn(const fs::path& folder, const Scene& scene, const std::string& text,
               const TradeoffOptions& options) {
  const bool begun = contentIfThere(folder / "scene.toml") == text;
  const Outcome former = outcomeIn(folder);
  if (begun && former.holdsFor(scene)) return former;
  if (begun && !former.ended() && fs::exists(folder / "checkpoint")) {
    try {
      return ranIn(folder, scene, text, options, true);
    } catch (const CheckpointRefused& error) {
      std::cerr << fmt::format("{}: it is run again from the start\n", error.what());
    }
  }
  return ranIn(folder, scene, text, options, false);
}

/// The same; nothing, and why on standard error, where the tissue or the flow of this scene failed.
std::optional<Outcome> triedIn(const fs::path& folder, const Scene& scene, const std::string& text,
                               const TradeoffOptions& options) {
  try {
    return madeIn(folder, scene, text, options);
  } catch (const RelaxationFailed& error) {
    std::cerr << fmt::format("\n{}\n", error.what());
  } catch (const FlowFailed& error) {
    std::cerr << fmt::format("\nThe flow failed: {}\n", error.what());
  }
  return std::nullopt;
}

TradeoffRow compared(const SweptSetting& setting, std::size_t n, const Outcome& reference,
                     const Outcome& outcome) {
  TradeoffRow row{setting.key, setting.values[n], outcome.seconds, 0.0, ""};
  const bool grows = reference.thickness > 0;
  const double expected = grows ? reference.thickness : reference.area;
  const double found = grows ? outcome.thickness : outcome.area;
  row.error = expected > 0 ? std::abs(found / expected - 1) : std::abs(found);
  row.meaning =
      fmt::format("{} on day {:.4g} against {} = {}", grows ? "neointima thickness" : "smallest lumen area",
                  reference.day, setting.key, setting.values.front());
  return row;
}

}  // namespace

std::optional<std::vector<std::vector<Scene>>> sweptScenes(const SceneArguments& arguments,
                                                           const std::vector<SweptSetting>& settings) {
  std::vector<std::vector<Scene>> all;
  for (const SweptSetting& setting : settings) {
    auto& scenes = all.emplace_back();
    for (const std::string& value : setting.values) {
      SceneArguments varied = arguments;
      varied.others.emplace_back(fmt::format("{}={}", setting.key, value), "--vary " + setting.key);
      auto scene = varied.read();
      if (!scene) return std::nullopt;
      // Only the end is looked at, and what is recorded changes no state
      scene->output.interval = scene->scene.duration;
      scene->output.pictures = false;
      scenes.push_back(std::move(*scene));
    }
  }
  return all;
}

std::vector<TradeoffRow> runTradeoff(const std::vector<SweptSetting>& settings,
                                     const std::vector<std::vector<Scene>>& scenes, const fs::path& folder,
                                     const TradeoffOptions& options) {
  std::vector<TradeoffRow> rows;
  std::map<std::string, std::optional<Outcome>> made;  // by the whole scene
  for (std::size_t s = 0; s < settings.size(); ++s) {
    std::optional<Outcome> reference;
    for (std::size_t n = 0; n < settings[s].values.size(); ++n) {
      const std::string name = fmt::format("{} = {}", settings[s].key, settings[s].values[n]);
      const std::string text = writeScene(scenes[s][n], Units());
      auto found = made.find(text);
      if (found == made.end()) {
        std::cerr << fmt::format("{}:\n", name);
        found = made.emplace(text, triedIn(folder / withoutSpaces(name), scenes[s][n], text, options)).first;
      }
      if (!found->second) {
        std::cerr << fmt::format("{} is left out: its run failed{}\n", name,
                                 reference ? "" : ", and the others are to be compared with it");
        if (!reference) break;
        continue;
      }
      const Outcome& outcome = *found->second;
      if (!reference) reference = outcome;
      if (outcome.day == reference->day) {
        rows.push_back(compared(settings[s], n, *reference, outcome));
      } else {
        std::cerr << fmt::format("{} is left out: it ended on day {:.4g}, not {:.4g}\n", name, outcome.day,
                                 reference->day);
      }
    }
  }
  return rows;
}

}  // namespace restenosis
