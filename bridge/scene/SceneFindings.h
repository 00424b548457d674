#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bridge/scene/Diagnostic.h"

namespace restenosis {

/// What was found wrong so far, and with which keys: a check that needs one of those would only blame the
/// same slip twice.
struct SceneFindings {
  std::vector<Diagnostic> diagnostics;
  std::set<std::string, std::less<>> unreliable;  ///< "section" or "section.key"

  /// Whether nothing is known against the key, "section" or "section.key", or its section.
  bool reliable(std::string_view key) const {
    return !unreliable.contains(key) && !unreliable.contains(key.substr(0, key.find('.')));
  }

  void add(const ScenePlace& place, std::string message) {
    diagnostics.push_back({place.file, place.line, place.column, std::move(message)});
  }
};

}  // namespace restenosis
