#include "bridge/scene/DefaultDifferences.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace restenosis {
namespace {

/// The values of a section as text, in order.
class ValueTexts : public ParameterVisitor {
 public:
  ValueTexts(std::string_view section, const Units& units) : section_(section), units_(units) {}

  void quantity(double& value, const ParameterInfo& info) override {
    add(info, units_.format(value, info.unit));
  }
  void integer(std::int64_t& value, const ParameterInfo& info) override {
    add(info, fmt::format("{}", value));
  }
  void boolean(bool& value, const ParameterInfo& info) override { add(info, value ? "true" : "false"); }
  void choice(std::string& value, const std::vector<std::string_view>&, const ParameterInfo& info) override {
    add(info, value);
  }
  void text(std::string& value, const ParameterInfo& info) override { add(info, value); }
  void file(std::string& value, const ParameterInfo& info) override { add(info, value); }

  struct Entry {
    std::string key, value, meaning;
    bool required;
  };
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  void add(const ParameterInfo& info, std::string value) {
    entries_.push_back({fmt::format("{}.{}", section_, info.key), std::move(value),
                        std::string(info.description), info.required});
  }

  std::string_view section_;
  const Units& units_;
  std::vector<Entry> entries_;
};

}  // namespace

std::vector<DefaultDifference> defaultDifferences(const Scene& scene, const Units& units) {
  Scene copy = scene;  // `describe` hands out references that may be written to
  std::vector<DefaultDifference> found;
  copy.forEachSection([&](auto& section, bool present) {
    if (!present) return;
    using Section = std::remove_reference_t<decltype(section)>;
    Section defaults;
    if constexpr (requires { Section::forFidelity(scene.scene.fidelity); })
      defaults = Section::forFidelity(scene.scene.fidelity);
    ValueTexts here(section.section, units), there(section.section, units);
    section.describe(here);
    defaults.describe(there);
    for (std::size_t k = 0; k < here.entries().size(); ++k) {
      const auto& [key, value, meaning, required] = here.entries()[k];
      const std::string byDefault = required ? "" : there.entries()[k].value;
      if (required || value != byDefault) found.push_back({key, value, byDefault, meaning});
    }
  });
  return found;
}

}  // namespace restenosis
