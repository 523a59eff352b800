// A chain of mappings is one mapping: each takes the output of the one before, in the same firing.
//
//   struct foot_to_world : cca::mapping_chain<leg_forward, hip_to_trunk, trunk_to_world> {};
//
//   in  <input of the first>      with its name and space
//   out <output of the last>      with its name and space
//   out <statuses>                each status of each mapping, in order
//
// NaN and infinity do in it what they do in its mappings.
// Optional inputs of the mappings are not wired. `get<0>()` is the first mapping.
// Errors: mapping.chain, if a mapping takes another space (domain type, frame, axes, rate) than the one
// before gives. Cost: that of its mappings. Example: tests/runtime/mapping/example.cpp.
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/mapping/mapping.hpp>

namespace cca {
namespace detail {

template <class Given, class Taken>
struct broken_link {
  static constexpr void tell(text& m) {
    m << "mapping.chain: a mapping of this chain gives " << space_in_words<Given>()
      << ", and the next one takes " << space_in_words<Taken>() << ": " << difference_in_words<Given, Taken>()
      << "; put a mapping between them, or `cca::frame_change` if only the frames differ";
  }
};
template <class Given, class Taken>
constexpr auto check_link() {
  constexpr bool meet = matching<Given, Taken>;
  static_assert(holds_or_tells<meet, broken_link<Given, Taken>>::value);
  return std::bool_constant<meet>{};
}

// Reports only the first pair that does not match.
template <class Before, class... Rest>
constexpr auto check_chain() {
  if constexpr (sizeof...(Rest) > 0) {
    using next = std::tuple_element_t<0, std::tuple<Rest...>>;
    if constexpr (decltype(check_link<output_space<Before>, input_space<next>>())::value)
      return check_chain<Rest...>();
    else return std::false_type{};
  } else {
    return std::true_type{};
  }
}

template <class Result>
struct statuses_in;
template <class... Results>
struct statuses_in<list<Results...>> {
  using type = decltype(std::tuple_cat(
      std::declval<std::conditional_t<is_mapped<Results>, std::tuple<>, std::tuple<Results>>>()...));
};
template <class Component>
using statuses_of = typename statuses_in<typename process_facts<Component>::results>::type;

template <class Result>
constexpr auto as_tuple(Result&& result) {
  if constexpr (requires { std::tuple_size<std::remove_cvref_t<Result>>::value; })
    return std::forward<Result>(result);
  else return std::tuple<std::remove_cvref_t<Result>>(std::forward<Result>(result));
}

// Takes the output, and the statuses, from the result of `process`.
template <class Result>
constexpr auto output_in(const Result& all) {
  return std::apply(
      [](const auto&... one) {
        return std::get<0>(std::tuple_cat([&] {
          using port = std::remove_cvref_t<decltype(one)>;
          if constexpr (is_mapped<port>) return std::tuple<port>(one);
          else return std::tuple<>();
        }()...));
      },
      all);
}
template <class Result>
constexpr auto statuses_among(const Result& all) {
  return std::apply(
      [](const auto&... one) {
        return std::tuple_cat([&] {
          using port = std::remove_cvref_t<decltype(one)>;
          if constexpr (is_mapped<port>) return std::tuple<>();
          else return std::tuple<port>(one);
        }()...);
      },
      all);
}

// Calls `process` of a mapping and returns its result as a tuple. All other inputs count as not wired.
template <class Component, class... Parameters, class Input>
constexpr auto call_mapping(
    Component& component, list<Parameters...>, const Input& input, const beat& now, bool fresh) {
  return as_tuple(component.process([&]() -> Parameters {
    if constexpr (is_mapped<Parameters>) return Parameters(input.vector(), input.origin(), fresh);
    else if constexpr (std::is_same_v<Parameters, beat>) return now;
    else return Parameters{};
  }()...));
}
template <class Component, class Input>
constexpr auto call_mapping(Component& component, const Input& input, const beat& now, bool fresh = true) {
  return call_mapping(component, typename process_facts<Component>::parameters(), input, now, fresh);
}

template <class Tuple>
struct names_in;
template <class... Ports>
struct names_in<std::tuple<Ports...>> {
  static constexpr std::array<std::string_view, sizeof...(Ports)> names{Ports::name...};
  // The first that has the name of one before; -1: there is none.
  static constexpr int repeated = [] {
    for (std::size_t i = 0; i < names.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (names[i] == names[j]) return static_cast<int>(i);
    return -1;
  }();
};

template <class Result>
struct output_named_twice {
  static constexpr void tell(text& m) {
    using all = names_in<Result>;
    m << "mapping.chain: two outputs of this chain are named `"
      << all::names[static_cast<std::size_t>(all::repeated)]
      << "`, so a wire could not tell them apart: at most one of its mappings may have a status of that name";
  }
};

}  // namespace detail

template <Mapping First, Mapping... Rest>
class mapping_chain {
  using all = std::tuple<First, Rest...>;
  using last = std::tuple_element_t<sizeof...(Rest), all>;
  using result =
      decltype(std::tuple_cat(std::declval<std::tuple<typename detail::mapped_outputs<last>::first>>(),
                              std::declval<detail::statuses_of<First>>(),
                              std::declval<detail::statuses_of<Rest>>()...));
  using meet = decltype(detail::check_chain<First, Rest...>());
  static_assert(detail::holds_or_tells<(detail::names_in<result>::repeated < 0),
                                       detail::output_named_twice<result>>::value);

public:
  auto process(typename detail::mapped_inputs<First>::first input, beat now) -> result {
    if constexpr (meet::value) return run<0>(input, input, now, std::tuple<>());
    else return {};
  }

  template <std::size_t Index>
  auto& get() {
    return std::get<Index>(mappings);
  }

private:
  template <std::size_t Index, class First_, class Input, class Statuses>
  result run(const First_& first, const Input& input, const beat& now, const Statuses& before) {
    auto& mapping = std::get<Index>(mappings);
    const auto made = detail::call_mapping(mapping, input, now, first.fresh());
    const auto output = detail::output_in(made);
    const auto statuses = std::tuple_cat(before, detail::statuses_among(made));
    if constexpr (Index == sizeof...(Rest)) return std::tuple_cat(std::tuple(output), statuses);
    else
      return run<Index + 1>(first, sample<typename decltype(output)::space>(output.vector(), first.origin()),
                            now, statuses);
  }

  all mappings;
};

}  // namespace cca
