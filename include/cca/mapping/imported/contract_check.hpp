// Whether a robot's spaces are those of a policy's contract: the first difference, as a sentence.
//
//   mapping.policy_terms     an observation that has no port, or a port that is no observation
//   mapping.policy_domain    another domain type or frame
//   mapping.policy_numbers   a joint or coordinate that one of them lacks; the order is free
//   mapping.policy_rest      the default pose is outside of the limits of an axis
//   mapping.policy_rate      the output has no rate, or another one than the policy
//   mapping.policy_size      the network has other numbers than its terms and its action
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/component/port.hpp>
#include <cca/mapping/imported/policy_contract.hpp>
#include <cca/mapping/policy.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::detail {

// As space_schema writes names: letters, digits and underscores.
constexpr bool is_same_name(std::string_view a, std::string_view b) {
  constexpr auto tidy = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? c : '_';
  };
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (tidy(a[i]) != tidy(b[i])) return false;
  return true;
}

// Where the number `name` stands in a space; -1: nowhere.
template <class Space>
constexpr int place_in(std::string_view name) {
  constexpr auto& schema = cca::schema_of<Space>;
  for (int i = 0; i < Space::size; ++i)
    if (is_same_name(schema.field(i).name(), name)) return i;
  return -1;
}

template <class Term, class Space>
inline constexpr auto places_of = [] {
  std::array<int, Term::numbers.size()> places{};
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = place_in<Space>(Term::numbers[i].name);
  return places;
}();

// The sentence about one port; it stays empty if the port fits.
template <class Contract, class Term, class Space>
constexpr void compare_port(text& m, const char* verb) {
  constexpr auto& schema = cca::schema_of<Space>;
  if (schema.domain() != Term::is) {
    m << "mapping.policy_domain: the policy `" << Contract::name << "` " << verb << " `" << Term::name
      << "` as " << Term::is << ", and its port is of " << space_in_words<Space>()
      << ": wire a space of that domain type and frame, or change what the map says and import again";
    return;
  }
  for (std::size_t i = 0; i < Term::numbers.size(); ++i)
    if (place_in<Space>(Term::numbers[i].name) < 0) {
      m << "mapping.policy_numbers: the policy `" << Contract::name << "` " << verb << " the number "
        << Term::numbers[i].name << " of `" << Term::name << "`, and " << space_in_words<Space>()
        << " has none of this name: numbers are matched by name, so name the axis in the map "
           "(joint.NAME.axis)";
      return;
    }
  for (int k = 0; k < Space::size; ++k) {
    bool wanted = false;
    for (std::size_t i = 0; i < Term::numbers.size(); ++i)
      wanted = wanted || is_same_name(schema.field(k).name(), Term::numbers[i].name);
    if (!wanted) {
      m << "mapping.policy_numbers: " << space_in_words<Space>() << " has the number "
        << schema.field(k).name() << ", which `" << Term::name << "` of the policy `" << Contract::name
        << "` does not have: wire a space without it";
      return;
    }
  }
  for (std::size_t i = 0; i < Term::numbers.size(); ++i) {
    const auto& one = Term::numbers[i];
    const auto field = schema.field(place_in<Space>(one.name));
    if (one.rest != 0 && !(one.rest >= field.lower && one.rest <= field.upper)) {
      m << "mapping.policy_rest: the default position of " << one.name << " in `" << Term::name
        << "` of the policy `" << Contract::name << "` is " << one.rest << " " << field.unit << ", and "
        << type_name<Space>() << " allows it from " << field.lower << " to " << field.upper
        << ": it may have another sign, zero or unit; say so in the map (joint.NAME.sign)";
      return;
    }
  }
}

// The targets that the robot follows when the policy begins: no observation.
template <class Port>
inline constexpr bool is_applied = false;
template <class Space>
inline constexpr bool is_applied<optional_in<"applied", Space>> = true;

template <class Contract, class Inputs, class To>
struct contract_check;
template <class Contract, class... In, class To>
struct contract_check<Contract, policy_inputs<In...>, To> {
  static constexpr void tell(text& m) {
    each_term(m, typename Contract::terms{});
    (port_is_observed<In>(m, typename Contract::terms{}), ...);
    if (m.size == 0) compare_port<Contract, typename Contract::action, To>(m, "publishes");
    if (m.size == 0) check_rate(m);
    if (m.size == 0) check_size(m);
  }
  static constexpr bool holds = [] {
    text m;
    tell(m);
    return m.size == 0;
  }();

private:
  template <class... Terms>
  static constexpr void each_term(text& m, policy_terms<Terms...>) {
    (one_term<Terms>(m), ...);
  }
  template <class Term>
  static constexpr void one_term(text& m) {
    if constexpr (!observes_action<Term>) {
      if (m.size > 0) return;
      bool is_there = false;
      (compare_named<Term, In>(m, is_there), ...);
      if (!is_there)
        m << "mapping.policy_terms: the policy `" << Contract::name << "` observes `" << Term::name << "` ("
          << Term::is
          << "), and it has no port of this name: add a "
             "cca::in of it to the cca::policy_inputs";
    }
  }
  template <class Term, class Port>
  static constexpr void compare_named(text& m, bool& is_there) {
    if constexpr (Port::name == Term::name) {
      is_there = true;
      if (m.size == 0) compare_port<Contract, Term, typename Port::space>(m, "observes");
    }
  }
  template <class Port, class... Terms>
  static constexpr void port_is_observed(text& m, policy_terms<Terms...>) {
    if (m.size > 0) return;
    if constexpr (is_applied<Port>)
      compare_port<Contract, typename Contract::action, typename Port::space>(m, "begins with");
    else if (!((Port::name == Terms::name && !observes_action<Terms>) || ...))
      m << "mapping.policy_terms: the policy `" << Contract::name << "` has the port `" << Port::name
        << "`, which is none of its observations: remove it, or import the policy that observes it";
  }
  static constexpr void check_rate(text& m) {
    constexpr double hz = cca::schema_of<To>.hz();
    if (!(hz == Contract::rate))
      m << "mapping.policy_rate: the policy `" << Contract::name << "` was trained at " << Contract::rate
        << " Hz, and its output is of " << space_in_words<To>() << ": give that space cca::rate<"
        << Contract::rate << ">, and its node the strategy cca::timed<N> of that rate";
  }
  static constexpr void check_size(text& m) {
    constexpr int seen = numbers_of_terms(typename Contract::terms{}) * Contract::history,
                  moved = size_of_term<typename Contract::action>;
    if (seen != Contract::network::inputs || moved != Contract::network::outputs)
      m << "mapping.policy_size: the network of the policy `" << Contract::name << "` has "
        << Contract::network::inputs << " inputs and " << Contract::network::outputs
        << " outputs, and its contract " << seen << " and " << moved
        << ": the header was changed; import again";
  }
};

}  // namespace cca::detail
