#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace restenosis {

/// Lines of comma-separated values: a header line or a row is fields added one by one, then `endLine`.
class CsvText {
 public:
  void field(std::string_view name);
  /// `value * scale` with eight significant digits. Throws std::invalid_argument when it is not finite: what
  /// is not known is passed as an empty optional and becomes an empty field.
  void field(double value, double scale = 1.0);
  void field(const std::optional<double>& value, double scale = 1.0);
  void field(std::uint64_t count);
  void endLine();

  const std::string& text() const { return text_; }

 private:
  void separate();

  std::string text_;
  bool atLineStart_ = true;
};

}  // namespace restenosis
