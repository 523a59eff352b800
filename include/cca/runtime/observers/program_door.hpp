// How a main function opens a door into its controller: <cca/door.hpp> specialises it for the controllers of
// recordable graphs.
#pragma once

namespace cca::detail {

template <class Controller>
struct program_door;
template <class Controller> concept HasDoor = requires { sizeof(program_door<Controller>); };

// A program without a door.
template <class Controller>
struct no_door {
  bool look(Controller&) const { return true; }
  bool look_while_paused(Controller&) const { return true; }
  bool look_at_rest(Controller&) const { return true; }
  void run_ended(Controller&) const {}
  bool ends_run() const { return false; }
};
template <class Controller>
struct door_of {
  using type = no_door<Controller>;
};
template <HasDoor Controller>
struct door_of<Controller> {
  using type = program_door<Controller>;
};

}  // namespace cca::detail
