// What modes cost: the trot and the mode `stand`, each in its own controller and both in one set.
//
//   bench_modes <what> <beats>    trot, stand: in a controller of its own; trot_mode, stand_mode: in the set;
//                                 switches: as trot_mode, with a switch to `stand` and back before each beat
#include <cstdlib>
#include <memory>
#include <string_view>

#include <cca/cca.hpp>
#include <cca/modes.hpp>

#include "../examples/trot/architecture.hpp"
#include "../examples/trot/idle_robot.hpp"

namespace bench {

struct trot_alone : trot::architecture<trot::idle_robot> {};

struct stance {
  auto process(cca::beat) -> cca::out<"angles", cca::robots::oncilla::leg_angles> {
    return cca::robots::oncilla::leg_angles::vector_type::Constant(0.9);
  }
};
struct stand_alone : cca::graph<cca::rate<1000>,
                                cca::node<"stance", stance>,
                                cca::node<"limits", cca::limiter<cca::robots::oncilla::leg_angles>>,
                                cca::node<"robot", trot::idle_robot>,
                                cca::wire<"stance.angles", "limits.command">,
                                cca::wire<"robot.angles", "limits.measured">,
                                cca::wire<"limits.safe", "robot.command">> {};
struct both : cca::modes<cca::mode<"trot", trot_alone>, cca::mode<"stand", stand_alone>> {};

template <class Controller>
[[gnu::noinline]] void one_beat(Controller& c) {
  c.step();
}
template <class Controller>
[[gnu::noinline]] void switch_and_back(Controller& c) {
  c.template switch_to<"stand">();
  c.template switch_to<"trot">();
}

// `begin` is called once, `before_each` before each beat.
template <class Architecture, class Begin, class Before>
void run(int beats, Begin begin, Before before_each) {
  const auto c = std::make_unique<cca::controller<Architecture>>();
  c->load();
  c->start();
  begin(*c);
  for (int k = 0; k < beats; ++k) {
    before_each(*c);
    one_beat(*c);
  }
}

}  // namespace bench

int main(int argc, char** argv) {
  using namespace bench;
  if (argc != 3) return 2;
  const std::string_view what = argv[1];
  const int beats = std::atoi(argv[2]);
  const auto nothing = [](auto&) {};
  const auto stand = [](auto& c) { c.template switch_to<"stand">(); };
  if (what == "trot") run<trot_alone>(beats, nothing, nothing);
  else if (what == "stand") run<stand_alone>(beats, nothing, nothing);
  else if (what == "trot_mode") run<both>(beats, nothing, nothing);
  else if (what == "stand_mode") run<both>(beats, stand, nothing);
  else if (what == "switches") run<both>(beats, nothing, [](auto& c) { switch_and_back(c); });
  else return 2;
}
