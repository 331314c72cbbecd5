// What only the operating system can tell: terminals, memory use, and the user's Ctrl-C.
#pragma once

#include "base/progress.h"

namespace idap {

bool standardErrorIsTerminal();
double peakMemoryMegabytes();  // largest resident size of this process so far, MB (1e6 bytes)

// While it lives, the first Ctrl-C (SIGINT) or SIGTERM cancels the progress instead of ending the program; a second
// one ends it. At most one may live at a time.
class CancelOnInterrupt {
 public:
  explicit CancelOnInterrupt(Progress& progress);
  ~CancelOnInterrupt();
  CancelOnInterrupt(const CancelOnInterrupt&) = delete;
  CancelOnInterrupt& operator=(const CancelOnInterrupt&) = delete;
};

}  // namespace idap
