// How a program runs its robot: what the standard options say.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cca {

// A program sets its defaults, the command line has the last word.
struct run_settings {
  std::optional<double> seconds{};           // of virtual time; none: until a signal
  std::optional<double> speed = 1;           // times the wall clock; none: a fast run
  std::vector<std::string> configs{};        // files with parameters, in this order
  std::vector<std::string> only{};           // the environments of this process; none: all
  bool quiet = false;                        // prints no figures
  bool commands = false;                     // reads pause, step and speed from any standard input
  std::string record{};                      // a file for a recording; empty: none (docs/recordings.md)
  std::vector<std::string> record_scopes{};  // of the ports to record; none: all
  std::string page{};                        // an HTML file with the recording; empty: none (docs/page.md)
  std::string replay{};                      // a recording to replay, instead of a run
  std::string trace{};                       // a file for a trace; empty: none (docs/traces.md)
  std::optional<std::uint16_t> door{};       // a port that other programs may connect to (docs/door.md)
  std::string door_address{};                // empty: this machine only
  std::vector<std::string> door_origins{};   // viewers that are pages of other addresses
  std::string door_token{};                  // a file with what a client must know to change anything
  std::string twin{};                        // its controller as WebAssembly, for the page of the door
  std::string on_lost = "go-on";             // what the run does when who commands is gone: go-on, hold, stop
  std::string on_fault = "end";              // what the program does at a fault: end, hold
  bool paused = false;                       // waits for `go on` before its first beat
  std::map<std::string, std::string> notes{};  // for the recording: a seed, a version
};

}  // namespace cca
