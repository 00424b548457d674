#include "bridge/output/CsvText.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace restenosis {

void CsvText::separate() {
  if (!atLineStart_) text_ += ',';
  atLineStart_ = false;
}

void CsvText::field(std::string_view name) {
  separate();
  text_ += name;
}

void CsvText::field(double value, double scale) {
  if (!std::isfinite(value)) throw std::invalid_argument("a value to be written is not a finite number");
  separate();
  text_ += fmt::format("{:.8g}", value * scale);
}

void CsvText::field(const std::optional<double>& value, double scale) {
  if (value) return field(*value, scale);
  separate();
}

void CsvText::field(std::uint64_t count) {
  separate();
  text_ += fmt::format("{}", count);
}

void CsvText::endLine() {
  text_ += '\n';
  atLineStart_ = true;
}

}  // namespace restenosis
