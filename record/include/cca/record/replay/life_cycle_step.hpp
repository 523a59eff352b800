// The step of the life-cycle that leads a controller to a state that was recorded.
#pragma once

#include <string>

#include <cca/component/lifecycle.hpp>

namespace cca::recording::detail {

template <class Controller>
void move_to(Controller& c, const std::string& wanted) {
  const state from = c.state();
  if (wanted == "loaded") {
    if (from == state::created || from == state::loaded) c.load();
    else if (from == state::started || from == state::faulted) c.stop();
  } else if (wanted == "started" || wanted == "running") {
    if (from == state::created) c.load();
    if (c.state() == state::loaded) c.start();
    else if (from == state::faulted && wanted == "started") c.resume();
  } else if (wanted == "created" && from == state::loaded) {
    c.save();
  }
}

}  // namespace cca::recording::detail
