// Where a command speaks, and whom it asks.
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

  // Before anything that moves, enables, overwrites or sends what it was told to.
  bool confirmed(std::string_view what) {
    if (yes) return true;
    if (!someone_is_there) {
      error
          << what
          << "\ncca-can: this asks first, and nobody is at a terminal to say yes; --yes says it beforehand\n";
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
