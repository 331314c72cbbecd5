// Typed errors. Libraries throw them; the command line and the studio turn them into words. Every message
// says what went wrong, where, and if possible what to do.
#pragma once

#include <stdexcept>
#include <string>

namespace idap {

class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A file that cannot be understood: which file, where in it (an entry, a line, an element), and why.
class ParseError : public Error {
 public:
  ParseError(std::string file, std::string place, const std::string& reason)
      : Error(file + (place.empty() ? "" : ": " + place) + ": " + reason),
        file_(std::move(file)),
        place_(std::move(place)) {}
  const std::string& file() const { return file_; }
  const std::string& place() const { return place_; }

 private:
  std::string file_;
  std::string place_;
};

// A file of a version this program does not read (too new, or too old to be converted).
class UnsupportedVersion : public Error {
 public:
  using Error::Error;
};

// The operating system refused: missing file, no permission, full disk.
class IoError : public Error {
 public:
  using Error::Error;
};

// A home that breaks a rule of model/validate.h.
class InvalidHome : public Error {
 public:
  using Error::Error;
};

class RenderError : public Error {
 public:
  using Error::Error;
};

// The user asked to stop.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace idap
