// EXPECT farm: skeleton\.arity: `extra` \(farm<.*>\) cannot be shared out: what comes in
// EXPECT farm_on_threads: skeleton\.arity: `extra` \(farm_on_threads<.*>\) is to have pipeline<step, step> on threads, but that is a graph
// EXPECT pipeline: skeleton\.arity: `extra` \(pipeline<.*>\) is a pipeline whose stage 1 merge has 2 inputs
// EXPECT splitter: skeleton\.arity: `extra` \(splitter<.*>\) is to take attitude apart, which has 4 numbers over 3 axes
// EXPECT collector: skeleton\.arity: `extra` \(collector<.*>\) is to put attitude together, which has 4 numbers over 3 axes
// EXPECT arbiter: skeleton\.arity: `extra` \(arbiter<.*>\) has 1 source
// EXPECT blend: skeleton\.arity: `extra` \(blend<.*>\) blends 3 sources by 2 weights
// EXPECT hold: skeleton\.arity: `extra` \(hold<.*>\) leads from slow \(100 Hz\) to fast_pair \(1000 Hz\), which differ in more than their rate
// EXPECT interpolate: skeleton\.arity: `extra` \(interpolate<.*>\) leads from odd \(300 Hz\) to fast \(1000 Hz\)
// EXPECT decimate: skeleton\.arity: `extra` \(decimate<.*>\) leads from fast \(1000 Hz\) to odd \(300 Hz\)
// EXPECT chain: mapping\.chain: a mapping of this chain gives paw_in<trunk> \(cartesian_position<trunk> over x, y, z\), and the next one takes paw_in<world>
// EXPECT transformation: transform\.leaves_space: the function to_world of this transformation returns paw_in<world> \(cartesian_position<world> over x, y, z\), but its input is in paw_in<trunk>
// EXPECT kinematics: frame\.mismatch: kinematics say where the tip of a chain is in the frame of its base, trunk, but paw_in<world>
// EXPECT adaptive_mapping: learner\.model: the learner of this adaptive mapping adapts the model elm_function<paw_in<trunk>, leg_torques, .*40.*> from paw_in<trunk>
// EXPECT cycle: body\.cycle: the parts of this body close a loop: `first` hangs on `second`, which hangs on `first`
// EXPECT unattached: body\.unattached: the part `second` hangs on nothing: its chain begins in the frame world
// EXPECT tracker: learner\.model: the learner of this module adapts the model discrete_shape<leg_angles, 25>, and the module runs rhythmic_shape<leg_angles, 25>
// EXPECT criterion: criterion\.spaces: the criterion of this adaptive component measures in paw_in<trunk>
// EXPECT no_space: component\.bad_parameter: a port is of a space, and `double` is none
// LINES: 41
// Rules that a template checks where it is named, each broken in one of fifty nodes; the graphs are
// templates, so that it is named only in the one that is asked for.
#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/extreme_learning_machine.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/mapping/adaptive_mapping.hpp>
#include <cca/mapping/inverse_kinematics.hpp>
#include <cca/mapping/mapping_chain.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/vite.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/skeleton/farm_on_threads.hpp>

#include "../parts.hpp"
#include "fifty_nodes.hpp"

struct merge {
  auto process(cca::in<"a", signal> a, cca::in<"b", signal>) -> cca::out<"y", signal> { return a.vector(); }
};
struct pair_of_numbers : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};
struct three_numbers : cca::space<cca::number, cca::axes<cca::x, cca::y, cca::z>> {};
struct weights : cca::space<cca::amplitude, cca::axes<cca::x, cca::y>> {};
struct of_pairs {
  auto process(cca::in<"x", pair_of_numbers> x) -> cca::out<"y", pair_of_numbers> { return x.vector(); }
};
struct paw : cca::frame<"paw"> {};
struct head : cca::frame<"head"> {};
template <class Frame>
struct paw_in : cca::space<cca::cartesian_position<Frame>, xyz> {};
struct slow : cca::space<cca::number, cca::axes<cca::x>, cca::rate<100>> {};
struct odd : cca::space<cca::number, cca::axes<cca::x>, cca::rate<300>> {};
struct fast : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};
struct fast_pair : cca::space<cca::number, cca::axes<cca::x, cca::y>, cca::rate<1000>> {};
struct height {
  auto operator()(const cca::sample<paw_in<world>>& p) const { return p.vector().head<1>().eval(); }
};
struct to_world {
  template <class Frame>
  auto operator()(const cca::sample<paw_in<Frame>>& p) const {
    return cca::sample<paw_in<world>>(p.vector());
  }
};
struct stays {
  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return p; }
};
template <class Base>
struct leg_chain : cca::serial_chain<Base, paw, cca::axes<hip, knee>> {
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.1))};
  static constexpr auto tip = cca::at(0, 0, -0.1);
};
template <class Frame>
using to_torques = cca::extreme_learning_machine<cca::elm_function<paw_in<Frame>, leg_torques, 40>>;
struct stride : cca::dimension<"stride"> {};
template <class Space>
struct takes {
  void process(cca::in<"x", Space>) {}
};
template <class Space>
struct source_of {
  auto process(cca::beat) -> cca::out<"y", Space> { return {}; }
};

template <class Component, class... More>
using with_extra = fifty_nodes_and<cca::rate<1000>, cca::node<"extra", Component>, More...>;

template <class Component, cca::fixed_string Input, class Space, class... More>
using fed = with_extra<Component, cca::node<"in", source_of<Space>>, cca::wire<"in.y", Input>, More...>;

namespace broken {

template <class>
struct farm : fed<cca::farm<of_pairs, three_numbers, three_numbers>, "extra.input", three_numbers> {};
template <class>
struct farm_on_threads
    : fed<cca::farm_on_threads<cca::pipeline<step, step>, pair_of_numbers, pair_of_numbers>,
          "extra.input",
          pair_of_numbers> {};
template <class>
struct pipeline : with_extra<cca::pipeline<step, merge>, cca::wire<"n7.y", "extra.input">> {};
template <class>
struct splitter : fed<cca::splitter<"trunk", attitude>, "extra.trunk", attitude> {};
template <class>
struct collector : with_extra<cca::collector<"trunk", attitude>, cca::wire<"n7.y", "extra.x">> {};
template <class>
struct arbiter : with_extra<cca::arbiter<"y", signal, cca::by_priority<"a">>, cca::wire<"n7.y", "extra.a">> {
};
template <class>
struct blend : with_extra<cca::blend<"y", signal, weights, "a", "b", "c">,
                          cca::wire<"n7.y", "extra.a">,
                          cca::wire<"n8.y", "extra.b">,
                          cca::wire<"n9.y", "extra.c">,
                          cca::node<"in", source_of<weights>>,
                          cca::wire<"in.y", "extra.weight">> {};
template <class>
struct hold : with_extra<cca::hold<slow, fast_pair>,
                         cca::node<"in", source_of<slow>, cca::timed<10>>,
                         cca::wire<"in.y", "extra.input">> {};
template <class>
struct interpolate : with_extra<cca::interpolate<odd, fast>, cca::wire<"n7.y", "extra.input">> {};
template <class>
struct decimate : with_extra<cca::decimate<fast, odd>, cca::wire<"n7.y", "extra.input">> {};

template <class F>
using same = cca::mapping<paw_in<F>, paw_in<F>, stays>;
template <class F>
struct chain : fed<cca::mapping_chain<same<F>, cca::mapping<paw_in<world>, signal, height>>,
                   "extra.input",
                   paw_in<F>> {};
template <class F>
struct transformation : fed<cca::transformation<paw_in<F>, to_world>, "extra.input", paw_in<F>> {};
template <class F>
struct kinematics
    : fed<cca::inverse_kinematics<leg_chain<F>, leg_angles, paw_in<world>>, "extra.position", paw_in<world>> {
};
template <class F>
struct adaptive_mapping
    : fed<cca::adaptive_mapping<paw_in<F>, leg_angles, to_torques<F>>, "extra.input", paw_in<F>> {};
template <class Base, class Tip, class Joint>
struct link : cca::serial_chain<Base, Tip, cca::axes<Joint>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.3, 0, 0);
};
template <class Body, class F>
using places = fed<cca::part_kinematics<Body, "second", leg_angles, paw_in<F>>, "extra.angles", leg_angles>;
template <class F>
struct ring
    : cca::body<F, cca::part<"first", link<paw, world, knee>>, cca::part<"second", link<world, paw, hip>>> {};
template <class F>
struct loose
    : cca::body<F, cca::part<"first", link<F, head, knee>>, cca::part<"second", link<world, paw, hip>>> {};
template <class F>
struct cycle : places<ring<F>, F> {};
template <class F>
struct unattached : places<loose<F>, F> {};

template <class F>
using discrete = cca::locally_weighted_regression<cca::discrete_shape<leg_angles, 25>>;
template <class F>
struct tracker : fed<cca::tracker<cca::dmp_rhythmic_module<leg_angles, stride, 25, discrete<F>>,
                                  cca::tracking<leg_angles>>,
                     "extra.reference",
                     leg_angles,
                     cca::wire<"in.y", "extra.feedback">,
                     cca::node<"phase", source_of<cca::over<cca::phase, stride>>>,
                     cca::wire<"phase.y", "extra.phase">,
                     cca::node<"amplitude", source_of<cca::over<cca::amplitude, stride>>>,
                     cca::wire<"amplitude.y", "extra.amplitude">> {};
template <class F>
using follows_paw =
    cca::tracker<cca::vite<leg_angles>, cca::tracking<paw_in<F>>, cca::named<"target", "position", "status">>;
template <class F>
struct criterion : fed<follows_paw<F>,
                       "extra.feedback",
                       paw_in<F>,
                       cca::node<"goal", source_of<leg_angles>>,
                       cca::wire<"goal.y", "extra.reference">> {};
template <class F>
struct no_space : with_extra<takes<double>, cca::wire<"n7.y", "extra.x">> {};

struct none : with_extra<step, cca::wire<"n7.y", "extra.x">> {};

}  // namespace broken

#ifndef CCA_REJECT
static_assert(cca::well_formed<broken::none>);
#else
cca::controller<broken::CCA_REJECT<trunk>> c;
#endif
