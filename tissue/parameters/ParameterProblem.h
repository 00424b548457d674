#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace restenosis {

/// A value that is within its own bounds but does not fit the others.
struct ParameterProblem {
  std::string key;                            ///< with its section, as in "stent.length"
  std::string message;                        ///< what is wrong and what is allowed
  std::vector<std::string_view> others = {};  ///< other keys that the check read
};

/// Whether a key, with its section, has a valid value.
using KeyIsKnown = std::function<bool(std::string_view key)>;

/// Collects problems; drops those of a check that read a key that is not known.
class ParameterProblems {
 public:
  explicit ParameterProblems(KeyIsKnown known) : known_(std::move(known)) {}
  bool known(std::string_view key) const { return known_(key); }
  void add(ParameterProblem problem) {
    if (known_(problem.key) && std::ranges::all_of(problem.others, known_))
      all_.push_back(std::move(problem));
  }
  /// The problems; none are left here.
  std::vector<ParameterProblem> extract() { return std::move(all_); }

 private:
  KeyIsKnown known_;
  std::vector<ParameterProblem> all_;
};

}  // namespace restenosis
