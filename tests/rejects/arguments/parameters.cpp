// EXPECT no_parameters: cca::controller::set: the component `walk\.step` \(step\) of walking has no `parameters` that could be set
// EXPECT no_parameters_of_graph: cca::controller::set: the inner graph `walk` of walking has no `parameters` that could be set: name a component that has, as in `inner\.component`
// EXPECT no_parameters_at_all: cca::controller::set: the component `to` \(sink\) of walking has no `parameters` that could be set
// EXPECT no_parameters_by_value: cca::controller::set: the component `to` \(sink\) of walking has no `parameters` that could be set
// EXPECT unknown_node: node\.unknown_path: walking has no node `walk\.stop`; did you mean `walk\.step`\?
// LINES: 15
// What `set` says of a path at which there are no parameters. Some of the lines are of this file: an
// alias and a function between the mistake and where it is asked for.
#include <cca/cca.hpp>

#include "late.hpp"

struct signal : cca::space<cca::number, cca::axes<cca::x>> {};
struct source {
  auto process(cca::beat) -> cca::out<"y", signal> { return 1.0; }
};
struct step {
  auto process(cca::in<"x", signal> x) -> cca::out<"y", signal> { return x.vector(); }
};
struct sink {
  void process(cca::in<"x", signal>) {}
};
struct walk : cca::graph<cca::node<"step", step>, cca::expose<"step.x", "x">, cca::expose<"step.y", "y">> {};
struct walking : cca::graph<cca::rate<1000>,
                            cca::node<"from", source>,
                            cca::node<"walk", walk>,
                            cca::node<"to", sink>,
                            cca::wire<"from.y", "walk.x">,
                            cca::wire<"walk.y", "to.x">> {};
static_assert(cca::well_formed<walking>);

namespace broken {

template <cca::fixed_string Path, class Controller>
auto set(Controller& c) {
  c.template set<Path>({1.0, 2.0});
  return 0;
}
using walker = cca::controller<walking>;

template <class T>
using no_parameters = decltype(set<"walk.step">(std::declval<late<walker, T>&>()));
template <class T>
using no_parameters_of_graph = decltype(set<"walk">(std::declval<late<walker, T>&>()));
template <class T>
using no_parameters_at_all = decltype(set<"to">(std::declval<late<walker, T>&>()));
// A number, and not what stands in braces for all parameters.
template <cca::fixed_string Path, class Controller>
auto set_to_one(Controller& c) {
  c.template set<Path>(1.0);
  return 0;
}
template <class T>
using no_parameters_by_value = decltype(set_to_one<"to">(std::declval<late<walker, T>&>()));
template <class T>
using unknown_node = decltype(set<"walk.stop">(std::declval<late<walker, T>&>()));
template <class T>
using none = late<walker, T>;

}  // namespace broken

#ifndef CCA_REJECT
constexpr auto size = sizeof(broken::none<signal>);
#else
constexpr auto size = sizeof(broken::CCA_REJECT<signal>);
#endif
