// Components with members of many kinds compile, start, run and are copied if they can be. g++ 12.2 crashed
// on some of them (internal compiler error in gimplify_var_or_parm_decl) as long as an aggregate initialised
// the components of a controller: with `double x = 0;` beside a std::vector, a std::unique_ptr or a
// std::optional<std::vector>. This file is compiled twice, at -O0 and at -O2.
#include <array>
#include <atomic>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <cca/cca.hpp>

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
};
struct angles : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};

struct aggregate {
  double number = 0;
  std::vector<int> numbers{1, 2, 3};
};
enum class color { red, green };

// The joint of docs/how_it_becomes_one_loop.md, with another member before or after its angle.
template <class Member>
struct member_after {
  auto sense() -> cca::out<"angle", angles> { return angle; }
  void act(cca::in<"command", angles> to) { angle = to[hip{}]; }
  double angle = 0;
  Member member{};
};
template <class Member>
struct member_before {
  auto sense() -> cca::out<"angle", angles> { return angle; }
  void act(cca::in<"command", angles> to) { angle = to[hip{}]; }
  Member member{};
  double angle = 0;
};
template <class Member>
struct member_without_initializer {
  auto sense() -> cca::out<"angle", angles> { return angle; }
  void act(cca::in<"command", angles> to) { angle = to[hip{}]; }
  Member member;
  double angle = 0.1;
};
template <class Member>
struct member_and_constructor {
  member_and_constructor() : angle(0) {}
  auto sense() -> cca::out<"angle", angles> { return angle; }
  void act(cca::in<"command", angles> to) { angle = to[hip{}]; }
  double angle;
  Member member{};
};

struct ramp {
  double value = 0;
  auto process(cca::beat) -> cca::out<"angle", angles> { return value += 0.001; }
};

// A ramp drives every joint through a limiter.
template <class... Items>
struct joints_moved : cca::graph<cca::node<"ramp", ramp>,
                                 cca::node<"limits", cca::limiter<angles>>,
                                 cca::wire<"ramp.angle", "limits.command">,
                                 Items...> {};

template <cca::fixed_string Name, class Joint>
struct driven : cca::graph<cca::node<"joint", Joint>, cca::expose<"joint.command", "command">> {};

template <class Graph>
void use() {
  static_assert(cca::well_formed<Graph>);
  cca::controller<Graph> controller;
  controller.load();
  controller.start();
  controller.step();
  controller.run(cca::for_beats<3>{});
  if constexpr (std::is_copy_constructible_v<cca::controller<Graph>>) {
    cca::controller<Graph> copy = controller;
    copy.step();
    copy = controller;
  }
  controller.stop();
}
