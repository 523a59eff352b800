// Unusual graphs that are allowed: each is sound, and its controller compiles.
#include <cca/cca.hpp>

#include "rules_parts.hpp"

namespace {

using namespace parts;

// The graph is sound, and every function of its controller can be instantiated.
template <class Graph>
bool runs() {
  static_assert(cca::well_formed<Graph>);
  static_assert(cca::diagnosis<Graph>.rule.empty() && cca::diagnosis<Graph>.where.empty() &&
                cca::diagnosis<Graph>.message.empty());
  cca::controller<Graph> c;
  c.load();
  c.start();
  c.step();
  c.stop();
  c.save();
  return c.state() == cca::state::created;
}

// [[forms of a function]]
struct by_reference {
  auto process(const cca::in<"x", signal>& x, const cca::beat&) -> cca::out<"y", signal> {
    return x.vector();
  }
};
struct by_constant {
  auto process(const cca::in<"x", signal> x, const cca::beat) -> cca::out<"y", signal> { return x.vector(); }
};
struct static_function {
  static auto process(cca::in<"x", signal> x) -> cca::out<"y", signal> { return x.vector(); }
};
struct static_noexcept {
  static auto process(cca::in<"x", signal> x) noexcept -> cca::out<"y", signal> { return x.vector(); }
};
struct constant_function {
  auto process(cca::in<"x", signal> x) const -> cca::out<"y", signal> { return x.vector(); }
};
struct constant_noexcept {
  auto process(cca::in<"x", signal> x) const noexcept -> cca::out<"y", signal> { return x.vector(); }
};
struct noexcept_function {
  auto process(cca::in<"x", signal> x) noexcept -> cca::out<"y", signal> { return x.vector(); }
};
struct deduced {
  auto process(cca::in<"x", signal> x) { return cca::out<"y", signal>(x.vector()); }
};
struct beat_first {
  auto process(cca::beat, cca::in<"x", signal> x) -> std::tuple<cca::out<"y", signal>> { return x.vector(); }
};
struct may_stop {
  auto process(cca::in<"x", signal> x)
      -> std::tuple<cca::fault, cca::out<"y", signal>, cca::maybe<"z", signal>> {
    return {cca::fault(), x.vector(), {}};
  }
};
struct virtual_function {
  virtual auto process(cca::in<"x", signal> x) -> cca::out<"y", signal> { return x.vector(); }
  virtual ~virtual_function() = default;
  virtual_function() = default;
  virtual_function(const virtual_function&) = default;
  virtual_function& operator=(const virtual_function&) = default;
};
struct inherited : by_reference {};
struct final_one final : constant_function {
  void on_start() {}
};
class with_secrets {
public:
  auto process(cca::in<"x", signal> x) -> cca::out<"y", signal> {
    seen += p;
    return x.vector();
  }

private:
  int seen = 0;
  int p = 1;
};
template <int Gain, class Space>
struct scaled {
  auto process(cca::in<"x", Space> x) -> cca::out<"y", Space> { return (Gain * x.vector()).eval(); }
};

template <class Component>
struct middle : khz<cca::node<"a", source<>>,
                    cca::node<"b", Component>,
                    cca::node<"c", sink<>>,
                    cca::wire<"a.y", "b.x">,
                    cca::wire<"b.y", "c.x">> {};

bool functions() {
  return runs<middle<by_reference>>() && runs<middle<by_constant>>() && runs<middle<static_function>>() &&
         runs<middle<static_noexcept>>() && runs<middle<constant_function>>() &&
         runs<middle<constant_noexcept>>() && runs<middle<noexcept_function>>() && runs<middle<deduced>>() &&
         runs<middle<beat_first>>() && runs<middle<may_stop>>() && runs<middle<virtual_function>>() &&
         runs<middle<inherited>>() && runs<middle<final_one>>() && runs<middle<with_secrets>>() &&
         runs<middle<scaled<3, signal>>>();
}

// [[names]]
struct same_name {
  auto process(cca::in<"x", signal> x) -> cca::out<"x", signal> { return x.vector(); }
};
struct names : khz<cca::node<"x", source<>>,
                   cca::node<"y", same_name>,
                   cca::node<"process", same_name>,
                   cca::node<"Bein-links 1", sink<>>,
                   cca::wire<"x.y", "y.x">,
                   cca::wire<"y.x", "process.x">,
                   cca::wire<"process.x", "Bein-links 1.x">> {};

// [[small graphs]]
struct nothing_at_all : khz<> {};
struct nothing_inside : khz<cca::node<"g", nothing_at_all>> {};
struct senses {
  auto sense() -> cca::out<"y", signal> { return {}; }
};
struct acts {
  void act(cca::in<"x", signal>) {}
};
struct only_resource : khz<cca::node<"r", senses>> {};
struct from_sense_to_act : khz<cca::node<"s", senses>, cca::node<"a", acts>, cca::wire<"s.y", "a.x">> {};
struct deaf_actor : khz<cca::node<"a", acts>, cca::expose<"a.x", "x">> {};
struct around_deaf_actor
    : khz<cca::node<"g", deaf_actor>, cca::node<"s", source<>>, cca::wire<"s.y", "g.x">> {};
struct rate_of_space : cca::space<cca::number, cca::axes<cca::x>, cca::rate<250>> {};
struct rate_from_space : cca::graph<cca::node<"a", source<rate_of_space>>> {};
struct rate_of_fraction : cca::graph<cca::rate<0.5>, cca::node<"a", source<>>> {};
struct unheard_listener : khz<cca::node<"a", listener<>, cca::timed<3>>> {};
struct nobody_acts
    : khz<cca::node<"a", source<>, cca::inactive>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};

// [[nesting]]
struct hears : cca::graph<cca::node<"a", sink<>>,
                          cca::node<"b", sink<>>,
                          cca::node<"c", step<>>,
                          cca::expose<"a.x", "x">,
                          cca::expose<"b.x", "x">,
                          cca::expose<"c.x", "x">,
                          cca::expose<"c.y", "y">> {};
struct fans_out : khz<cca::node<"s", source<>>,
                      cca::node<"g", hears>,
                      cca::node<"h", hears>,
                      cca::node<"e", sink<>>,
                      cca::wire<"s.y", "g.x">,
                      cca::wire<"g.y", "h.x">,
                      cca::wire<"h.y", "e.x", cca::queue<3, cca::drop_oldest>>> {};
struct same_name_in_and_out
    : cca::graph<cca::node<"a", step<>>, cca::expose<"a.x", "v">, cca::expose<"a.y", "v">> {};
struct through : khz<cca::node<"g", same_name_in_and_out>, cca::wire<"g.v", "g.v", cca::delayed<2>>> {};
struct deep0 : cca::graph<cca::node<"a", step<>>, cca::expose<"a.x", "x">, cca::expose<"a.y", "y">> {};
struct deep1 : cca::graph<cca::node<"a", deep0>, cca::expose<"a.x", "x">, cca::expose<"a.y", "y">> {};
struct deep2
    : cca::graph<cca::rate<1000>, cca::node<"a", deep1>, cca::expose<"a.x", "x">, cca::expose<"a.y", "y">> {};
struct deep : khz<cca::node<"a", deep2>,
                  cca::node<"b", deep2>,
                  cca::wire<"a.y", "b.x">,
                  cca::wire<"b.y", "a.x", cca::delayed<1>>> {};
struct items_in_any_order : cca::graph<cca::wire<"a.y", "b.x">,
                                       cca::node<"b", sink<>>,
                                       cca::expose<"a.y", "z">,
                                       cca::rate<10>,
                                       cca::node<"a", source<>>> {};

bool graphs() {
  return runs<names>() && runs<nothing_at_all>() && runs<nothing_inside>() && runs<only_resource>() &&
         runs<from_sense_to_act>() && runs<deaf_actor>() && runs<around_deaf_actor>() &&
         runs<rate_from_space>() && runs<rate_of_fraction>() && runs<unheard_listener>() &&
         runs<nobody_acts>() && runs<fans_out>() && runs<through>() && runs<deep>() &&
         runs<items_in_any_order>() &&
         runs<cca::graph<cca::rate<1000>, cca::node<"a", source<>>>>();  // a graph without a name
}

// [[observing]]
struct watcher {
  auto process(cca::observe<"**"> all, cca::beat) -> cca::out<"count", signal> {
    return static_cast<double>(all.size());
  }
};
struct watched : khz<cca::node<"a", source<>>,
                     cca::node<"b", step<>>,
                     cca::node<"w", watcher>,
                     cca::wire<"a.y", "b.x">> {};
struct alone : khz<cca::node<"w", watcher, cca::timed<1>>, cca::node<"a", source<>>> {};

// [[strategies]]
struct every_third {
  template <class Inputs>
  static bool fires(cca::beat now, const Inputs& in) {
    return now.index() % 3 == 0 && in.template get<"x">().fresh();
  }
};
struct strategies : khz<cca::node<"a", source<>, cca::full_speed>,
                        cca::node<"b", step<>, every_third>,
                        cca::node<"c", step<>, cca::timed<5, 12>>,
                        cca::node<"d", step<>, cca::any_of<cca::moderate, cca::timeout<15>>>,
                        cca::node<"e", step<>, cca::all_of<cca::restless, every_third>>,
                        cca::node<"f", sink<>, cca::timed<5, -3>>,
                        cca::wire<"a.y", "b.x">,
                        cca::wire<"b.y", "c.x">,
                        cca::wire<"c.y", "d.x">,
                        cca::wire<"d.y", "e.x">,
                        cca::wire<"c.y", "f.x">> {};

bool others() { return runs<watched>() && runs<alone>() && runs<strategies>(); }

}  // namespace

bool odd_and_allowed() { return functions() && graphs() && others(); }
