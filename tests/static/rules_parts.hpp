// What the tests of rules make their graphs of, and the comparison of a diagnosis with what it must say.
#pragma once

#include <string_view>

#include <cca/cca.hpp>

namespace parts {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct toe : cca::dimension<"toe"> {};

struct signal : cca::space<cca::number, cca::axes<cca::x>> {};
struct angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};

template <class Space = signal>
struct source {
  auto process(cca::beat) -> cca::out<"y", Space> { return {}; }
};
template <class Space = signal>
struct step {
  auto process(cca::in<"x", Space> x) -> cca::out<"y", Space> { return x.vector(); }
};
template <class Space = signal>
struct sink {
  void process(cca::in<"x", Space>) {}
};
template <class Space = signal>
struct merge {
  auto process(cca::in<"a", Space> a, cca::in<"b", Space>) -> cca::out<"y", Space> { return a.vector(); }
};
template <class Space = signal>
struct listener {
  void process(cca::optional_in<"x", Space>, cca::optional_in<"z", Space>) {}
};
template <class Space = angles>
struct robot {
  auto sense() -> cca::out<"measured", Space> { return {}; }
  void act(cca::in<"command", Space>) {}
};

// A graph at 1 kHz.
template <class... Items>
using khz = cca::graph<cca::rate<1000>, Items...>;

// What a graph is told; the message without the rule's id. A class, so that the compiler shows what it was
// instead.
struct told {
  std::string_view rule, where, message;

  constexpr bool by(const cca::diagnosis_value& d) const {
    const auto text = d.message;
    return d.rule == rule && d.where == where && text.starts_with(rule) &&
           text.substr(rule.size()).starts_with(": ") && text.substr(rule.size() + 2) == message;
  }
};

// The broken graph, set of modes or deployment is told this, and the mended one is sound.
template <class Broken, class Mended>
constexpr bool tells(told what) {
  return what.by(cca::diagnosis<Broken>) && !cca::well_formed<Broken> && cca::well_formed<Mended> &&
         cca::diagnosis<Mended>.rule.empty() && cca::diagnosis<Mended>.where.empty() &&
         cca::diagnosis<Mended>.message.empty();
}

}  // namespace parts
