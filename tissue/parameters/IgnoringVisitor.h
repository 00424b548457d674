#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// Ignores every parameter: the base of visitors that read one kind only.
class IgnoringVisitor : public ParameterVisitor {
 public:
  void quantity(double&, const ParameterInfo&) override {}
  void integer(std::int64_t&, const ParameterInfo&) override {}
  void boolean(bool&, const ParameterInfo&) override {}
  void choice(std::string&, const std::vector<std::string_view>&, const ParameterInfo&) override {}
  void text(std::string&, const ParameterInfo&) override {}
  void file(std::string&, const ParameterInfo&) override {}
};

}  // namespace restenosis
