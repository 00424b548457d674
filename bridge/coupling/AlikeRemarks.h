#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace restenosis {

/// Adds remarks to a list such that what is said again and again does not bury the rest: of those that differ
/// in their numbers only, the first three stay, and the last, which says how many there are. Nothing else
/// may move what is in the list.
class AlikeRemarks {
 public:
  /// Adds `prefix` and `text`, which says what the remark is like.
  void add(std::vector<std::string>& remarks, const std::string& prefix, const std::string& text);

  template <class Archive>
  void archive(Archive& a) {
    a(kinds_);
  }

 private:
  struct Kind {
    std::uint64_t count = 0;
    std::uint64_t last = 0;  ///< where in the list the last of them is

    template <class Archive>
    void archive(Archive& a) {
      a(count, last);
    }
  };
  std::map<std::string, Kind> kinds_;  ///< by what they say without numbers
};

}  // namespace restenosis
