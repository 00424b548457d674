#pragma once

#include <cstddef>

namespace restenosis {

/// Makes room in a std::vector or a PlainArray for `count` elements and an eighth more. Left to itself a
/// vector that grows by one doubles its room; with all of a wall's arrays that is half the memory of a run.
template <class Array>
void makeRoom(Array& values, std::size_t count) {
  if (count > values.capacity()) values.reserve(count + count / 8);
}

}  // namespace restenosis
