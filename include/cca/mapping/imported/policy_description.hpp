// What a policy observes and commands, as text for the program that trains it: JSON that is also Python.
//
//   cca::describe_policy<walking>()       of a component's type: a cca::imported_policy, a cca::policy, or a
//                                         stand-in with the types `inputs` and `action_space`
//   cca::json_of(description)
//
// An imported policy has scales, default pose, clips, history and gains from its contract. Of the other ones
// the robot's types know names, order, domain types with frames, units, limits and the rate; scales are 1,
// the rest is 0, and there are no gains: the training chooses them. Not for a beat: it allocates. Errors:
// mapping.bad_policy for another type.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <cca/mapping/imported/imported_policy.hpp>
#include <cca/mapping/policy.hpp>
#include <cca/space/space_schema.hpp>

namespace cca {

struct described_number {
  std::string name, unit;
  double rest = 0, scale = 1;
  int sign = 1;
  policy_range limits{};  // of the robot
};
struct described_term {
  std::string name, is;
  std::vector<described_number> numbers;
  policy_range clip{}, target_clip{};
  bool clips_scaled = false;
};
struct policy_description {
  std::string name;
  double rate = 0;                  // Hz
  std::vector<std::string> joints;  // the policy's names, in its order
  std::vector<double> stiffness, damping;
  int history = 1;
  std::string layout = "by_term", order = "oldest_first", start = "repeated";
  std::vector<described_term> terms;
  described_term action;
  bool observes_clipped = false;
  int inputs = 0, outputs = 0;  // of the network
};

namespace detail {

inline std::string json_number(double x) {
  std::array<char, 40> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr};
}
inline std::string quoted_json(std::string_view text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') all += '\\';
    all += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return all + "\"";
}
template <class List, class Write>
std::string json_list(const List& all, const Write& write) {
  std::string text;
  for (const auto& one : all) text += (text.empty() ? "[" : ", ") + write(one);
  return text.empty() ? "[]" : text + "]";
}
inline std::string json_range(const policy_range& r) {
  return std::isfinite(r.lower) && std::isfinite(r.upper)
             ? "[" + json_number(r.lower) + ", " + json_number(r.upper) + "]"
             : "[]";
}
inline std::string json_term(const described_term& t) {
  const auto of = [&](const auto& write) { return json_list(t.numbers, write); };
  using n = const described_number&;
  return "{\"name\": " + quoted_json(t.name) + ", \"is\": " + quoted_json(t.is) +
         ", \"numbers\": " + of([](n one) { return quoted_json(one.name); }) +
         ",\n     \"units\": " + of([](n one) { return quoted_json(one.unit); }) +
         ",\n     \"limits\": " + of([](n one) { return json_range(one.limits); }) +
         ",\n     \"rest\": " + of([](n one) { return json_number(one.rest); }) +
         ", \"scale\": " + of([](n one) { return json_number(one.scale); }) +
         ", \"sign\": " + of([](n one) { return std::to_string(one.sign); }) +
         ",\n     \"clip\": " + json_range(t.clip) +
         ", \"clips\": " + quoted_json(t.clips_scaled ? "after_scale" : "before_scale") +
         ", \"target_clip\": " + json_range(t.target_clip) + "}";
}

template <class Space>
void add_robot_numbers(described_term& t) {
  constexpr auto& schema = cca::schema_of<Space>;
  t.is = std::string(schema.domain());
  for (int i = 0; i < Space::size; ++i) {
    const auto f = schema.field(i);
    t.numbers.push_back({std::string(f.name()), std::string(f.unit), 0, 1, 1, {f.lower, f.upper}});
  }
}
template <class Term, class Space>
described_term contract_term() {
  constexpr auto& schema = cca::schema_of<Space>;
  described_term t{std::string(Term::name), std::string(Term::is),  {},
                   clip_of<Term>(),         target_clip_of<Term>(), clips_scaled<Term>()};
  for (std::size_t i = 0; i < Term::numbers.size(); ++i) {
    const policy_number& one = Term::numbers[i];
    described_number n{std::string(one.name), "", one.rest, one.scale, one.sign, {}};
    if (const int at = place_in<Space>(one.name); at >= 0) {
      const auto f = schema.field(at);
      n.unit = std::string(f.unit), n.limits = {f.lower, f.upper};
    }
    t.numbers.push_back(n);
  }
  return t;
}
template <class Term, class To, class... In>
described_term observed_term() {
  described_term t = contract_term<Term, To>();
  const auto of_port = [&]<class Port>() {
    if constexpr (Port::name == Term::name) t = contract_term<Term, typename Port::space>();
  };
  (of_port.template operator()<In>(), ...);
  return t;
}

template <class Contract, class... In, class To>
policy_description description_of(const imported_policy<Contract, policy_inputs<In...>, To>*) {
  policy_description d;
  d.name = std::string(Contract::name);
  d.rate = Contract::rate;
  for (const auto& g : Contract::gains) {
    d.joints.emplace_back(g.name);
    d.stiffness.push_back(g.stiffness), d.damping.push_back(g.damping);
  }
  d.history = Contract::history;
  d.layout = Contract::layout == history_layout::by_term ? "by_term" : "by_time";
  d.order = Contract::order == history_order::oldest_first ? "oldest_first" : "newest_first";
  d.start = Contract::start == history_start::repeated ? "repeated" : "zero";
  [&]<class... Terms>(policy_terms<Terms...>) {
    (d.terms.push_back(observed_term<Terms, To, In...>()), ...);
  }(typename Contract::terms{});
  d.action = contract_term<typename Contract::action, To>();
  d.observes_clipped = Contract::action::observed_clipped;
  d.inputs = Contract::network::inputs, d.outputs = Contract::network::outputs;
  return d;
}

template <class To, class... In>
policy_description description_of_ports(policy_inputs<In...>) {
  policy_description d;
  d.rate = cca::schema_of<To>.hz();
  const auto add = [&]<class Port>() {
    described_term t{std::string(Port::name), "", {}, {}, {}, false};
    add_robot_numbers<typename Port::space>(t);
    d.inputs += Port::space::size;
    d.terms.push_back(t);
  };
  (add.template operator()<In>(), ...);
  d.action.name = "action";
  add_robot_numbers<To>(d.action);
  d.outputs = To::size;
  for (const auto& n : d.action.numbers) d.joints.push_back(n.name);
  return d;
}
template <class... In, class Hidden, class Activation, class To>
policy_description description_of(const policy<policy_inputs<In...>, Hidden, Activation, To>*) {
  return description_of_ports<To>(policy_inputs<In...>{});
}
template <class StandIn>
  requires requires {
    typename StandIn::inputs;
    typename StandIn::action_space;
  }
policy_description description_of(const StandIn*) {
  return description_of_ports<typename StandIn::action_space>(typename StandIn::inputs{});
}

struct no_policy {
  static constexpr void tell(text& m) {
    m << "mapping.bad_policy: the contract is that of a cca::imported_policy, a cca::policy or a stand-in, "
         "and this type is none";
  }
};

}  // namespace detail

template <class Policy>
policy_description describe_policy(std::string_view name = "") {
  constexpr bool has = requires(const Policy* p) { detail::description_of(p); };
  static_assert(detail::holds_or_tells<has, detail::no_policy>::value);
  policy_description d;
  if constexpr (has) d = detail::description_of(static_cast<const Policy*>(nullptr));
  if (d.name.empty()) d.name = std::string(name);
  return d;
}

inline std::string json_of(const policy_description& d) {
  const auto numbers = [](const std::vector<double>& all) {
    return detail::json_list(all, detail::json_number);
  };
  std::string terms;
  for (const described_term& t : d.terms) terms += (terms.empty() ? "" : ",\n    ") + detail::json_term(t);
  return "{\n  \"name\": " + detail::quoted_json(d.name) + ",\n  \"rate\": " + detail::json_number(d.rate) +
         ",\n  \"joints\": " + detail::json_list(d.joints, detail::quoted_json) +
         ",\n  \"stiffness\": " + numbers(d.stiffness) + ",\n  \"damping\": " + numbers(d.damping) +
         ",\n  \"history\": {\"length\": " + std::to_string(d.history) +
         ", \"layout\": " + detail::quoted_json(d.layout) + ", \"order\": " + detail::quoted_json(d.order) +
         ", \"start\": " + detail::quoted_json(d.start) + "},\n  \"observations\": [\n    " + terms +
         "],\n  \"action\": " + detail::json_term(d.action) +
         ",\n  \"last_action\": " + detail::quoted_json(d.observes_clipped ? "clipped" : "raw") +
         ",\n  \"inputs\": " + std::to_string(d.inputs) + ",\n  \"outputs\": " + std::to_string(d.outputs) +
         "\n}\n";
}

}  // namespace cca
