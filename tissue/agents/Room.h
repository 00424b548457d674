#pragma once

#include <cstddef>
#include <vector>

namespace restenosis {

/// Makes room for `count` elements and an eighth more. Left to itself a vector that grows by one doubles its
/// room; with all of a wall's arrays that is half the memory of a run.
template <class T>
void makeRoom(std::vector<T>& values, std::size_t count) {
  if (count > values.capacity()) values.reserve(count + count / 8);
}

}  // namespace restenosis
