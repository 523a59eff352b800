// A policy that was trained elsewhere, as a component: `cca-policy import` writes its contract and network.
//
//   #include "walk.hpp"                              by cca-policy, from walk.onnx
//   struct walking : cca::imported_policy<walk::contract,
//                                         cca::policy_inputs<cca::in<"base_ang_vel", gyro>,
//                                                            cca::in<"joint_pos", leg_angles>>,
//                                         commanded_angles> {};
//   cca::node<"walk", walking, cca::timed<20>>       at the policy's rate
//
//   in  <names of the terms>   the robot's spaces       any order of joints; matched by name
//   in  "applied"  joint angles           optional_in, if you list it: the targets that the robot follows now
//   out "output"   To                     maybe; targets of the joints, within the limits of the axes
//   out "status"   policy_status_port     the worst that was seen
//   out "term"     policy_term_port       in which term of the contract; -1: in none; `term_name(i)` names it
//
// The compiler compares each port with its term: domain type, frame, names, limits, rate. The first
// difference is the message (contract_check.hpp). Another order of joints costs nothing: the numbers are read
// where they stand. Scales, default pose, clips, signs, history and the last action are the contract's.
//
//   policy_status   published
//   usable          output
//   unseen          output; a number is outside of the range that was seen in training
//   stale           output; an observation is older than the contract allows
//   waiting         status only; an input has no sample yet
//   unreadable      status only; a number is NaN, infinite or beyond 1e12. History and memory stay as they were
//   silent          only a policy_watchdog says so: the policy has not answered
//
// The parameter `file` names the weights. They are read on load, and refused if they belong to another
// contract or another export. `on_start` clears history, memory and last action; history and last action
// begin as the contract says, or, with "applied", in the middle of a motion: a history full of the first
// observation, and the action whose target is applied. Errors: mapping.policy_*; `cca::refused` for files. No
// allocation in a beat. Memory: its weights. Example: tests/runtime/policies/; docs/policies.md.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include <cca/base/file.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/mapping/imported/contract_check.hpp>
#include <cca/mapping/imported/observation_history.hpp>
#include <cca/mapping/imported/weights_file.hpp>

namespace cca {

enum class policy_status : std::uint8_t { usable, unseen, stale, waiting, unreadable, silent };

struct policy_axis : dimension<"policy"> {};
struct policy_status_port : space<status, axes<policy_axis>> {};
struct policy_term_port : space<number, axes<policy_axis>> {};

constexpr std::string_view name_of(policy_status s) {
  constexpr std::string_view names[] = {"usable", "unseen", "stale", "waiting", "unreadable", "silent"};
  return names[static_cast<std::size_t>(s)];
}

template <class Contract, class Inputs, Space To>
struct imported_policy;

template <class Contract, class... In, Space To>
struct imported_policy<Contract, policy_inputs<In...>, To> {
  using check = detail::contract_check<Contract, policy_inputs<In...>, To>;
  static_assert(detail::holds_or_tells<check::holds, check>::value);

  using contract = Contract;
  using number = typename Contract::number;
  using network = typename Contract::network;
  using weight_array = std::array<number, static_cast<std::size_t>(network::weights)>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (text<200>, file));
  };
  parameters p{};
  weight_array weights{};

  auto process(In... inputs, beat now)
      -> std::tuple<maybe<"output", To>, out<"status", policy_status_port>, out<"term", policy_term_port>> {
    maybe<"output", To> output;
    doubt found;
    frame seen;
    if constexpr (check::holds) {
      observe(found, seen, now, typename Contract::terms{}, inputs...);
      if (found.what < policy_status::waiting && !is_usable(seen)) [[unlikely]]
        find_unreadable(found, seen);
      if (found.what < policy_status::waiting) [[likely]] {
        if (begins) [[unlikely]]
          begin_from(seen, inputs...);
        begins = false;
        history.add(seen);
        const auto a = network::answer(weights.data(), history.numbers(), memory);
        if (detail::all_finite(a)) output = targets(a);
        else found.note(policy_status::unreadable, -1);
      }
    }
    policy_term_port::vector_type where;
    where[0] = found.term;
    return {output, policy_status_port::vector_type(static_cast<double>(found.what)), where};
  }

  // The name of a term by its number on the port `term`; of another one "".
  static constexpr std::string_view term_name(int i) { return name_of(i, typename Contract::terms{}); }

  void on_load() {
    if (!p.file.view().empty()) return read(std::string(p.file.view()));
    if (std::ranges::all_of(weights, [](number w) { return w == 0; }))
      throw refused(
          "cca::imported_policy: it has no weights; name the file that cca-policy wrote beside its "
          "header in the parameter `file`");
  }
  void on_start() {
    history.clear();
    memory.setZero();
    last.setZero();
    begins = true;
  }

  // If a file is refused, nothing changes.
  void read(const std::string& file) {
    const auto copy = std::make_unique<weight_array>();
    detail::read_policy_weights<number>(detail::read_file(file), file, Contract::name, Contract::lines,
                                        *copy);
    weights = *copy;
  }

private:
  static constexpr int width = detail::numbers_of_terms(typename Contract::terms{});
  static constexpr int moved = detail::size_of_term<typename Contract::action>;
  using frame = neural::numbers<number, width>;

  struct doubt {
    policy_status what = policy_status::usable;
    int term = -1;
    void note(policy_status worse, int which) {
      if (worse <= what) return;
      what = worse;
      term = which;
    }
  };

  // After a start in the middle of a motion: the history is full of the present observation, and the last
  // action is the one whose target is applied.
  void begin_from(frame& seen, const In&... inputs) { (take_applied(seen, inputs), ...); }
  template <class Port>
  void take_applied(frame& seen, const Port& applied) {
    if constexpr (detail::is_applied<Port>) {
      if (!detail::has_come(applied)) return;
      using action = typename Contract::action;
      constexpr policy_range clip = detail::clip_of<action>();
      for (int i = 0; i < moved; ++i) {
        const policy_number& one = action::numbers[static_cast<std::size_t>(i)];
        const int place = detail::places_of<action, typename Port::space>[static_cast<std::size_t>(i)];
        double a = one.sign * (applied.vector()[place] - one.rest) / one.scale;
        if constexpr (detail::bounds(clip)) a = std::min(std::max(a, clip.lower), clip.upper);
        last[i] = static_cast<number>(std::min(std::max(a, -largest_input), largest_input));
      }
      see_last(seen, typename Contract::terms{});
      history.fill(seen);
    }
  }
  template <class... Terms>
  void see_last(frame& seen, policy_terms<Terms...>) const {
    int at = 0;
    ((see_last_in<Terms>(seen, at), at += detail::size_of_term<Terms>), ...);
  }
  template <class Term>
  void see_last_in(frame& seen, int at) const {
    if constexpr (detail::observes_action<Term>)
      for (int i = 0; i < moved; ++i)
        seen[at + i] =
            static_cast<number>(number_of<Term>(static_cast<std::size_t>(i), static_cast<double>(last[i])));
  }

  template <class... Terms>
  void observe(doubt& found, frame& seen, beat now, policy_terms<Terms...>, const In&... inputs) const {
    int at = 0, which = 0;
    ((observe_term<Terms>(found, seen, now, at, which, inputs...), at += detail::size_of_term<Terms>,
      ++which),
     ...);
  }
  template <class Term>
  void observe_term(doubt& found, frame& seen, beat now, int at, int which, const In&... inputs) const {
    if constexpr (detail::observes_action<Term>) {
      see_last_in<Term>(seen, at);
    } else {
      (read_port<Term, In>(found, seen, now, at, which, inputs), ...);
    }
  }
  template <class Term, class Port>
  [[gnu::always_inline]] void read_port(
      doubt& found, frame& seen, beat now, int at, int which, const Port& input) const {
    if constexpr (Port::name == Term::name) {
      using space = typename Port::space;
      constexpr policy_range range = detail::seen_in<Term>();
      if (input.origin() == never) return found.note(policy_status::waiting, which);
      if (static_cast<double>(now.time() - input.origin()) > 1e9 * Contract::oldest)
        found.note(policy_status::stale, which);
      const auto& q = input.vector();
      if constexpr (detail::bounds(range))
        if (q.minCoeff() < range.lower || q.maxCoeff() > range.upper)
          found.note(policy_status::unseen, which);
      [&]<std::size_t... I>(std::index_sequence<I...>) {
        ((seen[at + static_cast<int>(I)] =
              static_cast<number>(number_of<Term>(I, q[detail::places_of<Term, space>[I]]))),
         ...);
      }(std::make_index_sequence<Term::numbers.size()>{});
    }
  }

  template <class Term>
  [[gnu::always_inline]] static double number_of(std::size_t i, double q) {
    constexpr policy_range clip = detail::clip_of<Term>();
    const policy_number& one = Term::numbers[i];
    double x = one.sign * (q - one.rest);
    if constexpr (detail::clips_scaled<Term>()) x *= one.scale;
    if constexpr (detail::bounds(clip)) x = std::min(std::max(x, clip.lower), clip.upper);
    if constexpr (!detail::clips_scaled<Term>()) x *= one.scale;
    return x;
  }

  // Finite, and not so large that a network could become infinite.
  static bool is_usable(const frame& seen) {
    return detail::all_finite(seen) && seen.cwiseAbs().maxCoeff() <= static_cast<number>(largest_input);
  }
  [[gnu::noinline]] static void find_unreadable(doubt& found, const frame& seen) {
    constexpr auto sizes = detail::sizes_of(typename Contract::terms{});
    int at = 0, which = 0;
    for (const int size : sizes) {
      for (int i = 0; i < size; ++i)
        if (!(std::abs(seen[at + i]) <= static_cast<number>(largest_input)))
          found.note(policy_status::unreadable, which);
      at += size;
      ++which;
    }
  }

  typename To::vector_type targets(const neural::numbers<number, moved>& a) {
    using action = typename Contract::action;
    constexpr policy_range clip = detail::clip_of<action>(), of_target = detail::target_clip_of<action>();
    constexpr auto& space = detail::space_of<To>;
    typename To::vector_type result;
    for (int i = 0; i < moved; ++i) {
      const policy_number& one = action::numbers[static_cast<std::size_t>(i)];
      const int place = detail::places_of<action, To>[static_cast<std::size_t>(i)];
      double x = static_cast<double>(a[i]);
      if constexpr (detail::bounds(clip)) x = std::min(std::max(x, clip.lower), clip.upper);
      last[i] = action::observed_clipped ? static_cast<number>(x) : a[i];
      x = std::min(std::max(one.sign * one.rest + one.scale * x, of_target.lower), of_target.upper);
      result[place] = std::min(std::max(one.sign * x, std::max(space.lower[place], -largest_input)),
                               std::min(space.upper[place], largest_input));
    }
    return result;
  }

  template <class... Terms>
  static constexpr std::string_view name_of(int i, policy_terms<Terms...>) {
    constexpr std::string_view names[] = {Terms::name..., {}};
    return i >= 0 && i < static_cast<int>(sizeof...(Terms)) ? names[i] : std::string_view{};
  }

  detail::observation_history<Contract> history;
  neural::numbers<number, network::memory> memory = neural::numbers<number, network::memory>::Zero();
  neural::numbers<number, moved> last = neural::numbers<number, moved>::Zero();
  bool begins = true;
};

}  // namespace cca
