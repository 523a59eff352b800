// Watches a policy, and asks for another mode while it can't be trusted: `stand` or `damp`, say.
//
//   cca::policy_watchdog<walking, "stand">            walking: a cca::imported_policy; its node: cca::timed<1>
//
//   in  "status"   policy_status_port   of the policy: wire both with cca::latest
//   in  "term"     policy_term_port
//   out "status"   policy_status_port   what is wrong now; `silent`: the policy has not answered
//   out "term"     policy_term_port     in which term, -1: in none
//   and a cca::switch_to of the mode
//
// It asks when the policy has not been `usable` for as long as the parameter of its present status says:
// `unseen`, `stale`, `waiting`, `unreadable`, and `silent` since its last answer. In s; 0 is at once.
//
//   c.get<"watchdog">().cause()      "walk: joint_pos_rel is unreadable"; empty if it has not asked since on_start
//
// The cause stays until its mode begins again. Cost: some comparisons. Errors: component.bad_parameter,
// modes.unknown_mode. Example: tests/runtime/policies/switching.cpp; docs/policies.md.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>

#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/switch_to.hpp>
#include <cca/mapping/imported/imported_policy.hpp>

namespace cca {

template <class Policy, fixed_string Mode>
struct policy_watchdog {
  using seconds = cca::quantity<cca::duration, 0, 1000>;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (seconds, unseen),
                             (seconds, stale),
                             (seconds, waiting),
                             (seconds, unreadable),
                             (seconds, silent));
  };
  parameters p{0.5, 0, 0.5, 0, 2.5 / Policy::contract::rate};

  auto process(in<"status", policy_status_port> status, in<"term", policy_term_port> term, beat now)
      -> std::tuple<out<"status", policy_status_port>, out<"term", policy_term_port>, switch_to<Mode>> {
    if (begins_) bad_since_ = answered_ = now.time(), begins_ = false;
    if (status.fresh()) {
      answered_ = now.time();
      seen_ = status.vector()[0] >= 0 && status.vector()[0] < static_cast<double>(policy_status::silent)
                  ? static_cast<policy_status>(static_cast<int>(status.vector()[0]))
                  : policy_status::unreadable;
      term_ = static_cast<int>(term.vector()[0]);
    }
    policy_status what = seen_;
    int where = term_;
    const bool is_silent = age(now, answered_) > p.silent;
    if (is_silent) what = policy_status::silent, where = -1;
    if (what == policy_status::usable) bad_since_ = now.time();
    const bool asks = what != policy_status::usable && (is_silent || age(now, bad_since_) >= patience(what));
    if (asks) cause_ = what, cause_term_ = where, has_cause_ = true;
    policy_term_port::vector_type at;
    at[0] = where;
    return {policy_status_port::vector_type(static_cast<double>(what)), at, asks};
  }
  void on_start() {
    begins_ = true;
    has_cause_ = false;
    seen_ = policy_status::usable;
    term_ = -1;
  }

  // Not for a beat: it allocates.
  std::string cause() const {
    if (!has_cause_) return "";
    const std::string_view term = Policy::term_name(cause_term_);
    return std::string(Policy::contract::name) + ": " + (term.empty() ? "it" : std::string(term)) + " is " +
           std::string(name_of(cause_));
  }

private:
  static double age(beat now, std::int64_t since) { return 1e-9 * static_cast<double>(now.time() - since); }
  double patience(policy_status s) const {
    switch (s) {
      case policy_status::unseen:
        return p.unseen;
      case policy_status::stale:
        return p.stale;
      case policy_status::waiting:
        return p.waiting;
      default:
        return p.unreadable;
    }
  }

  std::int64_t bad_since_ = 0, answered_ = 0;
  policy_status seen_ = policy_status::usable, cause_ = policy_status::usable;
  int term_ = -1, cause_term_ = -1;
  bool begins_ = true, has_cause_ = false;
};

}  // namespace cca
