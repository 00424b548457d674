#include "bridge/coupling/AlikeRemarks.h"

#include <fmt/format.h>

#include <string_view>

namespace restenosis {
namespace {

constexpr std::uint64_t keptFirst = 3;

std::string withoutNumbers(std::string text) {
  constexpr std::string_view ofNumbers = "0123456789.+-";
  std::erase_if(text, [&](char c) { return ofNumbers.find(c) != std::string_view::npos; });
  return text;
}

}  // namespace

void AlikeRemarks::add(std::vector<std::string>& remarks, const std::string& prefix,
                       const std::string& text) {
  Kind& kind = kinds_[withoutNumbers(text)];
  ++kind.count;
  if (kind.count > keptFirst + 1) {
    remarks[kind.last] = fmt::format("{}{} (the last of {} remarks like this)", prefix, text, kind.count);
    return;
  }
  kind.last = remarks.size();
  remarks.push_back(prefix + text);
}

}  // namespace restenosis
