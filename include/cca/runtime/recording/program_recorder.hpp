// How a main function records: <cca/record.hpp> specialises this for the controllers of recordable graphs.
#pragma once

namespace cca::detail {

template <class Controller>
struct program_recorder;
template <class Controller> concept HasRecorder = requires { sizeof(program_recorder<Controller>); };

}  // namespace cca::detail
