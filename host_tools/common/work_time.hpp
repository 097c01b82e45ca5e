// The processor time of a thread, independent of other load.
#pragma once

#include <time.h>

namespace inkcell::tools {

/// Processor time of the calling thread since it began. [ms]
inline double work_done_ms() {
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 +
         static_cast<double>(time.tv_nsec) * 1e-6;
}

}  // namespace inkcell::tools
