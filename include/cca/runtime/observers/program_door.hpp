// How a main function opens a door into its controller: <cca/door.hpp> specialises it for the controllers of
// recordable graphs.
#pragma once

namespace cca::detail {

template <class Controller>
struct program_door;
template <class Controller> concept HasDoor = requires { sizeof(program_door<Controller>); };

}  // namespace cca::detail
