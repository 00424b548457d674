#include "bridge/scene/SceneFingerprint.h"

#include <fmt/format.h>

#include <cstdint>
#include <set>
#include <stdexcept>
#include <vector>

#include "bridge/flow/FlowBackendNames.h"
#include "bridge/scene/SceneFiles.h"
#include "bridge/scene/Units.h"
#include "bridge/system/FileContent.h"
#include "tissue/agents/StateArchive.h"
#include "tissue/parameters/IgnoringVisitor.h"

namespace restenosis {
namespace {

class ValueCollector : public ParameterVisitor {
 public:
  ValueCollector(std::string_view section, bool fileContents, std::map<std::string, std::string>& values)
      : section_(section), fileContents_(fileContents), values_(values) {}

  void quantity(double& value, const ParameterInfo& info) override {
    add(info, fmt::format("{}", value + 0.0));  // -0 is 0
  }
  void integer(std::int64_t& value, const ParameterInfo& info) override {
    add(info, fmt::format("{}", value));
  }
  void boolean(bool& value, const ParameterInfo& info) override { add(info, value ? "true" : "false"); }
  void choice(std::string& value, const std::vector<std::string_view>&, const ParameterInfo& info) override {
    add(info, value);
  }
  void text(std::string& value, const ParameterInfo& info) override { add(info, value); }
  void file(std::string& value, const ParameterInfo& info) override {
    add(info, fileContents_ && !value.empty() ? digestOf(contentOf(value)) : value);
  }

 private:
  void add(const ParameterInfo& info, std::string value) {
    values_[fmt::format("{}.{}", section_, info.key)] = std::move(value);
  }

  std::string_view section_;
  bool fileContents_;
  std::map<std::string, std::string>& values_;
};

/// The units of a section's quantities, by "section.key".
class UnitCollector : public IgnoringVisitor {
 public:
  UnitCollector(std::string_view section, std::map<std::string, std::string>& units)
      : section_(section), units_(units) {}

  void quantity(double&, const ParameterInfo& info) override {
    units_[fmt::format("{}.{}", section_, info.key)] = info.unit;
  }

 private:
  std::string_view section_;
  std::map<std::string, std::string>& units_;
};

std::map<std::string, std::string> collect(Scene scene, bool fileContents) {
  std::map<std::string, std::string> values;
  scene.forEachSection([&](auto& section, bool present) {
    if (!present) return;
    values[std::string(section.section)] = "modelled";
    ValueCollector collector(section.section, fileContents, values);
    section.describe(collector);
  });
  return values;
}

template <class Section>
std::map<std::string, std::string> collect(Section section) {
  std::map<std::string, std::string> values;
  ValueCollector collector(section.section, true, values);
  section.describe(collector);
  return values;
}

/// Of the keys of [foam] that which ends programs that hang decides no result.
void leaveOutSilenceLimit(std::map<std::string, std::string>& values) {
  values.erase(fmt::format("{}.silenceLimit", FoamSettings::section));
}

std::string hashOf(std::map<std::string, std::string> values) {
  HashingArchive archive;
  archive(values);
  return archive.digest();
}

}  // namespace

std::map<std::string, std::string> sceneValues(const Scene& scene) { return collect(scene, false); }

std::map<std::string, std::string> decisiveValues(const Scene& scene) {
  auto values = collect(scene, true);
  std::erase_if(values, [](const auto& entry) {
    return entry.first == "scene.title" || entry.first == "scene.duration" ||
           entry.first.starts_with("output") || entry.first.starts_with("flow.crossCheck");
  });
  leaveOutSilenceLimit(values);
  return values;
}

std::map<std::string, std::string> lastingValues(const Scene& scene) {
  auto values = decisiveValues(scene);
  std::erase_if(values, [](const auto& entry) {
    const std::string section = entry.first.substr(0, entry.first.find('.'));
    return section == FoamSettings::section || section == LbmSettings::section ||
           entry.first == "scene.fidelity" || CouplingParameters::followsFidelity(entry.first);
  });
  return values;
}

std::vector<std::string> lastingDifferences(const Scene& a, const Scene& b) {
  const auto before = lastingValues(a), after = lastingValues(b);
  std::set<std::string> names;
  for (const auto* values : {&before, &after}) {
    for (const auto& [name, value] : *values) {
      const auto dot = name.find('.');
      const std::string section = name.substr(0, dot);
      const bool inBoth = before.contains(section) && after.contains(section);
      if (!inBoth) {
        names.insert(fmt::format("[{}]", section));
      } else if (dot != std::string::npos && before.at(name) != after.at(name)) {
        names.insert(name);
      }
    }
  }
  return {names.begin(), names.end()};
}

std::map<std::string, std::string> inputDigests(const Scene& scene) {
  std::map<std::string, std::string> digests;
  for (const auto& [name, file] : sceneFiles(scene)) digests[name] = digestOf(contentOf(file));
  return digests;
}

std::map<std::string, std::string> flowSettings(const Scene& scene) {
  if (!scene.flow) return {};
  auto values = collect(scene.coupling);
  std::erase_if(values, [](const auto& entry) { return !CouplingParameters::followsFidelity(entry.first); });
  if (scene.flow->backend == flowBackendNames::foam) values.merge(collect(scene.foamSettings()));
  if (scene.flow->backend == flowBackendNames::lbm) values.merge(collect(scene.lbmSettings()));
  leaveOutSilenceLimit(values);
  return values;
}

std::string settingsInPlace(const std::map<std::string, std::string>& before,
                            const std::map<std::string, std::string>& now) {
  std::map<std::string, std::string> unitOf;
  Scene().forEachSection([&](auto& section, bool) {
    UnitCollector collector(section.section, unitOf);
    section.describe(collector);
  });
  const Units units;
  const auto shown = [&](const std::string& key, const std::string& value) {
    const auto unit = unitOf.find(key);
    return unit == unitOf.end() ? value : units.format(std::stod(value), unit->second);
  };
  std::string list;
  for (const auto& [key, value] : now) {
    const auto former = before.find(key);
    if (former != before.end() && former->second == value) continue;
    list += fmt::format("{}{} = {} (before: {})", list.empty() ? "" : ", ", key, shown(key, value),
                        former == before.end() ? "none" : shown(key, former->second));
  }
  return list;
}

std::string sceneFingerprint(const Scene& scene) { return hashOf(decisiveValues(scene)); }

std::string checkpointFingerprint(const Scene& scene) { return hashOf(lastingValues(scene)); }

}  // namespace restenosis
