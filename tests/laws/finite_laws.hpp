// The laws of input_status.hpp, stated once and run for every component of adaptive/, mapping/ and motor/:
//
//   `parameters values;` gives each field a value (parameter_laws.hpp);
//   any accepted parameters, any rate and any finite inputs keep all outputs finite, and a start makes the
//   component as good as new; NaN and infinity in any input, for one beat or many, leave no trace, and the
//   status says that they are there.
//
// A case is derived from `finite_case<Component>` and changes what differs: `made()`, and the constants
// below. The ports are read from the signature of `process`; all optional inputs are wired in half of the
// runs. NaN comes in all inputs at once, or in one that is read in every beat.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include <doctest/doctest.h>

#include <cca/adaptive/ode_status.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>

#include "law.hpp"
#include "parameter_laws.hpp"

namespace laws {

template <class Type>
struct finite_case {
  using component = Type;
  static auto made() { return std::make_unique<Type>(); }
  static constexpr bool says_unreadable = true;  // its status; else it has none
  static constexpr bool passes_nan = false;      // the output is not finite either, in that beat
  static constexpr bool forgets = true;  // a start makes it as good as new (learners keep what they know)
  // Beats until NaN has left no trace (a hold time begins again). Then the parameters are those of made().
  static constexpr int settles_in = 0;
};

// Numbers from a seed.
class numbers {
public:
  explicit numbers(std::uint64_t seed) : bits(seed) {}
  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }

  double usual() { return uniform(-1, 1); }
  // Zeros, denormals, small and large numbers, evenly over the exponents.
  double finite() {
    switch (below(8)) {
      case 0:
        return 0;
      case 1:
        return uniform(-1, 1) * 1e-310;
      case 2:
        return below(2) ? 1e300 : -1e300;
      case 3:
        return uniform(-1, 1) * std::pow(10.0, uniform(-300, 300));
      case 4:
        return uniform(-1, 1) * std::pow(10.0, uniform(-3, 14));
      default:
        return uniform(-10, 10);
    }
  }
  double broken() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const int which = below(3);
    return which == 0 ? std::numeric_limits<double>::quiet_NaN() : which == 1 ? inf : -inf;
  }

private:
  std::mt19937_64 bits;
};

enum class feed { usual, finite, all_broken, one_broken };

// Read in some beats only.
constexpr bool is_read_always(std::string_view port) {
  for (const std::string_view one :
       {"start", "restart", "manual", "automatic", "near", "teacher", "learn", "demonstration"})
    if (port == one) return false;
  return true;
}

namespace detail {

template <class Port> concept Optional = requires(Port port) { port.set_wired(); };

template <class Parameter>
constexpr bool is_derived = false;
template <class Function, cca::fixed_string Port>
constexpr bool is_derived<cca::derived<Function, Port>> = true;

// One argument of a call; `broken`: with a number that is none.
template <class Port>
Port argument(numbers& n, feed what, bool wired, bool broken, std::int64_t time) {
  typename Port::vector_type v = cca::sample<typename Port::space>{}.vector();
  for (int i = 0; i < v.size(); ++i) {
    if constexpr (std::is_same_v<typename Port::space::domain, cca::status>) v[i] = n.below(4);
    else v[i] += 0.3 * n.usual();
    if (what == feed::finite) v[i] = n.finite();
  }
  if (broken) v[n.below(static_cast<int>(v.size()))] = n.broken();
  Port port(v, time, true);
  if constexpr (Optional<Port>)
    if (wired) port.set_wired();
  return port;
}

template <class Process>
struct call_of;
template <class Component, class Result, class... Arguments>
struct call_of<Result (Component::*)(Arguments...)> {
  template <class C>
  static Result make(C& c, numbers n, feed what, bool wired, const cca::beat& now) {
    constexpr int count = (could_break<std::remove_cvref_t<Arguments>>(true) + ... + 0);
    int could = 0;
    (void)((could += could_break<std::remove_cvref_t<Arguments>>(wired)), ...);
    int left = could > 0 ? n.below(could) : count;  // how many to pass over before the broken one
    // In braces: from left to right.
    std::tuple<std::remove_cvref_t<Arguments>...> all{[&]() -> std::remove_cvref_t<Arguments> {
      using type = std::remove_cvref_t<Arguments>;
      if constexpr (std::is_same_v<type, cca::beat>) {
        return now;
      } else if constexpr (is_derived<type>) {
        return {};  // it is computed where it is asked for
      } else {
        const bool chosen = could_break<type>(wired) > 0 && left-- == 0;
        const bool broken = what == feed::all_broken || (what == feed::one_broken && chosen);
        return argument<type>(n, what, wired, broken, now.time());
      }
    }()...};
    return std::apply([&](const auto&... each) { return c.process(each...); }, all);
  }
  template <class Type>
  static constexpr int could_break(bool wired) {
    if constexpr (std::is_same_v<Type, cca::beat> || is_derived<Type>) return 0;
    else return is_read_always(Type::name) && (wired || !Optional<Type>);
  }
};

template <class Result>
std::vector<double> all_numbers(const Result& result) {
  std::vector<double> all;
  const auto add = [&](const auto& port) {
    if constexpr (requires { port.vector(); }) {
      if constexpr (requires { static_cast<bool>(port); }) all.push_back(static_cast<bool>(port));
      all.insert(all.end(), port.vector().begin(), port.vector().end());
    }
  };
  if constexpr (requires { result.vector(); }) add(result);
  else std::apply([&](const auto&... ports) { (add(ports), ...); }, result);
  return all;
}

inline bool finite(const std::vector<double>& all) {
  for (const double one : all)
    if (!std::isfinite(one)) return false;
  return true;
}

// True if one of its statuses says that an input is unreadable.
template <class Result>
bool says_unreadable(const Result& result) {
  const auto one = [](const auto& port) {
    if constexpr (requires { typename std::remove_cvref_t<decltype(port)>::space; }) {
      using space = typename std::remove_cvref_t<decltype(port)>::space;
      if constexpr (std::is_same_v<space, cca::ode_status_port>)
        return port.vector()[0] == cca::status_of(cca::ode_status::unreadable);
      else if constexpr (std::is_same_v<space, cca::input_status_port>)
        return port.vector()[0] == cca::status_of(cca::input_status::unreadable);
      else return false;
    } else {
      return false;
    }
  };
  if constexpr (requires { result.vector(); }) return one(result);
  else return std::apply([&](const auto&... ports) { return (one(ports) || ...); }, result);
}

// Random values within the bounds, often the bounds themselves; what has no bound, up to 1e12.
inline void draw(const cca::detail::schema& type, const void* value, numbers& n) {
  using cca::detail::kind;
  auto* to = const_cast<void*>(value);
  const auto among = [&](double low, double high) {
    const double least = std::max(low, -1e12), most = std::min(high, 1e12);
    switch (n.below(5)) {
      case 0:
        return least;
      case 1:
        return most;
      case 2:
        return n.uniform(least, most);
      default:
        return std::clamp(n.uniform(-1, 1) * std::pow(10.0, n.uniform(-6, 4)), least, most);
    }
  };
  switch (type.what) {
    case kind::number:
      if (n.below(2)) type.set_number(to, among(type.lower, type.upper));
      break;
    case kind::boolean:
      type.set_integer(to, n.below(2));
      break;
    case kind::integer:
      type.set_integer(to, std::clamp<std::int64_t>(n.below(9), type.lowest, type.highest));
      break;
    case kind::choice: {
      const auto i = static_cast<std::size_t>(n.below(static_cast<int>(type.count)));
      if (!type.names[i].empty()) type.set_integer(to, static_cast<std::int64_t>(i));
      break;
    }
    case kind::array:
      for (std::size_t i = 0; i < type.count; ++i) draw(*type.element, type.at(value, i), n);
      break;
    case kind::table:
      for (std::size_t i = 0; i < type.count; ++i) draw(*type.members[i].type, type.members[i].of(value), n);
      break;
    default:
      break;
  }
}

// Each table of values that is refused keeps those of the default.
template <class Component>
void draw_parameters(Component& c, numbers& n) {
  if constexpr (cca::HasParameters<Component>) {
    using type = typename Component::parameters;
    const auto& schema = cca::detail::schema_of<type>;
    for (std::size_t i = 0; i < schema.count; ++i)
      for (int tries = 0; tries < 20; ++tries) {
        type wanted = c.p;
        draw(*schema.members[i].type, schema.members[i].of(&wanted), n);
        std::vector<cca::detail::complaint> wrong;
        cca::detail::check(schema, &wanted, "", wrong);
        if (!wrong.empty()) continue;
        c.p = wanted;
        break;
      }
  }
}

template <class Component>
void start(Component& c) {
  if constexpr (requires { c.on_load(); }) c.on_load();
  if constexpr (requires { c.on_start(); }) c.on_start();
}

template <class Case>
using call = call_of<decltype(&Case::component::process)>;

}  // namespace detail

template <class Case>
auto step(typename Case::component& c, std::uint64_t seed, feed what, bool wired, const cca::beat& now) {
  return detail::call<Case>::make(c, numbers(seed), what, wired, now);
}

// Any accepted parameters, any rate, any finite inputs.
template <class Case>
void stays_finite(std::uint64_t runs = 40) {
  if constexpr (cca::HasParameters<typename Case::component>)
    begins_with_values<typename Case::component::parameters>();
  constexpr std::int64_t periods[]{100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};
  for (std::uint64_t run = 0; run < runs; ++run) {
    numbers n(run);
    const auto c = Case::made();
    detail::draw_parameters(*c, n);
    detail::start(*c);
    const auto fresh = std::make_unique<typename Case::component>(*c);
    const std::int64_t period = periods[n.below(5)];
    const bool wired = n.below(2);
    bool all = true;
    for (std::int64_t k = 0; k < 100; ++k) {
      const feed what = n.below(3) ? feed::finite : feed::usual;
      all = all && detail::finite(detail::all_numbers(step<Case>(
                       *c, 1000 * run + static_cast<std::uint64_t>(k), what, wired, {k, period, 1})));
    }
    CHECK_MESSAGE(all, "run " << run << ": finite inputs made an output that is not finite");
    if constexpr (Case::forgets) {
      if constexpr (requires { c->on_start(); }) c->on_start();
      bool same = true;
      for (std::int64_t k = 0; k < 50; ++k) {
        const cca::beat now(k, period, 1);
        const auto seed = 7 * run + static_cast<std::uint64_t>(k);
        same = same && detail::all_numbers(step<Case>(*c, seed, feed::usual, wired, now)) ==
                           detail::all_numbers(step<Case>(*fresh, seed, feed::usual, wired, now));
      }
      CHECK_MESSAGE(same, "run " << run << ": after a start it is not as good as new");
    }
  }
}

// A twin does not see the broken beats; afterwards both do the same.
template <class Case>
void nan_leaves_no_trace() {
  for (std::uint64_t run = 0; run < 40; ++run) {
    numbers n(run);
    const auto c = Case::made();
    if (run % 2 && Case::settles_in == 0) detail::draw_parameters(*c, n);
    detail::start(*c);
    const bool wired = n.below(2);
    const auto go = [&](typename Case::component& one, std::int64_t k, feed what) {
      return step<Case>(one, 1000 * run + static_cast<std::uint64_t>(k), what, wired, {k, 1'000'000, 1});
    };
    for (std::int64_t k = 0; k < 40; ++k) (void)go(*c, k, feed::usual);
    const auto twin = std::make_unique<typename Case::component>(*c);
    const int length = run % 3 == 0 ? 1 : 50;
    bool finite = true, said = true;
    for (std::int64_t k = 0; k < length; ++k) {
      const auto result = go(*c, 100 + k, run % 4 < 2 ? feed::all_broken : feed::one_broken);
      finite = finite && detail::finite(detail::all_numbers(result));
      said = said && detail::says_unreadable(result);
    }
    CHECK_MESSAGE((finite || Case::passes_nan), "run " << run << ": NaN reached an output");
    if constexpr (Case::says_unreadable) CHECK_MESSAGE(said, "run " << run << ": its status does not say so");
    bool same = true;
    for (std::int64_t k = 0; k < 60 + Case::settles_in; ++k) {
      const bool equal = detail::all_numbers(go(*c, 200 + k, feed::usual)) ==
                         detail::all_numbers(go(*twin, 200 + k, feed::usual));
      if (k >= Case::settles_in) same = same && equal;
    }
    CHECK_MESSAGE((same || !Case::forgets), "run " << run << ": NaN left a trace");
  }
}

// In some run an output follows from the inputs: a component that only publishes a constant, or what it
// published first, keeps every law above.
template <class Case>
void depends_on_its_inputs() {
  bool differs = false;
  for (std::uint64_t run = 0; run < 40 && !differs; ++run) {
    numbers n(run);
    const auto c = Case::made();
    if (run % 2) detail::draw_parameters(*c, n);
    detail::start(*c);
    const auto twin = std::make_unique<typename Case::component>(*c);
    for (std::uint64_t k = 0; k < 100 && !differs; ++k) {
      const cca::beat now(static_cast<std::int64_t>(k), 1'000'000, 1);
      differs = detail::all_numbers(step<Case>(*c, 1000 * run + k, feed::usual, true, now)) !=
                detail::all_numbers(step<Case>(*twin, 7'000'000 + 1000 * run + k, feed::usual, true, now));
    }
  }
  CHECK_MESSAGE(differs, "whatever its inputs are, its outputs are the same");
}

template <class Case>
void finite() {
  law("stays finite", [] { stays_finite<Case>(); });
  law("NaN leaves no trace", nan_leaves_no_trace<Case>);
  law("depends on its inputs", depends_on_its_inputs<Case>);
}

}  // namespace laws
