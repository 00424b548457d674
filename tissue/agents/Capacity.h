#pragma once

#include <cstddef>

namespace restenosis {

/// Gives a std::vector or a PlainArray capacity for `count` elements and an eighth more. Left to itself a
/// vector that grows by one doubles its capacity; with all of a wall's arrays that is half the memory of a
/// run.
template <class Array>
void growCapacity(Array& values, std::size_t count) {
  if (count > values.capacity()) values.reserve(count + count / 8);
}

}  // namespace restenosis
