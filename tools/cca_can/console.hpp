// Where a command writes, and how it asks for confirmation.
#pragma once

#include <iosfwd>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>

#include "ending.hpp"

namespace cca_can {

struct console {
  std::ostream& out;
  std::ostream& error;
  std::istream& in;
  bool yes = false;               // --yes
  bool someone_is_there = false;  // at a terminal

  // Asked before anything that moves, enables, overwrites, or sends a log.
  bool confirmed(std::string_view what) {
    if (yes) return true;
    if (!someone_is_there) {
      error << what
            << "\ncca-can: this needs a confirmation, and there is no terminal to ask at; --yes confirms "
               "beforehand\n";
      return false;
    }
    error << what << "\nGo on? [yes/no] " << std::flush;
    std::string answer;
    if (std::getline(in, answer) && (answer == "y" || answer == "yes")) return true;
    error << "cca-can: nothing was done\n";
    return false;
  }
};

}  // namespace cca_can
