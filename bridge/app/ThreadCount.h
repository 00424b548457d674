#pragma once

#include <omp.h>

#include <algorithm>

namespace restenosis {

/// More threads, or MPI processes, than this are a mistake.
inline constexpr int mostThreads = 1024, mostRanks = 1024;

/// The number of threads to use: that asked for, or where that is 0, what OpenMP offers (all cores, or
/// OMP_NUM_THREADS).
inline int threadCount(int askedFor) {
  return std::min(askedFor > 0 ? askedFor : omp_get_max_threads(), mostThreads);
}

}  // namespace restenosis
