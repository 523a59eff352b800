// A learned policy as a component: a feed-forward network whose observations are ports, so joint order,
// frames, units and rates of its observations are checked like every wire.
//
//   struct walk : cca::policy<cca::policy_inputs<cca::in<"angles", leg_angles>,
//                                                cca::in<"turning", trunk_twist>>,
//                             cca::hidden_layers<256, 128>, cca::hyperbolic_tangent, leg_angles> {};
//   cca::node<"walk", walk, cca::timed<20>>
//
//   in  <own names>   their spaces         any; the network sees their numbers one after the other
//   out "output"      To                   maybe; one number per axis, within the limits of the axes
//   out "status"      input_status_port
//
// The parameter `file` names the weights; they are read on load. The file says for which ports it was made:
// name, domain type with its frame, rate, and the name, unit and limits of each number. A file for others is
// refused, with the port and the first difference. A program that trains sets `weights` itself; `save(file)`
// writes them with this description. Without weights it is refused on load.
//
// Inputs (input_status.hpp): until each input has a sample, and while one is NaN or infinite, nothing is
// published but the status, then `unreadable`; beyond 1e12 it is cut, with `clamped`. It has no state.
//
// Errors: `cca::refused` for files. Cost: that of the network (network/feed_forward.hpp): at most 1.1 times
// the instructions of its bare matrix products (docs/mappings.md). Memory: its weights.
// Example: tests/runtime/mapping/policy.cpp; docs/mappings.md.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <cca/adaptive/learned_file.hpp>
#include <cca/base/file.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/mapping/network/feed_forward.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/space_schema.hpp>

namespace cca {

template <class... Inputs>
struct policy_inputs {};
template <int... Units>
struct hidden_layers {};

namespace detail {
template <class To>
struct no_observations {
  static constexpr void tell(text& m) {
    m << "mapping.bad_policy: the policy that publishes " << space_in_words<To>()
      << " has no inputs, so its network sees nothing; name its observations in "
         "cca::policy_inputs<cca::in<...>, ...>";
  }
};
template <class To>
struct output_without_limits {
  static constexpr void tell(text& m) {
    m << "mapping.bad_policy: the output of this policy, " << space_in_words<To>()
      << ", has more than one number per axis, as a pose has; let it publish a space with one number per "
         "axis, which has limits";
  }
};
}  // namespace detail

template <class Inputs, class Hidden, class Activation, Space To>
struct policy;

template <class... In, int... Units, class Activation, Space To>
struct policy<policy_inputs<In...>, hidden_layers<Units...>, Activation, To> {
  static_assert(detail::holds_or_tells<(sizeof...(In) > 0), detail::no_observations<To>>::value);
  static_assert(
      detail::holds_or_tells<(To::size == To::axes::count), detail::output_without_limits<To>>::value);
  // Without inputs only the message above, not the errors that follow from it.
  static constexpr int observed = sizeof...(In) > 0 ? (In::space::size + ... + 0) : 1;
  using network = feed_forward<Activation, observed, Units..., To::size>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (text<200>, file));
  };
  parameters p{};
  typename network::parameters weights;

  auto process(In... inputs) -> std::tuple<maybe<"output", To>, out<"status", input_status_port>> {
    detail::input_check check;
    typename network::input x;
    int at = 0;
    (void)((x.template segment<In::space::size>(at) = check(inputs.vector()), at += In::space::size), ...);
    maybe<"output", To> output;
    if (((inputs.origin() != never) && ...) && !check.unreadable())
      output = within_limits(network::answer(weights, x));
    return {output, status_of(check.get())};
  }

  void on_load() {
    const std::string file(p.file.view());
    if (!file.empty()) return read(file);
    if (std::ranges::all_of(weights.weights, [](double w) { return w == 0; }))
      throw refused(
          "cca::policy: it has no weights; name their file in the parameter `file`, or set `weights` before "
          "the load");
  }

  // If a file is refused, nothing changes.
  void read(const std::string& file) {
    const auto copy = std::make_unique<typename network::parameters>();
    detail::read_learned(detail::read_file(file), file, header(),
                         detail::schema_of<typename network::parameters>, copy.get());
    weights = *copy;
  }
  void save(const std::string& file) const {
    std::vector<detail::complaint> wrong;
    detail::check(detail::schema_of<typename network::parameters>, &weights, "", wrong);
    if (!wrong.empty())
      throw refused(file + ": not written: " + wrong.front().path + ": " + wrong.front().what);
    detail::write_file(
        file, detail::learned_text(header(), detail::schema_of<typename network::parameters>, &weights));
  }

private:
  static learned_header header() {
    return {network::title(),
            "policy",
            {},
            {described<typename In::space>("input", In::name)..., described<To>("output", {})}};
  }

  template <class S>
  static learned_header::port described(std::string_view kind, std::string_view name) {
    constexpr auto& schema = cca::schema_of<S>;
    learned_header::port one{std::string(kind).append(name.empty() ? "" : " ").append(name), {}};
    one.lines.push_back(
        std::string(schema.domain())
            .append(schema.hz() > 0 ? " at " + detail::number_text(schema.hz()) + " Hz" : ""));
    for (int i = 0; i < schema.field_count(); ++i) {
      const auto field = schema.field(i);
      one.lines.push_back("number " + std::to_string(i) + ", " + std::string(field.name()) + ", " +
                          std::string(field.unit) + " from " + detail::number_text(field.lower) + " to " +
                          detail::number_text(field.upper));
    }
    one.lines.push_back("schema " + detail::hash_text(schema.hash()));
    return one;
  }

  static typename To::vector_type within_limits(const typename network::output& y) {
    constexpr auto& space = detail::space_of<To>;
    typename To::vector_type result;
    for (int i = 0; i < To::size; ++i)
      result[i] = std::min(std::max(y[i], std::max(space.lower[i], -largest_input)),
                           std::min(space.upper[i], largest_input));
    return result;
  }
};

}  // namespace cca
