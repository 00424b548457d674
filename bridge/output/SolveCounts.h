#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace restenosis {

/// How often the flow was solved and skipped, by reason.
struct SolveCounts {
  std::map<std::string, std::uint64_t> done, skipped;

  std::uint64_t totalDone() const { return total(done); }
  std::uint64_t totalSkipped() const { return total(skipped); }

  template <class Archive>
  void archive(Archive& a) {
    a(done, skipped);
  }

 private:
  static std::uint64_t total(const std::map<std::string, std::uint64_t>& byReason) {
    std::uint64_t sum = 0;
    for (const auto& [reason, count] : byReason) sum += count;
    return sum;
  }
};

}  // namespace restenosis
