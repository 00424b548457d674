#pragma once

#include <string>
#include <utility>

namespace restenosis {

/// A value that the command line gives instead of the scene's file.
struct SceneOverride {
  SceneOverride(std::string assignment) : text(std::move(assignment)) {}
  SceneOverride(const char* assignment) : text(assignment) {}
  SceneOverride(std::string assignment, std::string where)
      : text(std::move(assignment)), place(std::move(where)) {}

  std::string text;   ///< "section.key=value"; see SceneDocument::apply for its forms
  std::string place;  ///< what messages call it, as "--flow"; empty: "--set section.key"
};

}  // namespace restenosis
