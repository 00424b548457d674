#include "bridge/scene/SceneFiles.h"

#include <fmt/format.h>

#include <string_view>

#include "tissue/parameters/IgnoringVisitor.h"

namespace restenosis {
namespace {

class FileCollector : public IgnoringVisitor {
 public:
  FileCollector(std::string_view section, std::map<std::string, std::filesystem::path>& files)
      : section_(section), files_(files) {}

  void file(std::string& value, const ParameterInfo& info) override {
    if (!value.empty()) files_[fmt::format("{}.{}", section_, info.key)] = value;
  }

 private:
  std::string_view section_;
  std::map<std::string, std::filesystem::path>& files_;
};

}  // namespace

std::map<std::string, std::filesystem::path> sceneFiles(const Scene& scene) {
  Scene copy = scene;  // `describe` hands out references that may be written to
  std::map<std::string, std::filesystem::path> files;
  copy.forEachSection([&](auto& section, bool present) {
    FileCollector collector(section.section, files);
    if (present) section.describe(collector);
  });
  return files;
}

}  // namespace restenosis
