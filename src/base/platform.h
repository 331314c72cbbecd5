// What only the operating system can tell or do: terminals, displays, memory use, other programs, and the
// user's Ctrl-C.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"

namespace idap {

// Once, at the start of a program: a write over the limit of file sizes becomes an error like that of a full
// disk, and files that are opened never take the place of a closed standard output or error.
void setUpProcess();

bool standardErrorIsTerminal();
std::size_t availableMemoryBytes();  // that can be had without swapping; the largest number where unknown
double peakMemoryMegabytes();        // largest resident size of this process so far, MB (1e6 bytes)
double processAgeSeconds();          // since this process was started, to 10 ms; 0 where unknown

// The program that lies in the folder of this one; empty where there is none.
std::filesystem::path programBeside(const std::string& name);
// Goes on as another program, with these arguments, in place of this one. Comes back only where that fails,
// with the reason.
std::string becomeProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments);
// Whether windows can be opened: a display of X11 or Wayland, or a platform that was chosen for Qt.
bool hasDisplay();

// The calling thread gives way to others from now on: work in the background of a window.
void lowerThreadPriority();

// While it lives, the first Ctrl-C (SIGINT) or SIGTERM cancels the progress instead of ending the program; a
// second one ends it. At most one may live at a time.
class CancelOnInterrupt {
 public:
  explicit CancelOnInterrupt(Progress& progress);
  ~CancelOnInterrupt();
  CancelOnInterrupt(const CancelOnInterrupt&) = delete;
  CancelOnInterrupt& operator=(const CancelOnInterrupt&) = delete;
};

}  // namespace idap
