// The test components, spaces and strategies of the generated architectures. A probe records all that it sees
// and answers as `respond` says.
#pragma once

#include <algorithm>
#include <tuple>
#include <type_traits>

#include <cca/cca.hpp>

#include "firing.hpp"

namespace semantics {

// ---- spaces: n numbers, with and without a rate, and two of joint level ----

struct a0 : cca::dimension<"a0"> {
  static constexpr auto limits = cca::limits{cca::angle{-9, 9}};
};
struct a1 : cca::dimension<"a1"> {
  static constexpr auto limits = cca::limits{cca::angle{-9, 9}};
};
struct a2 : cca::dimension<"a2"> {
  static constexpr auto limits = cca::limits{cca::angle{-9, 9}};
};

struct num1 : cca::space<cca::number, cca::axes<a0>> {};
struct num2 : cca::space<cca::number, cca::axes<a0, a1>> {};
struct num3 : cca::space<cca::number, cca::axes<a0, a1, a2>> {};
struct ang1 : cca::space<cca::joint_angles, cca::axes<a1>> {};
struct ang2 : cca::space<cca::joint_angles, cca::axes<a0, a2>> {};

// The same under another name.
struct also_num1 : cca::space<cca::number, cca::axes<a0>> {};
struct also_num2 : cca::space<cca::number, cca::axes<a0, a1>> {};
struct also_num3 : cca::space<cca::number, cca::axes<a0, a1, a2>> {};
struct also_ang1 : cca::space<cca::joint_angles, cca::axes<a1>> {};
struct also_ang2 : cca::space<cca::joint_angles, cca::axes<a0, a2>> {};

struct pick1 : cca::space<cca::status, cca::axes<cca::x>> {};
// Of one axis of the others.
struct num2_a0 : cca::space<cca::number, cca::axes<a0>> {};
struct num2_a1 : cca::space<cca::number, cca::axes<a1>> {};
struct num3_a0 : cca::space<cca::number, cca::axes<a0>> {};
struct num3_a1 : cca::space<cca::number, cca::axes<a1>> {};
struct num3_a2 : cca::space<cca::number, cca::axes<a2>> {};
struct ang2_a0 : cca::space<cca::joint_angles, cca::axes<a0>> {};
struct ang2_a2 : cca::space<cca::joint_angles, cca::axes<a2>> {};

template <class Space, int Hz>
struct at : cca::space<typename Space::domain, typename Space::axes, cca::rate<Hz>> {};

// ---- components ----

template <class... Ports>
struct reads {};
template <class... Ports>
struct tells {};

namespace detail {

template <class... Results>
struct result {
  using type = std::tuple<Results...>;
};
template <class Result>
struct result<Result> {
  using type = Result;
};
template <>
struct result<> {
  using type = void;
};

template <cca::fixed_string Name, class Space>
void note(firing& f, const cca::in<Name, Space>& x) {
  add_input(f, Name.view(), x.vector().data(), Space::size, x.origin(), x.fresh(), true, x.dropped());
}
template <cca::fixed_string Name, class Space>
void note(firing& f, const cca::optional_in<Name, Space>& x) {
  add_input(f, Name.view(), x.vector().data(), Space::size, x.origin(), x.fresh(), static_cast<bool>(x),
            x.dropped());
}
// The text leaves open in which order an observer hears ports, so they are sorted by path.
template <cca::fixed_string Pattern, class... Policies>
void note(firing& f, const cca::observe<Pattern, Policies...>& all) {
  const auto before = static_cast<std::ptrdiff_t>(f.inputs.size());
  for (const auto& one : all)
    add_input(f, one.path, one.values.data(), static_cast<int>(one.values.size()), one.origin, one.fresh,
              true);
  std::sort(f.inputs.begin() + before, f.inputs.end(),
            [](const recorded_input& a, const recorded_input& b) { return a.name < b.name; });
}

template <cca::fixed_string Name, class Space>
void add_blank(firing& f, const cca::out<Name, Space>*) {
  add_output(f, Space::size, false);
}
template <cca::fixed_string Name, class Space>
void add_blank(firing& f, const cca::maybe<Name, Space>*) {
  add_output(f, Space::size, true);
}
inline void add_blank(firing&, const cca::fault*) {}
// A request for a part or a mode is no port: what it asks for follows from the beat.
template <class Request> concept Asking =
    cca::detail::is_part_request<Request> || cca::detail::is_mode_request<Request>;
template <Asking Request>
void add_blank(firing&, const Request*) {}

// Of all requests of a component: by the letters of the path, and by what is asked.
constexpr int salt_from(int salt, std::string_view letters) {
  for (const char letter : letters) salt = (salt * 31 + letter) % 100003;
  return salt;
}
template <class Request>
inline constexpr int salt_of = salt_from(cca::detail::result_facts<Request>::asked.starts,
                                         cca::detail::result_facts<Request>::asked.path);
template <cca::fixed_string Mode>
inline constexpr int salt_of<cca::switch_to<Mode>> = salt_from(0, Mode.view());

template <class Port>
  requires(!Asking<Port>)
Port port_of(const Port*, const firing& f, std::size_t& next) {
  const recorded_output& t = f.outputs[next++];
  Port port;
  if (t.published) copy_value(t, port.vector().data());
  if (t.sets_origin) port.with_origin(t.origin);
  return port;
}
inline cca::fault port_of(const cca::fault*, const firing& f, std::size_t&) {
  return f.fault ? cca::fault{"as planned"} : cca::fault{};
}

template <Asking Request>
Request port_of(const Request*, const firing& f, std::size_t&) {
  return f.fault ? Request() : Request(wants(f.id, f.beat, salt_of<Request>));
}

// Not inlined: the loop around it is under test, and recording would be most of the optimiser's work.
template <class... Results, class... Inputs>
[[gnu::noinline]] auto answer(
    const habit& h, function which, memory& m, cca::beat now, const Inputs&... inputs) ->
    typename result<Results...>::type {
  firing f;
  f.id = h.id;
  f.which = which;
  f.beat = now.index();
  f.time = now.time();
  f.dt = now.dt();
  f.may_fault = (std::is_same_v<Results, cca::fault> || ...);
  (note(f, inputs), ...);
  (add_blank(f, static_cast<const Results*>(nullptr)), ...);
  respond(h, m, f);
  record(f);
  [[maybe_unused]] std::size_t next = 0;
  if constexpr (sizeof...(Results) > 0)
    return typename result<Results...>::type{port_of(static_cast<const Results*>(nullptr), f, next)...};
}

}  // namespace detail

template <habit H, class Inputs, class Outputs>
struct probe;

template <habit H, class... Inputs, class... Outputs>
struct probe<H, reads<Inputs...>, tells<Outputs...>> {
  memory m;
  auto process(Inputs... inputs, cca::beat now) -> typename detail::result<Outputs...>::type {
    return detail::answer<Outputs...>(H, function::process, m, now, inputs...);
  }
};

namespace detail {

template <habit H>
struct with_on_fault {
  memory m;
  void on_fault() {
    firing f;
    f.id = H.id;
    f.which = function::on_fault;
    record(f);
  }
};

}  // namespace detail

// A resource node with both halves, with `sense` alone, with `act` alone.
template <habit H, class SenseInputs, class SenseOutputs, class ActInputs = void, class ActOutputs = void>
struct device;

template <habit H, class... SI, class... SO, class... AI, class... AO>
struct device<H, reads<SI...>, tells<SO...>, reads<AI...>, tells<AO...>> : detail::with_on_fault<H> {
  auto sense(SI... inputs, cca::beat now) -> typename detail::result<SO...>::type {
    return detail::answer<SO...>(H, function::sense, this->m, now, inputs...);
  }
  auto act(AI... inputs, cca::beat now) -> typename detail::result<AO...>::type {
    return detail::answer<AO...>(H, function::act, this->m, now, inputs...);
  }
};

template <habit H, class... SI, class... SO>
struct device<H, reads<SI...>, tells<SO...>, void, void> : detail::with_on_fault<H> {
  auto sense(SI... inputs, cca::beat now) -> typename detail::result<SO...>::type {
    return detail::answer<SO...>(H, function::sense, this->m, now, inputs...);
  }
};

template <habit H, class... AI, class... AO>
struct device<H, void, void, reads<AI...>, tells<AO...>> : detail::with_on_fault<H> {
  auto act(AI... inputs, cca::beat now) -> typename detail::result<AO...>::type {
    return detail::answer<AO...>(H, function::act, this->m, now, inputs...);
  }
};

// ---- skeletons with parameters ----

template <class Arbiter, std::int64_t Nanoseconds>
struct with_patience : Arbiter {
  with_patience() { this->p.patience = static_cast<double>(Nanoseconds) * 1e-9; }
};
template <class Switch, std::int64_t Nanoseconds>
struct lasting : Switch {
  lasting() { this->p.duration = static_cast<double>(Nanoseconds) * 1e-9; }
};
template <class Blend, int None, int Full>
struct between : Blend {
  between() { this->p = {None, Full}; }
};

// ---- strategies that a user could write ----

template <int N, int Phase>
struct on_beats {
  template <class Inputs>
  static bool fires(cca::beat now, const Inputs&) {
    return now.index() % N == Phase || now.index() % 7 == 0;
  }
};

template <int Microseconds>
struct patient {
  template <class Inputs>
  bool fires(cca::beat now, const Inputs&) const {
    return now.dt() * 1e6 > static_cast<double>(Microseconds);
  }
};

template <cca::fixed_string Port, int Quarters>
struct above {
  template <class Inputs>
  static bool fires(cca::beat, const Inputs& in) {
    return in.template get<Port>().vector()[0] > Quarters * 0.25;
  }
};

template <cca::fixed_string Port, int Nanoseconds>
struct older {
  template <class Inputs>
  bool fires(cca::beat now, const Inputs& in) {
    const auto origin = in.template get<Port>().origin();
    return origin == cca::never || now.time() - origin > Nanoseconds;
  }
};

// One with a state: with every N-th sample that arrives.
template <cca::fixed_string Port, int N>
struct every_nth {
  int come = 0;
  template <class Inputs>
  bool fires(cca::beat, const Inputs& in) {
    come += in.template arrivals<Port>();
    if (come < N) return false;
    come -= N;
    return true;
  }
};

template <cca::fixed_string Port, int N>
struct while_waiting {
  template <class Inputs>
  static bool fires(cca::beat, const Inputs& in) {
    return in.template waiting<Port>() >= N;
  }
};

template <cca::fixed_string Port>
struct fresh_on_odd {
  template <class Inputs>
  static bool fires(cca::beat now, const Inputs& in) {
    return in.template get<Port>().fresh() && now.index() % 2 == 1;
  }
};

}  // namespace semantics
