// What is recorded, and how.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace cca::recording {

struct settings {
  // Ports under these scopes; none: all. "dmp" and "dmp.*" are all ports under dmp, "dmp.phase" is one.
  std::vector<std::string> scopes{};
  // Where the file can't be written fast enough: true, the loop waits, and no beat is lost; false, it never
  // waits, and the beats that are lost are marked in the file. Wait in fast runs only.
  bool waits = false;
  double buffered_seconds = 4;                  // of beats, at least 1024 of them, at most 64 MiB
  double flush_seconds = 1;                     // what is older than this is in the file
  std::chrono::microseconds looks_every{2000};  // how often the writing thread looks for what is new
  double viewer_hz = 50;  // messages of ROS 2 for viewers, of each port that one fits; 0: none
  std::size_t chunk_bytes = 1 << 20;
  int compression_level = 1;  // of zstd
  bool opens_later = false;   // open() opens the file: once all that the run reads has been accepted
};

}  // namespace cca::recording
