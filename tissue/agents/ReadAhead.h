#pragma once

namespace restenosis {

/// Reads what is at an address, so that it is in the cache when it is needed. A read is not dropped where its
/// page is not known to the processor, as an instruction that only asks for memory may be, and many reads
/// wait together. Speed only.
inline void readAhead(const void* address) {
  static_cast<void>(*static_cast<const volatile unsigned char*>(address));
}

}  // namespace restenosis
