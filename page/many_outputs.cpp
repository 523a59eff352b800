// A program with a hundred outputs at 1 kHz and a door, for what the page needs to show them all. It has no
// robot and nothing to compute, so the page and the door are what is measured.
//
//   cca_many_outputs --door --quiet --seconds 600
#include <cstddef>
#include <tuple>
#include <utility>

#include <cca/cca.hpp>
#include <cca/main.hpp>
#include <cca/door.hpp>

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}};
};
struct ankle : cca::dimension<"ankle"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee, ankle>, cca::rate<1000>> {};

// Ten curves of three numbers, each with its own frequency.
struct many {
  auto process(cca::beat now) -> std::tuple<cca::out<"a", leg_angles>,
                                            cca::out<"b", leg_angles>,
                                            cca::out<"c", leg_angles>,
                                            cca::out<"d", leg_angles>,
                                            cca::out<"e", leg_angles>,
                                            cca::out<"f", leg_angles>,
                                            cca::out<"g", leg_angles>,
                                            cca::out<"h", leg_angles>,
                                            cca::out<"i", leg_angles>,
                                            cca::out<"j", leg_angles>> {
    const double angle = 1e-9 * static_cast<double>(now.time());
    const auto curve = [&](int i) -> leg_angles::vector_type {
      return {cca::math::sin(angle * (i + 1)), cca::math::sin(angle * (i + 2)),
              cca::math::sin(angle * (i + 3))};
    };
    return {curve(0), curve(1), curve(2), curve(3), curve(4),
            curve(5), curve(6), curve(7), curve(8), curve(9)};
  }
};

// The robot that a loop must have: it takes a command and tells nothing.
struct body {
  auto sense() -> cca::out<"angles", leg_angles> { return at; }
  void act(cca::in<"command", leg_angles> to) { at = to.vector(); }
  leg_angles::vector_type at{0, 0, 0};
};

struct hundred_outputs : cca::graph<cca::node<"first", many>,
                                    cca::node<"second", many>,
                                    cca::node<"third", many>,
                                    cca::node<"fourth", many>,
                                    cca::node<"fifth", many>,
                                    cca::node<"sixth", many>,
                                    cca::node<"seventh", many>,
                                    cca::node<"eighth", many>,
                                    cca::node<"ninth", many>,
                                    cca::node<"tenth", many>,
                                    cca::node<"limits", cca::limiter<leg_angles>>,
                                    cca::node<"body", body>,
                                    cca::wire<"first.a", "limits.command">,
                                    cca::wire<"limits.safe", "body.command">>,
                         cca::recordable {};

struct program : cca::robot_program<hundred_outputs> {
  program() { purpose = "a hundred outputs at 1 kHz, for a door"; }
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
