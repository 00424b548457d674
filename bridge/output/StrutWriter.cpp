#include "bridge/output/StrutWriter.h"

#include <numeric>
#include <vector>

#include "bridge/output/PolyDataFile.h"
#include "bridge/output/SurfacePolyData.h"

namespace restenosis {

void writeStruts(const std::filesystem::path& file, const TriSurface& struts) {
  std::vector<std::size_t> all(struts.triangles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  writePolyData(file, polyDataOf(struts, all), 0);
}

}  // namespace restenosis
