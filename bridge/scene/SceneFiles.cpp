#include "SceneFiles.h"

#include <cstdint>
#include <string>

namespace restenosis {
namespace {

class FileCollector : public ParameterVisitor {
 public:
  explicit FileCollector(std::vector<std::filesystem::path>& files) : files_(files) {}

  void quantity(double&, const ParameterInfo&) override {}
  void integer(std::int64_t&, const ParameterInfo&) override {}
  void boolean(bool&, const ParameterInfo&) override {}
  void choice(std::string&, const std::vector<std::string_view>&, const ParameterInfo&) override {}
  void text(std::string&, const ParameterInfo&) override {}
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
