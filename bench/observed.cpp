// What recordings and traces cost a beat: the controller of the trot, with a robot that costs nothing.
//
//   bench_observed <what> <beats>   plain; recordable, traceable, both: while nobody looks;
//                                   recorded, traced, both_recorded: by a recorder or a tracer, into
//                                   /dev/null
//                                   open: by a door, which looks after each beat
//
// Only the beats count: the thread that writes has no function `one_beat`.
#include <cstdlib>
#include <memory>
#include <string_view>

#include <cca/cca.hpp>
#include <cca/door.hpp>
#include <cca/record.hpp>
#include <cca/trace.hpp>

#include "../examples/trot/architecture.hpp"
#include "../examples/trot/idle_robot.hpp"

namespace bench {

struct plain : trot::architecture<trot::idle_robot> {};
struct recordable : trot::architecture<trot::idle_robot>, cca::recordable {};
struct traceable : trot::architecture<trot::idle_robot>, cca::traceable {};
struct both : trot::architecture<trot::idle_robot>, cca::recordable, cca::traceable {};

template <class Controller>
[[gnu::noinline]] void one_beat(Controller& c) {
  c.step();
}

template <class Controller>
[[gnu::noinline]] void one_beat(Controller& c, cca::door<Controller>& door) {
  c.step();
  door(c);
}

// `look(controller)` returns what looks at it.
template <class Graph, class Look>
void run(int beats, Look look) {
  const auto c = std::make_unique<cca::controller<Graph>>();
  const auto looking = look(*c);
  c->load();
  c->start();
  for (int k = 0; k < beats; ++k)
    if constexpr (requires { one_beat(*c, *looking); }) one_beat(*c, *looking);
    else one_beat(*c);
}

}  // namespace bench

int main(int argc, char** argv) {
  using namespace bench;
  if (argc != 3) return 2;
  const std::string_view what = argv[1];
  const int beats = std::atoi(argv[2]);
  const auto nobody = [](auto&) { return 0; };
  const auto recorder = []<class Controller>(Controller& c) {
    return std::make_unique<cca::recording::recorder<Controller>>(c, "/dev/null");
  };
  const auto tracer = []<class Controller>(Controller& c) {
    return std::make_unique<cca::tracer<Controller>>(c, "/dev/null");
  };
  const auto door = []<class Controller>(Controller& c) {
    return std::make_unique<cca::door<Controller>>(c, cca::door_settings{.port = 0, .tells_where = false});
  };
  if (what == "plain") run<plain>(beats, nobody);
  else if (what == "recordable") run<recordable>(beats, nobody);
  else if (what == "traceable") run<traceable>(beats, nobody);
  else if (what == "both") run<both>(beats, nobody);
  else if (what == "recorded") run<recordable>(beats, recorder);
  else if (what == "open") run<recordable>(beats, door);
  else if (what == "traced") run<traceable>(beats, tracer);
  else if (what == "both_recorded") run<both>(beats, recorder);
  else return 2;
}
