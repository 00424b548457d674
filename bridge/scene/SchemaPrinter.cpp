#include "bridge/scene/SchemaPrinter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bridge/scene/Scene.h"
#include "bridge/scene/SectionReader.h"
#include "tissue/parameters/NameList.h"

namespace restenosis {
namespace {

/// One key as a row; the columns are in `columnNames`.
using Row = std::array<std::string, 7>;
const Row columnNames = {"key", "type", "unit", "default", "allowed", "source", "meaning"};
constexpr std::size_t unitColumn = 2;

class RowCollector : public ParameterVisitor {
 public:
  explicit RowCollector(const Units& units) : units_(units) {}

  void quantity(double& value, const ParameterInfo& info) override {
    const bool plain = info.unit.empty();
    add(info, plain ? "number" : "quantity", readable(value, info.unit), boundsText(info));
  }
  void integer(std::int64_t& value, const ParameterInfo& info) override {
    add(info, "whole number", fmt::format("{}", value), boundsText(info));
  }
  void boolean(bool& value, const ParameterInfo& info) override {
    add(info, "true/false", value ? "true" : "false", "");
  }
  void choice(std::string& value, const std::vector<std::string_view>& allowed,
              const ParameterInfo& info) override {
    add(info, "choice", value, commaSeparated(allowed));
  }
  void text(std::string& value, const ParameterInfo& info) override { add(info, "text", value, ""); }
  void file(std::string& value, const ParameterInfo& info) override { add(info, "file", value, ""); }

  const std::vector<Row>& rows() const { return rows_; }

 private:
  /// As people write it: a value such as 0.09 mm may be a last bit away from what its digits read back as.
  std::string readable(double value, std::string_view unit) const {
    return fmt::format("{:.12g}{}{}", units_.fromSi(value, unit), unit.empty() ? "" : " ", unit);
  }

  void add(const ParameterInfo& info, std::string type, std::string value, std::string allowed) {
    if (info.required) value = "required";
    rows_.push_back({std::string(info.key), std::move(type), std::string(info.unit),
                     value.empty() ? "-" : std::move(value), std::move(allowed), std::string(info.source),
                     std::string(info.description)});
  }

  const Units& units_;
  std::vector<Row> rows_;
};

constexpr std::string_view markdownHead = R"(# Every key of a scene

*source* says where a default comes from: T6, ISR3D, ISR2D or a paper (see [sources](../model/README.md#sources)), *assumed*, or a page of [the model](../model/README.md). A default of `-` is none.

)";

/// Whether a section is required and what its absence means, for its heading.
std::string_view presence(std::string_view section) {
  if (section == SceneParameters::section || section == VesselParameters::section) return "required";
  if (section == CouplingParameters::section || section == OutputParameters::section) {
    return "may be left out: its defaults then hold";
  }
  if (section == FoamSettings::section || section == LbmSettings::section) {
    return "may be left out: scene.fidelity then decides";
  }
  return "left out: not modelled";
}

template <class Print>
std::string printed(const Units& units, Print&& print) {
  Scene scene;
  std::string text;
  scene.forEachSection([&](auto& section, bool) {
    RowCollector collector(units);
    section.describe(collector);
    text += print(section.section, section.summary, collector.rows());
  });
  return text;
}

std::string markdownCell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c;
  }
  return cell;
}

/// Without the unit, which default and bounds have: six columns are as many as a page shows well.
std::string markdownRow(const Row& row) {
  std::string line = "|";
  for (std::size_t c = 0; c < row.size(); ++c) {
    if (c != unitColumn) line += fmt::format(" {} |", markdownCell(row[c]));
  }
  return line + '\n';
}

}  // namespace

std::string schemaText(const Units& units) {
  return printed(units, [](std::string_view section, std::string_view summary, const std::vector<Row>& rows) {
    // Two lines a key: the short columns aligned, then what it means and what is allowed.
    constexpr std::size_t aligned = 4;
    std::array<std::size_t, aligned> width{};
    for (const auto& row : rows) {
      for (std::size_t c = 0; c < aligned; ++c) width[c] = std::max(width[c], row[c].size());
    }
    std::string text = fmt::format("[{}]  {} ({})\n", section, summary, presence(section));
    for (const auto& row : rows) {
      text += fmt::format("  {:<{}}  {:<{}}  {:<{}}  {:<{}}  {}\n", row[0], width[0], row[1], width[1],
                          row[2], width[2], row[3], width[3], row[5]);
      text += fmt::format("      {}\n", row[6]);
      if (!row[4].empty()) text += fmt::format("      allowed: {}\n", row[4]);
    }
    return text + '\n';
  });
}

std::string schemaMarkdown(const Units& units) {
  return std::string(markdownHead) +
         printed(units, [](std::string_view section, std::string_view summary, const std::vector<Row>& rows) {
           std::string text = fmt::format("## [{}]\n\n{} ({}).\n\n", section, summary, presence(section));
           text += markdownRow(columnNames) + "|---|---|---|---|---|---|\n";
           for (const auto& row : rows) text += markdownRow(row);
           return text + '\n';
         });
}

}  // namespace restenosis
