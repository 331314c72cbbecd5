// Pictures one after the other into an MP4 file that every player and browser shows: H.264, 4:2:0, BT.709,
// constant frame rate, the index in front. The file appears whole at finish(), or not at all. Errors are
// IoError with the path and the reason.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/image8.h"

namespace idap {

class VideoWriter {
 public:
  // Width and height are made even by leaving out the last column or row. framesPerSecond: 1..240.
  VideoWriter(const std::filesystem::path& file, int width, int height, int framesPerSecond);
  ~VideoWriter();  // without finish(), nothing is left
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  // Pictures of the size that was said.
  void add(const Image8& picture);
  int frames() const;

  // Writes what is pending and gives the file its name.
  void finish();

  // What the user should know: another encoder than the usual had to be taken, say. Empty if nothing.
  const std::string& remark() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
