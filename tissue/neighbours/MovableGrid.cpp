#include "MovableGrid.h"

#include "Room.h"

namespace restenosis {

void MovableGrid::place(Index i, const Vec3& point) {
  const std::uint32_t cell = lattice_.cellOf(point);
  if (i == size()) {
    makeRoom(next_, next_.size() + 1);
    makeRoom(cell_, cell_.size() + 1);
    next_.push_back(none);
    cell_.push_back(cell);
    link(i, cell);
  } else if (cell != cell_[i]) {
    unlink(i);
    link(i, cell);
  }
}

void MovableGrid::link(Index i, std::uint32_t cell) {
  cell_[i] = cell;
  next_[i] = first_[cell];
  first_[cell] = i;
}

void MovableGrid::unlink(Index i) {
  Index* to = &first_[cell_[i]];
  while (*to != i) to = &next_[*to];
  *to = next_[i];
}

}  // namespace restenosis
