#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace restenosis {

/// One key of a section, for authors of scenes. Bounds are in `unit`, as authors write them.
struct ParameterInfo {
  std::string_view key;        ///< name in the scene file
  std::string_view unit = "";  ///< unit of bounds and of the printed default; empty: a plain number
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool minimumAllowed = true;  ///< false: the value must be larger than `minimum`
  bool required = false;       ///< true: no default; the scene must set it
  std::string_view source =
      "assumed";  ///< source key of the default (T6, ISR3D, ISR2D, Zun 2019, ...) or "assumed"
  std::string_view description = "";
};

/// Visits every parameter of a section. A scene reader, a writer of the resolved scene and the schema printer
/// are visitors, so each parameter is declared exactly once: in the `describe` member of the struct that uses
/// it,
///
///     struct CellCycleParameters {
///       static constexpr std::string_view section = "cellCycle";
///       static constexpr std::string_view summary = "Cells grow and divide";
///       double g1Mean = 16 * 3600.0;  // [s]
///       void describe(ParameterVisitor& p) {
///         p.quantity(g1Mean, {.key = "g1Mean", .unit = "h", .minimum = 0, .source = "ISR3D",
///                             .description = "mean duration of G1"});
///       }
///     };
///
/// Values are in SI units; member initialisers are the defaults.
class ParameterVisitor {
 public:
  virtual ~ParameterVisitor() = default;
  /// A value with a dimension (or, with an empty unit, a plain real number).
  virtual void quantity(double& value, const ParameterInfo& info) = 0;
  virtual void integer(std::int64_t& value, const ParameterInfo& info) = 0;
  virtual void boolean(bool& value, const ParameterInfo& info) = 0;
  /// One word of a fixed list, usually the names in a table of laws.
  virtual void choice(std::string& value, const std::vector<std::string_view>& allowed,
                      const ParameterInfo& info) = 0;
  virtual void text(std::string& value, const ParameterInfo& info) = 0;
  /// The path of an input file; relative paths are resolved against the scene's folder, and the file must
  /// exist. Empty: not given.
  virtual void file(std::string& value, const ParameterInfo& info) = 0;
};

}  // namespace restenosis
