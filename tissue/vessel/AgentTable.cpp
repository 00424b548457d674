#include "tissue/vessel/AgentTable.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tissue/parameters/LengthUnits.h"
#include "tissue/parameters/NearestName.h"
#include "tissue/parameters/Shown.h"

namespace restenosis {
namespace {

constexpr std::array<std::pair<std::string_view, AgentKind>, 4> kinds = {
    {{"smc", AgentKind::smc}, {"iel", AgentKind::iel}, {"eel", AgentKind::eel}, {"strut", AgentKind::strut}}};

enum Column { columnX, columnY, columnZ, columnRadius, columnKind, columnBirthRadius, columnCount };
constexpr std::array<std::string_view, columnCount> columnNames = {"x",      "y",    "z",
                                                                   "radius", "kind", "birthRadius"};

// Share of a radius that omitted digits may change.
constexpr double rounding = 1e-3;

/// What seems to separate the cells of a text instead of commas, for messages; empty if nothing does.
std::string_view otherSeparator(std::string_view text) {
  for (const auto& [mark, name] :
       {std::pair<char, std::string_view>{';', "semicolons"}, {'\t', "tabs"}, {'|', "bars"}})
    if (text.find(mark) != std::string_view::npos) return name;
  const bool blanksOnly =
      text.find(',') == std::string_view::npos && text.find(' ') != std::string_view::npos;
  return blanksOnly ? "blanks" : "";
}

class TableReader {
 public:
  TableReader(const std::filesystem::path& file, AgentKind defaultKind)
      : file_(file), lines_(file), defaultKind_(defaultKind) {}

  AgentTable read() {
    AgentTable table{.file = file_, .agents = {}, .lines = {}};
    if (lines_.next()) readHeader();
    while (lines_.next()) {
      readAgent(table.agents);
      table.lines.push_back(lines_.number());
    }
    if (table.agents.size() == 0) lines_.failWhole("holds no agents");
    return table;
  }

 private:
  /// Fails with the message, or with its cause where the separator is another one, as spreadsheets write it
  /// in countries with decimal commas.
  [[noreturn]] void failIn(std::string_view text, const std::string& message) const {
    const auto other = otherSeparator(text);
    if (other.empty()) lines_.fail(message);
    lines_.fail(fmt::format(
        "{}: its cells seem to be separated by {}, but commas separate the cells of a table, as in "
        "\"x,y,z,radius\", and decimals have a point",
        shown(text), other));
  }

  void readHeader() {
    const auto names = lines_.cells();
    width_ = names.size();
    for (std::size_t n = 0; n < names.size(); ++n) {
      bool known = false;
      for (int column = 0; column < columnCount; ++column) {
        if (names[n] != columnNames[column]) continue;
        if (place_[column]) lines_.fail(fmt::format("column '{}' appears twice", names[n]));
        place_[column] = n;
        known = true;
      }
      if (!known) {
        failIn(names[n], fmt::format("unknown column {}{} (lengths in um)", shown(names[n]),
                                     suggestion(names[n], {columnNames.begin(), columnNames.end()})));
      }
    }
    for (int column = 0; column < columnKind; ++column) {
      if (!place_[column]) {
        lines_.fail(
            fmt::format("column '{}' is missing; needed are x, y, z, radius (um)", columnNames[column]));
      }
    }
  }

  void readAgent(AgentStore& agents) const {
    const auto cells = lines_.cells();
    if (cells.size() != width_) {
      failIn(lines_.text(), fmt::format("{} cells where the header names {} columns", cells.size(), width_));
    }
    std::array<double, columnKind> value;
    for (int column = 0; column < columnKind; ++column) {
      value[column] = um * number(cells[*place_[column]], columnNames[column]);
    }
    if (!(value[columnRadius] > 0)) lines_.fail("the radius must be larger than 0 um");
    const AgentKind kind = place_[columnKind] ? kindOf(cells[*place_[columnKind]]) : defaultKind_;
    const Index i =
        agents.append(kind, {value[columnX], value[columnY], value[columnZ]}, value[columnRadius]);
    if (place_[columnBirthRadius])
      agents.birthRadius[i] = birthRadius(cells[*place_[columnBirthRadius]], agents.radius[i]);
  }

  double birthRadius(std::string_view cell, double radius) const {
    const double atBirth = um * number(cell, columnNames[columnBirthRadius]);
    const double least = radius / std::cbrt(2.0);
    if (atBirth >= least * (1 - rounding) && atBirth <= radius * (1 + rounding)) return atBirth;
    lines_.fail(fmt::format(
        "a birthRadius of {:.6g} um; allowed are {:.6g} to {:.6g} um: a cell of the radius {:.6g} "
        "um has at most twice the volume of its birth, and not less than it",
        atBirth / um, least / um, radius / um, radius / um));
  }

  double number(std::string_view cell, std::string_view column) const {
    std::string_view digits = cell;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    const auto value = finiteNumber(digits);
    if (!value) failIn(cell, fmt::format("column '{}': {} is not a finite number", column, shown(cell)));
    return *value;
  }

  AgentKind kindOf(std::string_view cell) const {
    for (const auto& [name, kind] : kinds) {
      if (cell == name) return kind;
    }
    // A table of struts holds nothing else
    if (defaultKind_ == AgentKind::strut)
      lines_.fail(fmt::format("unknown kind {}{}; the column may be left out", shown(cell),
                              suggestion(cell, {"strut"})));
    std::vector<std::string_view> names;
    for (const auto& [name, kind] : kinds) names.push_back(name);
    lines_.fail(fmt::format("unknown kind {}{}", shown(cell), suggestion(cell, names)));
  }

  std::filesystem::path file_;
  CsvLines lines_;
  AgentKind defaultKind_;
  std::size_t width_ = 0;
  std::array<std::optional<std::size_t>, columnCount> place_;
};

}  // namespace

std::string AgentTable::placeOf(Index i) const {
  if (!lines.empty()) return fmt::format("line {}", lines[i]);
  const Vec3 place = agents.position(i) * 1e3;  // [mm]
  return fmt::format("at ({:.4g}, {:.4g}, {:.4g}) mm", place.x(), place.y(), place.z());
}

void AgentTable::fail(Index i, const std::string& message) const {
  if (lines.empty()) throw TableError(fmt::format("{}: {}: {}", file.string(), placeOf(i), message));
  throw TableError(fmt::format("{}:{}: {}", file.string(), lines[i], message));
}

AgentTable readAgentTable(const std::filesystem::path& file, AgentKind defaultKind) {
  return TableReader(file, defaultKind).read();
}

void writeAgentTable(const std::filesystem::path& file, const AgentStore& agents) {
  std::ofstream stream(file);
  stream << "x,y,z,radius,kind,birthRadius\n";
  for (Index i = 0; i < agents.size(); ++i) {
    stream << fmt::format("{},{},{},{},{},{}\n", agents.x[i] / um, agents.y[i] / um, agents.z[i] / um,
                          agents.radius[i] / um, kinds[static_cast<std::size_t>(agents.kind[i])].first,
                          agents.birthRadius[i] / um);
  }
  stream.flush();
  if (!stream) throw TableError(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace restenosis
