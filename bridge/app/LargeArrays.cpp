#include "LargeArrays.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace restenosis {

void returnLargeArrays() {
#if defined(M_MMAP_THRESHOLD)
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

}  // namespace restenosis
