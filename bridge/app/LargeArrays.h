#pragma once

namespace restenosis {

/// Lets arrays above a mebibyte go back to the system when they are freed. Left to itself glibc keeps them
/// for later, up to 32 MiB each, and a vessel of half a million agents has a sixth more memory.
void returnLargeArrays();

}  // namespace restenosis
