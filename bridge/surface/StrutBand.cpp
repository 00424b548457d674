#include "bridge/surface/StrutBand.h"

#include "bridge/surface/DistanceField.h"

namespace restenosis {

const BandField* StrutBand::on(const LumenGrid& grid, double clip) {
  if (segments_.empty()) return nullptr;
  if (!band_ || !(band_->grid() == grid) || clip_ != clip) {
    band_.emplace(strutBand(grid, segments_, clip));
    clip_ = clip;
  }
  return &*band_;
}

}  // namespace restenosis
