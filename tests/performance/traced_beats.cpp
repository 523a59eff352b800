// One graph three times, for machine_code.py: as it is, traceable, and both traceable and recordable. A set
// of modes and a deployment twice: as they are, and both.
#include <cmath>
#include <tuple>

#include <cca/cca.hpp>
#include <cca/deployment.hpp>
#include <cca/modes.hpp>

namespace {

struct value : cca::space<cca::number, cca::axes<cca::x, cca::y>, cca::rate<1000>> {};
struct slow_value : cca::space<cca::number, cca::axes<cca::x, cca::y>, cca::rate<100>> {};

struct plant {
  Eigen::Vector2d at{1, 2};
  auto sense() -> cca::out<"y", value> { return at; }
  void act(cca::in<"u", value> u) { at += 0.01 * (u.vector() - at); }
};
struct turn {
  double angle = 0;
  auto process(cca::in<"x", value> x, cca::beat now) -> std::tuple<cca::out<"y", value>, cca::fault> {
    angle += x[cca::x{}] * now.dt();
    return {Eigen::Vector2d(std::cos(angle) * x[cca::y{}], std::sin(angle) * x[cca::x{}]),
            angle > 1e6 ? cca::fault("too far") : cca::fault()};
  }
};
struct mean {
  Eigen::Vector2d sum{0, 0};
  auto process(cca::in<"x", value> x) -> cca::out<"y", slow_value> { return sum += 0.1 * (x.vector() - sum); }
};
struct seldom {
  auto process(cca::in<"x", slow_value> x, cca::beat now) -> cca::maybe<"y", value> {
    if (now.index() % 7 != 0) return {};
    return x.vector();
  }
};

struct loop : cca::graph<cca::rate<1000>,
                         cca::node<"a", turn>,
                         cca::node<"b", turn>,
                         cca::node<"mean", mean, cca::timed<10>>,
                         cca::node<"seldom", seldom>,
                         cca::node<"c", turn>,
                         cca::node<"plant", plant>,
                         cca::wire<"plant.y", "a.x">,
                         cca::wire<"a.y", "b.x">,
                         cca::wire<"b.y", "mean.x", cca::latest>,
                         cca::wire<"mean.y", "seldom.x">,
                         cca::wire<"seldom.y", "c.x">,
                         cca::wire<"c.y", "plant.u", cca::delayed<1>>> {};

struct standing : cca::graph<cca::rate<1000>,
                             cca::node<"a", turn>,
                             cca::node<"plant", plant>,
                             cca::wire<"plant.y", "a.x">,
                             cca::wire<"a.y", "plant.u">> {};

struct apart : cca::graph<cca::rate<1000>,
                          cca::node<"a", turn>,
                          cca::node<"mean", mean, cca::timed<10>>,
                          cca::node<"plant", plant>,
                          cca::wire<"plant.y", "a.x">,
                          cca::wire<"a.y", "plant.u">,
                          cca::wire<"plant.y", "mean.x", cca::delayed<1>>> {};
using here = cca::environment<"here", cca::nodes<"a", "plant">>;
using there = cca::environment<"there", cca::other_nodes>;

}  // namespace

struct as_it_is : loop {};
struct with_trace : loop, cca::traceable {};
struct with_both : loop, cca::traceable, cca::recordable {};

struct plain_modes : cca::modes<cca::mode<"loop", loop>, cca::mode<"standing", standing>> {};
struct seen_modes : cca::modes<cca::mode<"loop", loop>, cca::mode<"standing", standing>>,
                    cca::traceable,
                    cca::recordable {};
struct plain_split : cca::deployment<apart, here, there> {};
struct seen_split : cca::deployment<apart, here, there>, cca::traceable, cca::recordable {};

// The beat of an environment, as a function of its own.
template void cca::detail::environment_loop<plain_split, 0>::run_unseen();
template void cca::detail::environment_loop<seen_split, 0>::run_unseen();

bool beat(cca::controller<plain_modes>& c) { return c.step(); }
bool beat(cca::controller<seen_modes>& c) { return c.step(); }
bool beat(cca::controller<as_it_is>& c) { return c.step(); }
bool beat(cca::controller<with_trace>& c) { return c.step(); }
bool beat(cca::controller<with_both>& c) { return c.step(); }
