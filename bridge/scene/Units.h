#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace restenosis {

/// Why a text is no quantity of the expected kind; `what()` is a phrase for people.
struct UnitError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Quantities with units, as people write them in scenes: "1.8 mm", "2.7e-6 m^2/s", "16 h".
///
/// The names, prefixes and sizes of units come from UDUNITS-2 and its database (where UDUNITS2_XML_PATH or
/// the library's own default points). The number and the way units combine are read here and more strictly
/// than UDUNITS does: exactly one finite number, then units joined by space, `*`, `.` or `/`, with whole
/// powers
/// ("m^2", "m2", "mm^-3"). Nothing is multiplied after a `/`, since "Pa/m s" means different things to
/// different people. Units with an origin of their own (degC) and logarithmic units are refused.
///
/// Objects may be used from several threads at once: UDUNITS keeps global state, so calls into it are
/// serialised.
class Units {
 public:
  /// Reads the database. Throws std::runtime_error when it cannot be found.
  Units();
  ~Units();
  Units(const Units&) = delete;
  Units& operator=(const Units&) = delete;

  /// The SI value of a quantity whose dimension must be that of `unit`. Throws UnitError.
  double parse(std::string_view quantity, std::string_view unit) const;

  /// The SI value of a number of units. An empty unit is one.
  double toSi(double number, std::string_view unit) const;

  /// How many units an SI value is.
  double fromSi(double si, std::string_view unit) const;

  /// The shortest text that `parse` turns back into exactly `si`: "1.8 mm". An empty unit gives a plain
  /// number. The few values that no decimal number of `unit` gives exactly are written in base units.
  std::string format(double si, std::string_view unit) const;

  /// The kind of quantity a unit measures: "a length".
  std::string dimension(std::string_view unit) const;

 private:
  struct System;
  /// A unit as a product: SI value = number * numerator / denominator. Two whole numbers for most units, so
  /// that "110 um" is the double nearest to 110e-6.
  struct Scale {
    double numerator = 1, denominator = 1;
    std::map<std::string, int> powers;  ///< of the base units
    double toSi(double number) const { return number * numerator / denominator; }
    void multiply(const Scale& other, int power);
  };

  Scale scaleOf(std::string_view unit) const;
  Scale scaleOfName(const std::string& name) const;
  static std::string baseUnits(const Scale& scale);
  static std::string dimensionOf(const Scale& scale, std::string_view unit);

  std::unique_ptr<System> system_;
};

}  // namespace restenosis
