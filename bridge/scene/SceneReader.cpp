#include "bridge/scene/SceneReader.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>
#include <tuple>
#include <type_traits>

#include "bridge/scene/ArteryWidth.h"
#include "bridge/scene/LumenSurfaceChecks.h"
#include "bridge/scene/SceneChecks.h"
#include "bridge/scene/SceneDocument.h"
#include "bridge/scene/SceneFindings.h"
#include "bridge/scene/SectionReader.h"
#include "bridge/system/FileContent.h"
#include "tissue/parameters/NameList.h"
#include "tissue/parameters/NearestName.h"
#include "tissue/stent/StentDesign.h"

namespace restenosis {
namespace {

/// Collects the names of a section's keys.
class KeyCollector : public ParameterVisitor {
 public:
  explicit KeyCollector(std::vector<std::string_view>& keys) : keys_(keys) {}
  void quantity(double&, const ParameterInfo& info) override { keys_.push_back(info.key); }
  void integer(std::int64_t&, const ParameterInfo& info) override { keys_.push_back(info.key); }
  void boolean(bool&, const ParameterInfo& info) override { keys_.push_back(info.key); }
  void choice(std::string&, const std::vector<std::string_view>&, const ParameterInfo& info) override {
    keys_.push_back(info.key);
  }
  void text(std::string&, const ParameterInfo& info) override { keys_.push_back(info.key); }
  void file(std::string&, const ParameterInfo& info) override { keys_.push_back(info.key); }

 private:
  std::vector<std::string_view>& keys_;
};

KeysOfSections keysOfSections() {
  KeysOfSections all;
  Scene scene;
  scene.forEachSection([&all](auto& section, bool) {
    auto& keys = all.emplace_back(section.section, std::vector<std::string_view>()).second;
    KeyCollector collector(keys);
    section.describe(collector);
  });
  return all;
}

/// Notes unknown sections, and required ones that are missing.
void checkSections(const SceneDocument& document, const KeysOfSections& all, SceneFindings& findings) {
  std::vector<std::string_view> names;
  for (const auto& [name, keys] : all) names.push_back(name);
  const auto requireKnown = [&](const std::string& name, const ScenePlace& place) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    findings.add(place, fmt::format("unknown section [{}]{}", name, suggestion(name, names)));
    findings.unreliable.insert(nearestName(name, names));
  };
  for (const auto& [name, section] : document.sections()) requireKnown(name, section.place);
  for (const auto& [name, place] : document.removed()) requireKnown(name, place);
  for (const auto required : {SceneParameters::section, VesselParameters::section}) {
    if (document.find(required) != nullptr) continue;
    // A misspelt section has been named already.
    if (findings.unreliable.insert(std::string(required)).second) {
      findings.add(document.placeOf(required, ""), fmt::format("section [{}] is missing", required));
    }
  }
}

/// Numerical settings stood among those of the mechanics once. Returns which are found there, which are
/// moved.
std::vector<std::string> followMovedKeys(SceneDocument& document, const KeysOfSections& all) {
  const auto moved =
      std::ranges::find(all, RelaxationParameters::section, [](const auto& s) { return s.first; });
  return document.moveKeys(MechanicsParameters::section, moved->first, moved->second);
}

/// Says so, and takes the tolerance for what it was there: a force over C r0^2, which moves an agent of a
/// packed wall by about a fortieth of that share of its radius.
std::string adoptMovedKeys(Scene& scene, const std::vector<std::string>& keys) {
  if (keys.empty()) return {};
  std::string text = fmt::format("of [{}] these keys belong in [{}], where they are taken to be: {}",
                                 MechanicsParameters::section, RelaxationParameters::section,
                                 commaSeparated(std::vector<std::string_view>(keys.begin(), keys.end())));
  if (scene.relaxation && std::ranges::find(keys, "tolerance") != keys.end()) {
    scene.relaxation->tolerance /= 40;
    text += fmt::format("; tolerance, a force over C r0^2 there, as {:.3g} of a radius",
                        scene.relaxation->tolerance);
  }
  return text;
}

/// What a fidelity stands for, as the defaults of the sections that it decides.
void startFromFidelity(Scene& scene) {
  const std::string& fidelity = scene.scene.fidelity;
  scene.coupling = CouplingParameters::forFidelity(fidelity);
  if (scene.foam) scene.foam = FoamSettings::forFidelity(fidelity);
  if (scene.lbm) scene.lbm = LbmSettings::forFidelity(fidelity);
}

/// Defaults that follow from other keys.
void resolve(Scene& scene, const SceneDocument& document) {
  // A design such as one ring has no use for the length of a stent: the default must not make a short vessel
  // invalid.
  const GivenSection* stent = document.find(StentParameters::section);
  if (stent != nullptr && !stentDesign(scene.stent->design).spansLength &&
      stent->values.count("length") == 0) {
    scene.stent->length = std::min(scene.stent->length, scene.vessel.length);
  }
  if (scene.mechanics && !scene.relaxation) scene.relaxation.emplace();
}

/// Fifty times a scene that gives every key, with a remark to each [bytes], assumed.
constexpr std::uintmax_t largestSceneFile = 1 << 20;

[[noreturn]] void refuse(const std::filesystem::path& file, std::string message) {
  throw SceneError({{file.string(), 0, 0, std::move(message)}});
}

/// "; did you mean scenes/quick.toml?" for a file that does not exist.
std::string similarFile(const std::filesystem::path& file) {
  std::error_code error;
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  std::vector<std::string> names;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".toml") names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  const std::string nearest =
      nearestName(file.filename().string(), std::vector<std::string_view>(names.begin(), names.end()));
  return nearest.empty() ? "" : fmt::format("; did you mean {}?", (file.parent_path() / nearest).string());
}

}  // namespace

Scene SceneReader::readFile(const std::filesystem::path& file,
                            const std::vector<SceneOverride>& overrides) const {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) refuse(file, "no such scene file" + similarFile(file));
  if (const std::string obstacle = fileObstacle(file, largestSceneFile); !obstacle.empty())
    refuse(file, obstacle + "; a scene file (*.toml) is expected");
  std::string toml;
  try {
    toml = contentOf(file, largestSceneFile);
  } catch (const std::runtime_error& unreadable) {
    refuse(file, unreadable.what() + file.string().size() + 1);  // begins with the file's name
  }
  return readText(toml, file, overrides);
}

Scene SceneReader::readText(std::string_view toml, const std::filesystem::path& file,
                            const std::vector<SceneOverride>& overrides) const {
  SceneFindings findings;
  SceneDocument document(toml, file.string(), findings.diagnostics);
  if (document.broken()) throw SceneError(findings.diagnostics);
  const KeysOfSections all = keysOfSections();
  for (const auto& override : overrides) document.apply(override, findings.diagnostics, all);
  const std::vector<std::string> movedKeys = followMovedKeys(document, all);
  checkSections(document, all, findings);

  Scene scene;
  scene.name = file.stem().string();
  scene.file = file;
  scene.forEachOptionalSection([&document](auto& section) {
    using Section = typename std::remove_reference_t<decltype(section)>::value_type;
    if (document.find(Section::section) != nullptr) section.emplace();
  });
  scene.forEachSection([&](auto& section, bool) {
    if (const GivenSection* given = document.find(section.section)) {
      SectionReader reader(section.section, *given, file.parent_path(), units_, findings);
      section.describe(reader);
      reader.finish(all);
    }
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(section)>, SceneParameters>)
      startFromFidelity(scene);  // before the sections that it decides are read
  });
  takeCentreline(scene, document, units_, findings);
  const auto loaded = takeLumenSurface(scene, document, units_, findings);
  resolve(scene, document);
  checkScene(scene, document, units_, loaded, findings);

  if (findings.diagnostics.empty()) {
    if (std::string text = adoptMovedKeys(scene, movedKeys); !text.empty())
      scene.remarks.push_back(std::move(text));
    if (scene.vessel.lumenSurface.empty())
      if (std::string width = remarkOnWidth(scene, scene.vessel.lumenDiameter); !width.empty())
        scene.remarks.push_back(std::move(width));
    return scene;
  }
  // In the order of the file; what comes from the command line last.
  std::stable_sort(findings.diagnostics.begin(), findings.diagnostics.end(),
                   [&document](const Diagnostic& a, const Diagnostic& b) {
                     return std::tuple(a.file != document.file(), a.line, a.column) <
                            std::tuple(b.file != document.file(), b.line, b.column);
                   });
  throw SceneError(std::move(findings.diagnostics));
}

}  // namespace restenosis
