#pragma once

namespace restenosis {

/// What this machine does at most with the present number of threads, measured.
struct MachineLimits {
  double copiedBytes;   ///< read plus written in copying arrays larger than the caches [B/s]
  double multiplyAdds;  ///< floating point operations of multiply-adds, two each [1/s]
  double squareRoots;   ///< in double precision [1/s]
};
MachineLimits measureMachine();

}  // namespace restenosis
