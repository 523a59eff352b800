// The component that a cca::test_input (graph/items/test_input.hpp) puts before an input.
//
//   in  "input"       Space          what the input would get
//   out "output"      Space          what it gets: the same, and on one axis the signal
//   out "excitation"  Space          while a test runs: the signal alone
//
// A test begins when `run` becomes larger, with the next sample, and ends by itself after `duration`. It
// also ends when `signal` becomes `off`, when the component stops, and when a fault is resumed. What the
// parameters are at the start begins nothing. While a test runs, other parameters are refused, but for `off`.
// So a test is a change of parameters as any: in one beat, recorded, and the same in a replay.
//
// Its time is that of the beat; it is as fast as the samples of the input. Source of the signals:
// test_signal.hpp. Cost while no test runs: a copy of the sample, which the compiler drops where it can, and
// one comparison.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <cca/base/fixed_string.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/reflect.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/field_types.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/component/signature.hpp>
#include <cca/component/testing/test_mark.hpp>
#include <cca/component/testing/test_signal.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/limits.hpp>

namespace cca {

// The largest amplitude of a test, in the unit of the input.
template <auto Most>
struct up_to {};

namespace detail {

// Half the narrowest range of the axes of the input.
struct by_limits {};

struct refused_test_axis : dimension<"refused"> {};
struct no_tested_space : space<number, axes<refused_test_axis>> {};

// ---- the space of the input ----

template <class Parameter>
struct input_named {
  static constexpr std::string_view name{};
  using type = void;
};
template <fixed_string Name, class Space>
struct input_named<in<Name, Space>> {
  static constexpr std::string_view name = Name.view();
  using type = Space;
};
template <fixed_string Name, class Space>
struct input_named<optional_in<Name, Space>> : input_named<in<Name, Space>> {};

template <fixed_string Port, class Parameters>
struct space_of_tested;
template <fixed_string Port>
struct space_of_tested<Port, list<>> {
  using type = void;
};
template <fixed_string Port, class First, class... Rest>
struct space_of_tested<Port, list<First, Rest...>>
    : std::conditional_t<input_named<First>::name == Port.view(),
                         input_named<First>,
                         space_of_tested<Port, list<Rest...>>> {};

template <class Component, fixed_string Port>
struct tested_space {
  using type = void;
};
template <class Component, fixed_string Port>
  requires requires { &Component::process; }
struct tested_space<Component, Port>
    : space_of_tested<Port, typename function_facts<decltype(&Component::process)>::parameters> {};
// Of a resource node, whose limiter would have to come after the test: robot.unlimited_command says so.
template <class Component, fixed_string Port>
  requires requires { &Component::act; }
struct tested_space<Component, Port>
    : space_of_tested<Port, typename function_facts<decltype(&Component::act)>::parameters> {};

// Vectors that can be added, one number per axis: not a pose, an orientation or a status.
template <class Space>
constexpr bool is_testable() {
  if constexpr (std::is_void_v<Space>) return false;
  else
    return Space::size == Space::axes::count && !std::is_same_v<typename Space::domain, status> &&
           !std::is_void_v<typename Space::domain::quantity>;
}

// ---- the largest amplitude ----

template <class Space, class Range>
struct most_of_test {
  static constexpr double value = [] {
    double most = std::numeric_limits<double>::infinity();
    using quantity = typename Space::domain::quantity;
    for (std::size_t i = 0; i < static_cast<std::size_t>(Space::axes::count); ++i) {
      const double half = 0.5 * (upper_limits<Space, quantity>[i] - lower_limits<Space, quantity>[i]);
      if (!(half >= most)) most = half;
    }
    return most;
  }();
};
template <class Space, auto Most>
struct most_of_test<Space, up_to<Most>> {
  static constexpr double value = static_cast<double>(Most);
};

// ---- refusals ----

// Of a component without this input wire.unknown_port tells.
template <class Component, fixed_string Port>
struct test_of_inner_graph {
  static constexpr void tell(text& m) {
    m << "graph.bad_test_input: `" << type_name<Component>() << "`, whose input `" << Port.view()
      << "` a cca::test_input names, is an inner graph: declare the test input among its own items";
  }
};
template <class Component>
inline constexpr bool is_inner_graph = requires { typename Component::cca_items; };
template <class Component, fixed_string Port, class Space>
struct no_vector_to_test {
  static constexpr void tell(text& m) {
    m << "graph.bad_test_input: the input `" << Port.view() << "` of `" << type_name<Component>()
      << "` has the space `" << type_name<Space>()
      << "`, to which no signal can be added: a test needs one number with a quantity for each axis";
  }
};
template <class Component, fixed_string Port, class Range>
struct no_range_of_test {
  static constexpr void tell(text& m) {
    m << "graph.bad_test_input: the test of the input `" << Port.view() << "` of `" << type_name<Component>()
      << "` has no largest amplitude: give the axes limits, or state it in the unit of the input, as in "
         "cca::test_input<..., cca::up_to<0.1>>, above 0 and finite";
  }
};

// ---- the component ----

template <class Space, double Most>
class test_node_of {
public:
  static constexpr double most = Most;
  using space = Space;
  using amplitude_type = quantity<typename Space::domain::quantity, -Most, Most>;
  using axis_type = bounded<int, 0, Space::axes::count - 1>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (test_signal, signal),
                             (axis_type, axis),
                             (amplitude_type, amplitude),
                             (cca::quantity<cca::frequency, 1e-3, 1e5>, frequency),
                             (cca::quantity<cca::frequency, 1e-3, 1e5>, to),
                             (cca::quantity<cca::duration, 1e-3, 600>, duration),
                             (cca::bounded<int, 0, 1000000000>, run));
    static constexpr bool is_of_test_input = true;
    parameters() : signal(test_signal::off), frequency(1), to(10), duration(10) {}
    // A signal with a frequency needs more than two samples a turn.
    std::string check_at(double step) const {
      const bool is_chirp = signal == test_signal::chirp || signal == test_signal::linear_chirp;
      if (signal == test_signal::off || signal == test_signal::step) return {};
      if (frequency * step < 0.5 && !(is_chirp && to * step >= 0.5)) return {};
      return std::string(frequency * step < 0.5 ? "to" : "frequency") + ": the input gets a sample each " +
             number_text(step) + " s, so a frequency is below half its rate, " + number_text(0.5 / step) +
             " Hz";
    }
  };
  parameters p{};

  // While a test runs, only its end is taken.
  std::string_view refusal_of(const parameters& other) const {
    if (!is_running() || other.signal == test_signal::off || is_same(other)) return {};
    return "run: a test of this input runs: wait for its end, or set `signal` to off";
  }
  bool is_running() const { return p.run > over && p.signal != test_signal::off; }

  void on_start() { end_test(); }
  void on_stop() { end_test(); }
  void end_test() { over = p.run; }

  auto process(in<"input", Space> input, beat now)
      -> std::tuple<out<"output", Space>, maybe<"excitation", Space>> {
    if (p.run <= over) [[likely]]
      return {input.vector(), {}};
    return tested(input.vector(), now.time());
  }

private:
  using vector = typename Space::vector_type;

  [[gnu::noinline]] std::tuple<out<"output", Space>, maybe<"excitation", Space>> tested(vector value,
                                                                                        std::int64_t now) {
    if (begun != p.run) begun = p.run, since = now;
    const std::int64_t nanoseconds = now - since;
    const double t = 1e-9 * static_cast<double>(nanoseconds);
    if (p.signal == test_signal::off || t >= p.duration) {
      over = p.run;
      return {value, {}};
    }
    vector excitation = vector::Zero();
    excitation[p.axis] = p.amplitude * test_value(p.signal, t, p.frequency, p.to, p.duration);
    value += excitation;
    return {value, excitation};
  }
  bool is_same(const parameters& other) const {
    return p.signal == other.signal && p.axis == other.axis && p.amplitude == other.amplitude &&
           p.frequency == other.frequency && p.to == other.to && p.duration == other.duration &&
           p.run == other.run;
  }

  int over = 0, begun = 0;  // runs
  std::int64_t since = 0;   // ns
};

template <class Component, fixed_string Port, class Range>
struct test_facts {
  using found = typename tested_space<Component, Port>::type;
  static constexpr bool has_input = !std::is_void_v<found>;
  static constexpr bool has_vector = is_testable<found>();
  static constexpr double most = [] {
    if constexpr (has_vector) return most_of_test<found, Range>::value;
    else return 1.0;
  }();
  static constexpr bool has_range = most > 0 && most <= largest_double;
  static_assert(holds_or_tells<!is_inner_graph<Component>, test_of_inner_graph<Component, Port>>::value);
  static_assert(holds_or_tells < !has_input || has_vector,
                no_vector_to_test < Component,
                Port,
                found >> ::value);
  static_assert(holds_or_tells<has_range, no_range_of_test<Component, Port, Range>>::value);
  using space = std::conditional_t<has_vector, found, no_tested_space>;
  using type = test_node_of<space, has_range ? most : 1.0>;
};

// Of `servo.reference` the part before the dot, and that after it; without a dot both are empty.
template <std::size_t Size, fixed_string Whole, std::size_t From>
consteval auto piece_of() {
  char all[Size + 1]{};
  for (std::size_t i = 0; i < Size; ++i) all[i] = Whole.text[From + i];
  return fixed_string(all);
}
template <fixed_string Input, std::size_t Dot = Input.view().find('.')>
struct parts_of_input {
  static constexpr auto node = piece_of<Dot, Input, 0>();
  static constexpr auto port = piece_of<Input.view().size() - Dot - 1, Input, Dot + 1>();
};
template <fixed_string Input>
struct parts_of_input<Input, std::string_view::npos> {
  static constexpr auto node = piece_of<0, Input, 0>, port = node;
};

// A type of its own for each tested input, short in messages.
template <fixed_string Input, class Component, class Range>
struct test_node : test_facts<Component, parts_of_input<Input>::port, Range>::type {
  static constexpr std::string_view tested = Input.view();  // in the graph of the node
};

}  // namespace detail
}  // namespace cca
