#include "bridge/scene/SceneWriter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace restenosis {
namespace {

/// A TOML string on one line.
std::string tomlString(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      out += c;
    }
  }
  return out + '"';
}

/// Collects "key = value" and a comment for each key of a section.
class SectionWriter : public ParameterVisitor {
 public:
  explicit SectionWriter(const Units& units) : units_(units) {}

  void quantity(double& value, const ParameterInfo& info) override {
    const std::string text = units_.format(value, info.unit);
    add(info, info.unit.empty() ? text : tomlString(text), {});
  }
  void integer(std::int64_t& value, const ParameterInfo& info) override {
    add(info, fmt::format("{}", value), {});
  }
  void boolean(bool& value, const ParameterInfo& info) override { add(info, value ? "true" : "false", {}); }
  void choice(std::string& value, const std::vector<std::string_view>& allowed,
              const ParameterInfo& info) override {
    std::string list;
    for (const auto name : allowed) list.append(list.empty() ? "" : " | ").append(name);
    add(info, tomlString(value), list);
  }
  void text(std::string& value, const ParameterInfo& info) override { add(info, tomlString(value), {}); }
  void file(std::string& value, const ParameterInfo& info) override { add(info, tomlString(value), {}); }

  std::string aligned() const {
    constexpr std::size_t widestAligned = 48;
    std::size_t width = 0;
    for (const auto& [assignment, comment] : lines_) {
      if (assignment.size() <= widestAligned) width = std::max(width, assignment.size());
    }
    std::string text;
    for (const auto& [assignment, comment] : lines_) {
      text += fmt::format("{:<{}}  # {}\n", assignment, width, comment);
    }
    return text;
  }

 private:
  void add(const ParameterInfo& info, const std::string& value, const std::string& allowed) {
    std::string comment(info.description);
    if (!allowed.empty()) comment += fmt::format("; {}", allowed);
    if (info.source != "none") comment += fmt::format(" ({})", info.source);
    lines_.emplace_back(fmt::format("{} = {}", info.key, value), comment);
  }

  const Units& units_;
  std::vector<std::pair<std::string, std::string>> lines_;
};

}  // namespace

std::string writeScene(const Scene& scene, const Units& units) {
  Scene copy = scene;  // `describe` hands out references that may be written to
  std::string text = fmt::format(
      "# Scene {} as resolved: what is modelled, with every default written out.\n", tomlString(scene.name));
  copy.forEachSection([&](auto& section, bool present) {
    if (!present) return;
    SectionWriter writer(units);
    section.describe(writer);
    text += fmt::format("\n# {}.\n[{}]\n{}", section.summary, section.section, writer.aligned());
  });
  return text;
}

}  // namespace restenosis
