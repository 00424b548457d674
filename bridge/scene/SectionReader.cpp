#include "bridge/scene/SectionReader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bridge/system/FileContent.h"
#include "tissue/parameters/NameList.h"
#include "tissue/parameters/NearestName.h"

namespace restenosis {
namespace {

std::string describeGiven(const GivenValue& given) {
  struct Words {
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return fmt::format("the number {}", value); }
    std::string operator()(double value) const { return fmt::format("the number {}", value); }
    std::string operator()(const std::string& value) const { return fmt::format("\"{}\"", value); }
    std::string operator()(const UnusableValue& value) const { return value.kind; }
  };
  return std::visit(Words{}, given.value);
}

std::string withUnit(double number, std::string_view unit) {
  return unit.empty() ? fmt::format("{}", number) : fmt::format("{} {}", number, unit);
}

/// A number without unit, as integer or not; nothing otherwise.
const double* asNumber(const GivenValue& given, double& storage) {
  if (const auto* whole = std::get_if<std::int64_t>(&given.value))
    storage = static_cast<double>(*whole);
  else if (const auto* real = std::get_if<double>(&given.value))
    storage = *real;
  else
    return nullptr;
  return &storage;
}

}  // namespace

std::string boundsText(const ParameterInfo& info) {
  std::string text;
  if (std::isfinite(info.minimum)) {
    text = fmt::format("{} {}", info.minimumAllowed ? "at least" : "larger than",
                       withUnit(info.minimum, info.unit));
  }
  if (std::isfinite(info.maximum)) {
    text += fmt::format("{}at most {}", text.empty() ? "" : ", ", withUnit(info.maximum, info.unit));
  }
  return text;
}

SectionReader::SectionReader(std::string_view name, const GivenSection& given, std::filesystem::path folder,
                             const Units& units, SceneFindings& findings)
    : name_(name), given_(given), folder_(std::move(folder)), units_(units), findings_(findings) {}

const GivenValue* SectionReader::find(const ParameterInfo& info, const std::string& expected) {
  known_.push_back(info.key);
  const auto found = given_.values.find(info.key);
  if (found == given_.values.end()) {
    if (info.required) missing_.emplace_back(info.key, expected);
    return nullptr;
  }
  return &found->second;
}

void SectionReader::complain(const GivenValue& given, std::string_view key, std::string message) {
  findings_.add(given.place, std::move(message));
  findings_.unreliable.insert(fmt::format("{}.{}", name_, key));
}

std::string SectionReader::exampleOf(double si, const ParameterInfo& info) const {
  const bool usable = std::isfinite(si) && si != 0.0;
  const std::string value = usable ? units_.format(si, info.unit) : withUnit(1, info.unit);
  return info.unit.empty() ? fmt::format("{} = {}", info.key, value)
                           : fmt::format("{} = \"{}\"", info.key, value);
}

bool SectionReader::withinBounds(const GivenValue& given, double si, const ParameterInfo& info) {
  // Conversions round: a bound itself, written in another unit, stays allowed.
  constexpr double slack = 1e-12;
  const double minimum = units_.toSi(info.minimum, info.unit), maximum = units_.toSi(info.maximum, info.unit);
  const bool belowMinimum = info.minimumAllowed ? si < minimum - slack * std::abs(minimum) : si <= minimum;
  if (!belowMinimum && si <= maximum + slack * std::abs(maximum)) return true;
  complain(given, info.key,
           fmt::format("'{}' in [{}] is {}, out of bounds; allowed: {}", info.key, name_,
                       units_.format(si, info.unit), boundsText(info)));
  return false;
}

void SectionReader::quantity(double& value, const ParameterInfo& info) {
  const std::string bounds = boundsText(info);
  const GivenValue* given =
      find(info, fmt::format("{}{}{}, for example {}",
                             info.unit.empty() ? "a plain number" : units_.dimension(info.unit),
                             bounds.empty() ? "" : ", ", bounds, exampleOf(value, info)));
  if (given == nullptr) return;
  double si = 0;
  const double* number = asNumber(*given, si);
  if (number != nullptr && !std::isfinite(si)) {
    return complain(*given, info.key,
                    fmt::format("'{}' in [{}] is {}, which is not a finite number", info.key, name_, si));
  }
  if (info.unit.empty()) {
    if (number == nullptr) {
      return complain(*given, info.key,
                      fmt::format("'{}' in [{}] is {}; a plain number without unit or quotes is expected, "
                                  "for example {}",
                                  info.key, name_, describeGiven(*given), exampleOf(value, info)));
    }
  } else if (const auto* text = std::get_if<std::string>(&given->value)) {
    try {
      si = units_.parse(*text, info.unit);
    } catch (const UnitError& error) {
      return complain(*given, info.key, fmt::format("'{}' in [{}]: {}", info.key, name_, error.what()));
    }
  } else {
    const double example = number != nullptr ? units_.toSi(si, info.unit) : value;
    return complain(*given, info.key,
                    fmt::format("'{}' in [{}] is {} without a unit; {} with its unit is expected, in quotes, "
                                "for example {}",
                                info.key, name_, describeGiven(*given), units_.dimension(info.unit),
                                exampleOf(example, info)));
  }
  if (withinBounds(*given, si, info)) value = si;
}

void SectionReader::integer(std::int64_t& value, const ParameterInfo& info) {
  const GivenValue* given = find(info, "a whole number");
  if (given == nullptr) return;
  const auto* whole = std::get_if<std::int64_t>(&given->value);
  if (whole == nullptr) {
    const auto* real = std::get_if<double>(&given->value);
    const bool couldBeWhole = real != nullptr && std::trunc(*real) == *real && std::abs(*real) < 1e15;
    return complain(
        *given, info.key,
        fmt::format("'{}' in [{}] is {}; a whole number is expected, for example {} = {}", info.key, name_,
                    couldBeWhole ? fmt::format("{:.1f}, a number with a decimal point or an exponent", *real)
                                 : describeGiven(*given),
                    info.key, couldBeWhole ? static_cast<std::int64_t>(*real) : value));
  }
  if (withinBounds(*given, static_cast<double>(*whole), info)) value = *whole;
}

void SectionReader::boolean(bool& value, const ParameterInfo& info) {
  const GivenValue* given = find(info, "true or false");
  if (given == nullptr) return;
  if (const bool* flag = std::get_if<bool>(&given->value)) {
    value = *flag;
  } else {
    complain(*given, info.key,
             fmt::format("'{}' in [{}] is {}; expected true or false, without quotes", info.key, name_,
                         describeGiven(*given)));
  }
}

const std::string* SectionReader::textOf(const GivenValue& given, const ParameterInfo& info) {
  if (const auto* text = std::get_if<std::string>(&given.value)) return text;
  if (!given.raw.empty()) return &given.raw;
  complain(
      given, info.key,
      fmt::format("'{}' in [{}] is {}; text in quotes is expected", info.key, name_, describeGiven(given)));
  return nullptr;
}

void SectionReader::choice(std::string& value, const std::vector<std::string_view>& allowed,
                           const ParameterInfo& info) {
  const GivenValue* given = find(info, "one of " + commaSeparated(allowed));
  if (given == nullptr) return;
  const std::string* word = textOf(*given, info);
  if (word == nullptr) return;
  if (std::find(allowed.begin(), allowed.end(), *word) != allowed.end()) {
    value = *word;
    return;
  }
  complain(
      *given, info.key,
      fmt::format("'{}' in [{}] cannot be \"{}\"{}", info.key, name_, *word, suggestion(*word, allowed)));
}

void SectionReader::text(std::string& value, const ParameterInfo& info) {
  const GivenValue* given = find(info, "text in quotes");
  if (given == nullptr) return;
  if (const std::string* text = textOf(*given, info)) value = *text;
}

void SectionReader::file(std::string& value, const ParameterInfo& info) {
  const GivenValue* given = find(info, "the name of a file in quotes");
  if (given == nullptr) return;
  const std::string* text = textOf(*given, info);
  if (text == nullptr) return;
  if (text->empty()) {
    value.clear();
    return;
  }
  const std::filesystem::path path = std::filesystem::absolute(folder_ / *text).lexically_normal();
  value = path.string();  // also of a file that is missing: what depends on it is not missing as well
  if (const std::string obstacle = fileObstacle(path); !obstacle.empty())
    complain(*given, info.key, fmt::format("'{}' in [{}]: {} {}", info.key, name_, path.string(), obstacle));
}

void SectionReader::finish(const KeysOfSections& all) {
  std::vector<std::string> meant;
  for (const auto& [key, given] : given_.values) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    meant.push_back(nearestName(key, known_));
    std::string hint = suggestion(key, known_);
    for (const auto& [section, keys] : all) {
      if (std::find(keys.begin(), keys.end(), key) != keys.end()) {
        hint = fmt::format("; it belongs in [{}]{}", section, suggestion("", known_));
        break;
      }
    }
    complain(given, meant.back().empty() ? key : meant.back(),
             fmt::format("unknown key '{}' in [{}]{}", key, name_, hint));
  }
  for (const auto& [key, expected] : missing_) {
    findings_.unreliable.insert(fmt::format("{}.{}", name_, key));
    // A misspelt key has been named already.
    if (std::find(meant.begin(), meant.end(), key) != meant.end()) continue;
    findings_.add(given_.place,
                  fmt::format("key '{}' is missing in [{}]; expected: {}", key, name_, expected));
  }
}

}  // namespace restenosis
