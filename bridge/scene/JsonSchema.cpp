#include "bridge/scene/JsonSchema.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "bridge/scene/Scene.h"
#include "bridge/scene/SectionReader.h"
#include "tissue/parameters/IgnoringVisitor.h"

namespace restenosis {
namespace {

using Json = nlohmann::ordered_json;

/// A number and a unit: "110 um", "5um", "7.2 1/d".
constexpr const char* quantityPattern =
    R"(^\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?(\s+(1/)?[^\s0-9.]|[^\s0-9.eE]).*$)";

/// Makes the schema of one section.
class SectionSchema : public ParameterVisitor {
 public:
  explicit SectionSchema(const Units& units) : units_(units) {}

  void quantity(double& value, const ParameterInfo& info) override {
    if (info.unit.empty()) {
      Json& key = add(info, "number", value);
      bound(key, info);
      return;
    }
    // As people write it: 0.09 mm may be a last bit away from what its digits read back as
    const auto text = fmt::format("{:.12g} {}", units_.fromSi(value, info.unit), info.unit);
    Json& key = add(info, "string", text);
    key["pattern"] = quantityPattern;
    if (info.required) key["examples"] = Json::array({text});
  }
  void integer(std::int64_t& value, const ParameterInfo& info) override {
    bound(add(info, "integer", value), info);
  }
  void boolean(bool& value, const ParameterInfo& info) override { add(info, "boolean", value); }
  void choice(std::string& value, const std::vector<std::string_view>& allowed,
              const ParameterInfo& info) override {
    add(info, "string", value)["enum"] = allowed;
  }
  void text(std::string& value, const ParameterInfo& info) override { add(info, "string", value); }
  void file(std::string& value, const ParameterInfo& info) override {
    add(info, "string", value);
    files_.emplace_back(info.key);
  }

  const Json& keys() const { return keys_; }
  const Json& required() const { return required_; }
  const std::vector<std::string>& files() const { return files_; }

 private:
  template <class T>
  Json& add(const ParameterInfo& info, const char* type, const T& value) {
    const std::string bounds = boundsText(info);
    Json& key = keys_[std::string(info.key)];
    key["type"] = type;
    key["description"] =
        fmt::format("{}{}{} ({})", info.description, bounds.empty() ? "" : "; ", bounds, info.source);
    if (info.required)
      required_.push_back(std::string(info.key));
    else
      key["default"] = value;
    return key;
  }

  static void bound(Json& key, const ParameterInfo& info) {
    if (std::isfinite(info.minimum)) key[info.minimumAllowed ? "minimum" : "exclusiveMinimum"] = info.minimum;
    if (std::isfinite(info.maximum)) key["maximum"] = info.maximum;
  }

  const Units& units_;
  Json keys_ = Json::object(), required_ = Json::array();
  std::vector<std::string> files_;
};

/// Gives a section one of its files.
class FileGiver : public IgnoringVisitor {
 public:
  explicit FileGiver(std::string_view key) : key_(key) {}
  void file(std::string& value, const ParameterInfo& info) override {
    if (info.key == key_) value = "given";
  }

 private:
  std::string_view key_;
};

template <class Section>
Json sectionSchema(Section section, const Units& units) {
  SectionSchema given(units);
  section.describe(given);
  Json schema = {{"type", "object"}, {"description", section.summary}, {"additionalProperties", false}};
  // A file may stand for keys that are else required
  Json alternatives = Json::array({Json::object({{"required", given.required()}})});
  for (const std::string& file : given.files()) {
    Section withFile = section;
    FileGiver giver(file);
    withFile.describe(giver);
    SectionSchema other(units);
    withFile.describe(other);
    if (other.required() == given.required()) continue;
    Json required = other.required();
    required.push_back(file);
    alternatives.push_back(Json::object({{"required", required}}));
  }
  if (alternatives.size() > 1)
    schema["anyOf"] = alternatives;
  else if (!given.required().empty())
    schema["required"] = given.required();
  schema["properties"] = given.keys();
  return schema;
}

}  // namespace

std::string jsonSchema(const Units& units) {
  Json sections = Json::object();
  Scene scene;
  scene.forEachSection(
      [&](auto& section, bool) { sections[std::string(section.section)] = sectionSchema(section, units); });
  const Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                       {"title", "A scene of restenosisFoam"},
                       {"type", "object"},
                       {"additionalProperties", false},
                       {"required", Json::array({SceneParameters::section, VesselParameters::section})},
                       {"properties", sections}};
  return schema.dump(2) + '\n';
}

}  // namespace restenosis
