// Processing strategies: when a component fires. Beats are counted from 0.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>

#include <cca/component/beat.hpp>
#include <cca/base/fixed_string.hpp>

namespace cca {

// In beat k if (k - Phase) mod N = 0; N > 0.
template <std::int64_t N, std::int64_t Phase = 0>
struct timed {};

struct restless {};  // if any input is fresh
struct moderate {};  // if every input is fresh
struct coordinated {
};  // if every input holds a sample of one time of origin, later than what it saw when it last fired
struct full_speed {};  // always
struct inactive {};    // never

// If N beats have passed since it last fired (since beat 0, if never), N > 0; for use in any_of<moderate,
// timeout<15>>.
template <std::int64_t N>
struct timeout {};

// If any of the named inputs is fresh.
template <fixed_string... Inputs>
struct port_triggered {};

template <class... Strategies>
struct any_of {};

template <class... Strategies>
struct all_of {};

namespace detail {

struct by_default {};  // restless with inputs, timed<1> without

enum class strategy_kind : std::uint8_t {
  by_default,
  timed,
  restless,
  moderate,
  timeout,
  port_triggered,
  coordinated,
  full_speed,
  inactive,
  any_of,
  all_of,
  user
};

// A strategy as a value, for the constexpr functions that compute clocks and check rules.
struct strategy_info {
  strategy_kind kind = strategy_kind::user;
  std::int64_t n = 0, phase = 0;
  const std::string_view* names = nullptr;
  const strategy_info* const* parts = nullptr;
  int count = 0;  // of names or parts
};

constexpr bool is_combined(const strategy_info& strategy) {
  return strategy.kind == strategy_kind::any_of || strategy.kind == strategy_kind::all_of;
}

template <fixed_string... Names>
inline constexpr std::array<std::string_view, sizeof...(Names) + 1> names_of{Names.view()..., {}};

template <class Strategy>
inline constexpr strategy_info strategy_of{};

template <class... Parts>
inline constexpr std::array<const strategy_info*, sizeof...(Parts) + 1> parts_of{&strategy_of<Parts>...,
                                                                                 nullptr};

template <>
inline constexpr strategy_info strategy_of<by_default>{strategy_kind::by_default};
template <>
inline constexpr strategy_info strategy_of<restless>{strategy_kind::restless};
template <>
inline constexpr strategy_info strategy_of<moderate>{strategy_kind::moderate};
template <>
inline constexpr strategy_info strategy_of<coordinated>{strategy_kind::coordinated};
template <>
inline constexpr strategy_info strategy_of<full_speed>{strategy_kind::full_speed};
template <>
inline constexpr strategy_info strategy_of<inactive>{strategy_kind::inactive};

template <std::int64_t N, std::int64_t Phase>
inline constexpr strategy_info strategy_of<timed<N, Phase>>{strategy_kind::timed, N, Phase};
template <std::int64_t N>
inline constexpr strategy_info strategy_of<timeout<N>>{strategy_kind::timeout, N};
template <fixed_string... Inputs>
inline constexpr strategy_info strategy_of<port_triggered<Inputs...>>{
    strategy_kind::port_triggered, 0, 0, names_of<Inputs...>.data(), nullptr, sizeof...(Inputs)};
template <class... Parts>
inline constexpr strategy_info strategy_of<any_of<Parts...>>{
    strategy_kind::any_of, 0, 0, nullptr, parts_of<Parts...>.data(), sizeof...(Parts)};
template <class... Parts>
inline constexpr strategy_info strategy_of<all_of<Parts...>>{
    strategy_kind::all_of, 0, 0, nullptr, parts_of<Parts...>.data(), sizeof...(Parts)};

// Stands for the inputs of any component, to check a user's strategy.
struct any_inputs {
  struct port {
    bool fresh() const;
    std::int64_t origin() const;
  };
  template <fixed_string Name>
  port get() const;
};

}  // namespace detail

// A strategy of the user's own: `bool fires(cca::beat now, const Inputs& in)`, a template on Inputs. It sees
// each input as it would be read: `in.template get<"x">()` has value, `origin()` and `fresh()`.
template <class Strategy> concept ProcessingStrategy =
    detail::strategy_of<Strategy>.kind != detail::strategy_kind::user ||
    requires(beat now, const detail::any_inputs& in) {
      { Strategy{}.fires(now, in) } -> std::convertible_to<bool>;
    };

}  // namespace cca
