#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bridge/scene/SceneDocument.h"
#include "bridge/scene/SceneFindings.h"
#include "bridge/scene/Units.h"
#include "tissue/parameters/ParameterVisitor.h"

namespace restenosis {

/// Fills the parameters of one section from what a scene gives, and notes everything that is wrong with it.
/// Call `describe` of the section with it, then `finish`.
class SectionReader : public ParameterVisitor {
 public:
  /// `folder`: where relative paths start.
  SectionReader(std::string_view name, const GivenSection& given, std::filesystem::path folder,
                const Units& units, SceneFindings& findings);

  void quantity(double& value, const ParameterInfo& info) override;
  void integer(std::int64_t& value, const ParameterInfo& info) override;
  void boolean(bool& value, const ParameterInfo& info) override;
  void choice(std::string& value, const std::vector<std::string_view>& allowed,
              const ParameterInfo& info) override;
  void text(std::string& value, const ParameterInfo& info) override;
  void file(std::string& value, const ParameterInfo& info) override;

  /// Notes required keys that are missing and keys that the section does not have.
  void finish(const KeysOfSections& all);

 private:
  /// The value given for a key, or null; remembers that the key exists, and if it is missing what should be
  /// there.
  const GivenValue* find(const ParameterInfo& info, const std::string& expected);
  void complain(const GivenValue& given, std::string_view key, std::string message);
  /// Complains and returns false unless `si` lies within the bounds.
  bool withinBounds(const GivenValue& given, double si, const ParameterInfo& info);
  std::string exampleOf(double si, const ParameterInfo& info) const;
  /// The text given, without quotes if from the command line; complains and returns null if it is none.
  const std::string* textOf(const GivenValue& given, const ParameterInfo& info);

  std::string name_;
  const GivenSection& given_;
  std::filesystem::path folder_;
  const Units& units_;
  SceneFindings& findings_;
  std::vector<std::string_view> known_;
  std::vector<std::pair<std::string_view, std::string>> missing_;  ///< keys, and what is expected of them
};

/// "larger than 0 mm, at most 50 mm"; empty where every value is allowed.
std::string boundsText(const ParameterInfo& info);

}  // namespace restenosis
