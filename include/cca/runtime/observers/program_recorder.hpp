// How a main function records and replays: <cca/record.hpp> specialises the first for the controllers of
// recordable graphs, <cca/record/replay_option.hpp> the second. The first also defines how
// a recording becomes a page.
#pragma once

namespace cca::detail {

template <class Controller>
struct program_recorder;
template <class Controller>
class program_page;
template <class Controller> concept HasRecorder = requires { sizeof(program_recorder<Controller>); };

template <class Controller>
struct program_replay;
template <class Controller> concept HasReplay = requires { sizeof(program_replay<Controller>); };

}  // namespace cca::detail
