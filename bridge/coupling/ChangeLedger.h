#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "bridge/coupling/Part.h"

namespace restenosis {

/// Counts the changes of each quantity, and remembers at which count each part last read it: tells whether
/// there is anything new to read. Part of a checkpoint.
class ChangeLedger {
 public:
  void touch(Quantity quantity) { ++count_[key(quantity)]; }
  bool changedSince(std::string_view part, Quantity quantity) const {
    const auto seen = seen_.find(std::string(part) + '/' + key(quantity));
    return seen == seen_.end() || seen->second != count(quantity);
  }
  void markRead(std::string_view part, Quantity quantity) {
    seen_[std::string(part) + '/' + key(quantity)] = count(quantity);
  }

  template <class Archive>
  void archive(Archive& a) {
    a(count_, seen_);
  }

 private:
  static std::string key(Quantity quantity) { return std::to_string(static_cast<int>(quantity)); }
  std::uint64_t count(Quantity quantity) const {
    const auto found = count_.find(key(quantity));
    return found == count_.end() ? 0 : found->second;
  }

  std::map<std::string, std::uint64_t> count_, seen_;
};

}  // namespace restenosis
