#include "bridge/scene/Units.h"

#include <fmt/format.h>
#include <udunits2.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <tuple>
#include <utility>

#include "tissue/parameters/Trimmed.h"

namespace restenosis {
namespace {

/// UDUNITS' parser and status are global to the process, whichever object calls.
std::mutex& libraryMutex() {
  static std::mutex mutex;
  return mutex;
}

constexpr std::pair<std::string_view, std::string_view> plainSpellings[] = {
    {"µ", "u"}, {"μ", "u"}, {"²", "^2"}, {"³", "^3"}, {"·", "*"}};

constexpr std::pair<std::string_view, std::string_view> dimensionNames[] = {
    {"m", "a length"},
    {"s", "a time"},
    {"kg m^-1 s^-2", "a pressure or stress"},
    {"kg m^-2 s^-2", "a pressure gradient"},
    {"s^-1", "a rate"},
    {"m s^-1", "a velocity"},
    {"m^2 s^-1", "a kinematic viscosity"},
    {"kg m^-1 s^-1", "a viscosity"},
    {"kg m^-4 s^-1", "a resistance to flow"},
    {"kg m^-3", "a density"},
    {"m^-3 mol", "a concentration"},
    {"m^2", "an area"},
    {"m^3", "a volume"},
    {"", "a plain number"}};

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::string spelledPlainly(std::string_view text) {
  std::string plain(text);
  for (const auto& [fancy, ascii] : plainSpellings) {
    for (auto at = plain.find(fancy); at != std::string::npos; at = plain.find(fancy, at + ascii.size())) {
      plain.replace(at, fancy.size(), ascii);
    }
  }
  return plain;
}

/// Splits "1.8 mm" into number and unit.
std::pair<double, std::string_view> splitQuantity(std::string_view text, std::string_view unit) {
  text = trimmed(text);
  if (text.empty()) throw UnitError(fmt::format("is empty; a number with a unit such as {} is needed", unit));
  std::string_view rest = text;
  if (rest.front() == '+') rest.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error == std::errc::result_out_of_range) {
    throw UnitError(fmt::format("\"{}\" is beyond the range of numbers", text));
  }
  if (error != std::errc() || (rest.size() < text.size() && rest.front() == '-')) {
    throw UnitError(fmt::format("\"{}\" does not start with a number", text));
  }
  if (!std::isfinite(number)) throw UnitError(fmt::format("\"{}\" is not a finite number", text));
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (!rest.empty() && rest.front() == ',') {
    throw UnitError(fmt::format("\"{}\" has a comma; write decimals with a point", text));
  }
  return {number, trimmed(rest)};
}

/// What UDUNITS says a name means, collected by its visitor.
struct Meaning {
  double factor = 1;
  bool proportional = true;  ///< zero of this unit is zero in SI
  std::map<std::string, int> powers;

  static Meaning& of(void* pointer) { return *static_cast<Meaning*>(pointer); }
  void addBase(const ut_unit* unit, int power) {
    const char* symbol = ut_get_symbol(unit, UT_ASCII);
    powers[symbol != nullptr ? symbol : ut_get_name(unit, UT_ASCII)] += power;
  }
};

ut_status refuse(void* meaning) {
  Meaning::of(meaning).proportional = false;
  return UT_SUCCESS;
}

constexpr ut_visitor meaningVisitor = {
    .visit_basic =
        [](const ut_unit* unit, void* meaning) {
          Meaning::of(meaning).addBase(unit, 1);
          return UT_SUCCESS;
        },
    .visit_product =
        [](const ut_unit*, int count, const ut_unit* const* units, const int* powers, void* meaning) {
          for (int k = 0; k < count; ++k) Meaning::of(meaning).addBase(units[k], powers[k]);
          return UT_SUCCESS;
        },
    .visit_galilean =
        [](const ut_unit*, double scale, const ut_unit* underlying, double origin, void* meaning) {
          Meaning::of(meaning).factor *= scale;
          if (origin != 0.0) Meaning::of(meaning).proportional = false;
          return ut_accept_visitor(underlying, &meaningVisitor, meaning);
        },
    .visit_timestamp = [](const ut_unit*, const ut_unit*, double, void* meaning) { return refuse(meaning); },
    .visit_logarithmic = [](const ut_unit*, double, const ut_unit*,
                            void* meaning) { return refuse(meaning); }};

/// A factor such as 0.001 as the ratio 1 / 1000, where it is one to rounding.
std::pair<double, double> asRatio(double factor) {
  const auto isWhole = [](double x) {
    return x < 1e15 && std::abs(x - std::round(x)) < 1e-12 * x && std::round(x) > 0;
  };
  if (isWhole(factor)) return {std::round(factor), 1.0};
  if (isWhole(1.0 / factor)) return {1.0, std::round(1.0 / factor)};
  return {factor, 1.0};
}

std::string withPlainExponent(std::string number) {
  const auto e = number.find('e');
  if (e == std::string::npos) return number;
  std::string exponent = number.substr(e + 1);
  const bool negative = exponent.front() == '-';
  exponent.erase(0, exponent.find_first_not_of("+-0"));
  return number.substr(0, e) + (negative ? "e-" : "e") + exponent;
}

/// The shortest decimal number that `toSi` turns into `si`; empty if there is none.
template <class ToSi>
std::string shortestNumber(double si, double estimate, ToSi toSi) {
  const std::array<double, 5> candidates = {estimate, std::nextafter(estimate, -INFINITY),
                                            std::nextafter(estimate, INFINITY),
                                            std::nextafter(std::nextafter(estimate, -INFINITY), -INFINITY),
                                            std::nextafter(std::nextafter(estimate, INFINITY), INFINITY)};
  for (int digits = 1; digits <= 17; ++digits) {
    for (const double candidate : candidates) {
      const double rounded = std::strtod(fmt::format("{:.{}g}", candidate, digits).c_str(), nullptr);
      if (toSi(rounded) == si) return withPlainExponent(fmt::format("{}", rounded));
    }
  }
  return {};
}

}  // namespace

struct Units::System {
  ut_system* handle = nullptr;
};

Units::Units() : system_(std::make_unique<System>()) {
  const std::lock_guard lock(libraryMutex());
  ut_set_error_message_handler(ut_ignore);
  system_->handle = ut_read_xml(nullptr);
  if (system_->handle == nullptr) {
    throw std::runtime_error(
        "the unit database of UDUNITS-2 cannot be read; install libudunits2-data or set UDUNITS2_XML_PATH");
  }
}

Units::~Units() {
  const std::lock_guard lock(libraryMutex());
  ut_free_system(system_->handle);
}

void Units::Scale::multiply(const Scale& other, int power) {
  for (int k = 0; k < std::abs(power); ++k) {
    numerator *= power > 0 ? other.numerator : other.denominator;
    denominator *= power > 0 ? other.denominator : other.numerator;
  }
  if (std::fmod(numerator, denominator) == 0.0) {
    numerator /= denominator;
    denominator = 1;
  } else if (std::fmod(denominator, numerator) == 0.0) {
    denominator /= numerator;
    numerator = 1;
  }
  for (const auto& [base, exponent] : other.powers) {
    if ((powers[base] += power * exponent) == 0) powers.erase(base);
  }
}

Units::Scale Units::scaleOfName(const std::string& name) const {
  Meaning meaning;
  {
    const std::lock_guard lock(libraryMutex());
    ut_unit* unit = ut_parse(system_->handle, name.c_str(), UT_ASCII);
    if (unit == nullptr) throw UnitError(fmt::format("'{}' is not a unit", name));
    const ut_status status = ut_accept_visitor(unit, &meaningVisitor, &meaning);
    ut_free(unit);
    if (status != UT_SUCCESS) throw UnitError(fmt::format("'{}' is not a unit", name));
  }
  if (!meaning.proportional) {
    throw UnitError(fmt::format("'{}' has its own zero or is logarithmic, which is not accepted", name));
  }
  Scale scale;
  std::tie(scale.numerator, scale.denominator) = asRatio(meaning.factor);
  scale.powers = meaning.powers;
  return scale;
}

Units::Scale Units::scaleOf(std::string_view unit) const {
  const std::string text = spelledPlainly(unit);
  const auto malformed = [&unit] { return UnitError(fmt::format("'{}' is not a unit", unit)); };
  Scale product;
  std::size_t at = 0;
  bool divide = false, divided = false;
  while (at < text.size()) {
    if (divided && !divide) {
      throw UnitError(
          fmt::format("'{}' multiplies after '/', which is ambiguous; use powers, as in m^-1", unit));
    }
    const std::size_t start = at;
    while (at < text.size() && isLetter(text[at])) ++at;
    if (at == start) {
      // "1/s" is the one place for a number.
      if (start == 0 && text.starts_with("1/")) {
        at = 1;
      } else {
        throw malformed();
      }
    } else {
      const std::string name = text.substr(start, at - start);
      int power = 1;
      const bool caret = at < text.size() && text[at] == '^';
      if (caret || (at < text.size() && (isDigit(text[at]) || text[at] == '-'))) {
        if (caret) ++at;
        const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), power);
        if (error != std::errc() || power == 0 || std::abs(power) > 9) throw malformed();
        at = static_cast<std::size_t>(end - text.data());
      }
      product.multiply(scaleOfName(name), divide ? -power : power);
    }
    if (at == text.size()) break;
    // The joint: spaces with at most one of * . / among them.
    const std::size_t joint = at;
    divide = false;
    int signs = 0;
    for (; at < text.size() && std::string_view(" \t*./").find(text[at]) != std::string_view::npos; ++at) {
      if (text[at] != ' ' && text[at] != '\t') ++signs;
      if (text[at] == '/') divide = divided = true;
    }
    if (at == joint || signs > 1 || at == text.size()) throw malformed();
  }
  return product;
}

std::string Units::baseUnits(const Scale& scale) {
  std::string text;
  for (const auto& [base, power] : scale.powers) {
    if (!text.empty()) text += ' ';
    text += power == 1 ? base : fmt::format("{}^{}", base, power);
  }
  return text;
}

std::string Units::dimensionOf(const Scale& scale, std::string_view unit) {
  const std::string base = baseUnits(scale);
  for (const auto& [key, name] : dimensionNames) {
    if (key == base) return std::string(name);
  }
  return fmt::format("a quantity like {}", unit);
}

std::string Units::dimension(std::string_view unit) const { return dimensionOf(scaleOf(unit), unit); }

double Units::parse(std::string_view quantity, std::string_view unit) const {
  const auto [number, given] = splitQuantity(quantity, unit);
  const Scale expected = scaleOf(unit);
  if (given.empty()) {
    throw UnitError(fmt::format("\"{}\" has no unit; expected {}, for example in {}", trimmed(quantity),
                                dimensionOf(expected, unit), unit));
  }
  Scale scale;
  try {
    scale = scaleOf(given);
  } catch (const UnitError& error) {
    throw UnitError(fmt::format("in \"{}\", {}; expected {}, for example in {}", trimmed(quantity),
                                error.what(), dimensionOf(expected, unit), unit));
  }
  if (scale.powers != expected.powers) {
    throw UnitError(fmt::format("\"{}\" is {}; expected {}, for example in {}", trimmed(quantity),
                                dimensionOf(scale, given), dimensionOf(expected, unit), unit));
  }
  const double si = scale.toSi(number);
  if (!std::isfinite(si)) throw UnitError(fmt::format("\"{}\" is beyond the range of numbers", quantity));
  return si;
}

double Units::toSi(double number, std::string_view unit) const { return scaleOf(unit).toSi(number); }

double Units::fromSi(double si, std::string_view unit) const {
  const Scale scale = scaleOf(unit);
  return si * scale.denominator / scale.numerator;
}

std::string Units::format(double si, std::string_view unit) const {
  const Scale scale = scaleOf(unit);
  const double estimate = si * scale.denominator / scale.numerator;
  std::string number = shortestNumber(si, estimate, [&scale](double x) { return scale.toSi(x); });
  if (unit.empty()) return number.empty() ? fmt::format("{}", si) : number;
  if (!number.empty()) return fmt::format("{} {}", number, unit);
  return fmt::format("{} {}", withPlainExponent(fmt::format("{}", si)), baseUnits(scale));
}

}  // namespace restenosis
