#include "bridge/flow/foam/WallSamples.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "bridge/flow/foam/FoamLog.h"

namespace restenosis {

namespace fs = std::filesystem;

std::vector<fs::path> sampleFolders(const fs::path& patch) {
  std::vector<std::pair<double, fs::path>> folders;
  if (fs::is_directory(patch))
    for (const auto& entry : fs::directory_iterator(patch)) {
      const std::string name = entry.path().filename().string();
      double time = 0;
      const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), time);
      if (error == std::errc() && end == name.data() + name.size()) folders.emplace_back(time, entry.path());
    }
  std::ranges::sort(folders);
  std::vector<fs::path> sorted;
  for (auto& [time, folder] : folders) sorted.push_back(std::move(folder));
  return sorted;
}

std::vector<Vec3> readWallSample(const fs::path& file) {
  const std::string text = foamLog::read(file);
  const char *at = text.data(), *const end = at + text.size();
  const auto number = [&] {
    constexpr std::string_view between = "( \n)";
    while (at != end && between.find(*at) != std::string_view::npos) ++at;
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value))
      throw std::runtime_error(fmt::format("{} has no valid list of vectors", file.string()));
    at = next;
    return value;
  };
  const double count = number();
  if (!(count >= 0 && count <= static_cast<double>(text.size())))
    throw std::runtime_error(fmt::format("{} has no valid list of vectors", file.string()));
  std::vector<Vec3> vectors(static_cast<std::size_t>(count));
  for (Vec3& v : vectors)
    for (int c = 0; c < 3; ++c) v[c] = number();
  return vectors;
}

}  // namespace restenosis
