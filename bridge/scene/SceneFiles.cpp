#include "SceneFiles.h"

#include <string>

#include "IgnoringVisitor.h"

namespace restenosis {
namespace {

class FileCollector : public IgnoringVisitor {
 public:
  explicit FileCollector(std::vector<std::filesystem::path>& files) : files_(files) {}

  void file(std::string& value, const ParameterInfo&) override {
    if (!value.empty()) files_.emplace_back(value);
  }

 private:
  std::vector<std::filesystem::path>& files_;
};

}  // namespace

std::vector<std::filesystem::path> sceneFiles(const Scene& scene) {
  Scene copy = scene;  // `describe` hands out references that may be written to
  std::vector<std::filesystem::path> files;
  copy.forEachSection([&](auto& section, bool present) {
    FileCollector collector(files);
    if (present) section.describe(collector);
  });
  return files;
}

}  // namespace restenosis
