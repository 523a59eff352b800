// Forms that a component may have: each of these compiles.
#include <tuple>

#include <cca/cca.hpp>

namespace {

struct reading : cca::space<cca::number, cca::axes<cca::x>> {};
using in_x = cca::in<"x", reading>;
using out_y = cca::out<"y", reading>;

struct source {
  auto process() -> out_y { return 1; }
};
struct constant {
  auto process() const -> out_y { return 1; }
};
struct certain {
  auto process() const noexcept -> out_y { return 1; }
};
struct on_an_lvalue {
  auto process(in_x x) & -> out_y { return x; }
};
struct on_a_constant {
  auto process(in_x x) const& noexcept -> out_y { return x; }
};
struct chosen {  // an explicit default constructor is allowed
  explicit chosen(double factor = 2) : gain(factor) {}
  auto process(in_x x) -> out_y { return gain * x[cca::x{}]; }
  double gain;
};
struct stateless {
  static auto process(in_x x) -> out_y { return x; }
};
struct by_reference {
  auto process(const in_x& x, const cca::beat& now) -> out_y { return x[cca::x{}] * now.dt(); }
};
struct beat_between {
  auto process(in_x x, cca::beat, cca::optional_in<"z", reading> z) -> out_y {
    return z ? z[cca::x{}] : x[cca::x{}];
  }
};
struct sink {
  void process(in_x) {}
};
struct many {
  auto process(in_x x) -> std::tuple<out_y, cca::maybe<"z", reading>, cca::fault> {
    return {x, {}, cca::fault()};
  }
};
struct one_of_tuple {
  auto process(in_x x) -> std::tuple<out_y> { return out_y(x); }
};
struct only_fault {
  auto process(in_x) -> cca::fault { return {}; }
};
struct inherited : source {};
struct final_one final {
  auto process(in_x x) -> out_y { return x; }
};
template <int Gain>
struct scaled {
  auto process(in_x x) -> out_y { return Gain * x[cca::x{}]; }
};
class hidden_state {
public:
  auto process(in_x x) -> out_y { return sum += x[cca::x{}]; }

private:
  double sum = 0;
};
struct device {
  auto sense(cca::beat) -> out_y { return 0; }
  auto act(in_x) -> cca::fault { return {}; }
};
struct sensor {
  auto sense() -> out_y { return 0; }
};
struct motor {
  void act(in_x) {}
};

struct all : cca::graph<cca::rate<1000>,
                        cca::node<"source", source>,
                        cca::node<"constant", constant>,
                        cca::node<"certain", certain>,
                        cca::node<"on_an_lvalue", on_an_lvalue>,
                        cca::node<"on_a_constant", on_a_constant>,
                        cca::node<"chosen", chosen>,
                        cca::node<"stateless", stateless>,
                        cca::node<"by_reference", by_reference>,
                        cca::node<"beat_between", beat_between>,
                        cca::node<"sink", sink>,
                        cca::node<"many", many>,
                        cca::node<"one_of_tuple", one_of_tuple>,
                        cca::node<"only_fault", only_fault>,
                        cca::node<"inherited", inherited>,
                        cca::node<"final_one", final_one>,
                        cca::node<"scaled", scaled<3>>,
                        cca::node<"hidden_state", hidden_state>,
                        cca::node<"device", device>,
                        cca::node<"sensor", sensor>,
                        cca::node<"motor", motor>,
                        cca::wire<"source.y", "on_an_lvalue.x">,
                        cca::wire<"source.y", "on_a_constant.x">,
                        cca::wire<"source.y", "chosen.x">,
                        cca::wire<"source.y", "stateless.x">,
                        cca::wire<"source.y", "by_reference.x">,
                        cca::wire<"source.y", "beat_between.x">,
                        cca::wire<"source.y", "sink.x">,
                        cca::wire<"source.y", "many.x">,
                        cca::wire<"source.y", "one_of_tuple.x">,
                        cca::wire<"source.y", "only_fault.x">,
                        cca::wire<"source.y", "final_one.x">,
                        cca::wire<"source.y", "scaled.x">,
                        cca::wire<"source.y", "hidden_state.x">,
                        cca::wire<"source.y", "device.x">,
                        cca::wire<"source.y", "motor.x">> {};

static_assert(cca::diagnosis<all>.message.empty());
static_assert(cca::well_formed<all>);

static_assert(cca::Component<source> && cca::Component<device> && cca::Component<motor> &&
              !cca::Component<reading>);
static_assert(cca::ResourceNode<device> && cca::ResourceNode<sensor> && cca::ResourceNode<motor> &&
              !cca::ResourceNode<source>);
static_assert(cca::Graph<all> && !cca::Graph<source>);

// A step is noexcept for every graph. A controller of an unsound graph has all members too, so that the
// compiler prints only one message.
struct unsound : cca::graph<cca::rate<1000>, cca::node<"sink", sink>> {};
static_assert(noexcept(std::declval<cca::controller<all>&>().step()));
static_assert(!cca::well_formed<unsound> && cca::diagnosis<unsound>.rule == "wire.unconnected_input");

// An exposed port counts as wired.
struct shown : cca::graph<cca::rate<1000>, cca::node<"sink", sink>, cca::expose<"sink.x", "x">> {};
static_assert(cca::well_formed<shown>);

// Within a beat no data flow from a component back to `sense`, nor from `act` back to a component; a beat
// later they may.
struct relay {
  auto sense(in_x x) -> out_y { return x; }
  auto act(cca::in<"w", reading> w) -> cca::out<"z", reading> { return w; }
};
template <class... Policy>
struct back : cca::graph<cca::rate<1000>,
                         cca::node<"source", source>,
                         cca::node<"relay", relay>,
                         cca::node<"sink", sink>,
                         cca::wire<"source.y", "relay.w">,
                         cca::wire<"source.y", "relay.x", Policy...>,
                         cca::wire<"relay.z", "sink.x", cca::delayed<1>>> {};
template <class... Policy>
struct forth : cca::graph<cca::rate<1000>,
                          cca::node<"source", source>,
                          cca::node<"relay", relay>,
                          cca::node<"sink", sink>,
                          cca::wire<"source.y", "relay.w">,
                          cca::wire<"source.y", "relay.x", cca::delayed<1>>,
                          cca::wire<"relay.z", "sink.x", Policy...>> {};
static_assert(cca::diagnosis<back<>>.rule == "graph.algebraic_loop" &&
              cca::diagnosis<forth<>>.rule == "graph.algebraic_loop");
static_assert(cca::well_formed<back<cca::delayed<1>>> && cca::well_formed<forth<cca::delayed<1>>>);

}  // namespace

bool components_accepted() {
  cca::controller<all> c;
  return c.step();
}
