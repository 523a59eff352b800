// The results of a function, as a replay fills them in.
#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/component/component.hpp>
#include <cca/component/fault.hpp>

namespace cca::recording::detail {

template <class Result, class Parameters>
struct signature_list;
template <class Result, class... Parameters>
struct signature_list<Result, cca::detail::list<Parameters...>> {
  using type = cca::detail::list<Result, Parameters...>;
};
template <class Function>
using signature_of =
    typename signature_list<typename cca::detail::function_facts<Function>::result,
                            typename cca::detail::function_facts<Function>::parameters>::type;

// f(result) for each.
template <class Results, class F>
void each_result(Results& results, F f) {
  if constexpr (requires { std::tuple_size<Results>::value; })
    std::apply([&](auto&... all) { (f(all), ...); }, results);
  else f(results);
}
// Output number `port`.
template <class Results>
void put_result(Results& results, int port, std::int64_t origin, const double* coordinates) {
  int n = 0;
  each_result(results, [&]<class One>(One& one) {
    if constexpr (cca::detail::result_facts<One>::kind == cca::detail::result_kind::output)
      if (n++ == port) {
        for (int c = 0; c < One::space::size; ++c) one.vector()[c] = coordinates[c];
        one.with_origin(origin);
      }
  });
}
template <class Results>
void fail_result(Results& results, const char* reason) {
  each_result(results, [&]<class One>(One& one) {
    if constexpr (std::is_same_v<One, fault>) one = fault(reason);
  });
}

// What is published in each firing is published now and then where the firings are not known.
template <class Result>
struct irregular {
  using type = Result;
};
template <fixed_string Name, class Space>
struct irregular<out<Name, Space>> {
  using type = maybe<Name, Space>;
};
template <class... Result>
struct irregular<std::tuple<Result...>> {
  using type = std::tuple<typename irregular<Result>::type...>;
};
template <class Result>
using irregular_result = typename irregular<Result>::type;

template <class Result>
irregular_result<Result> make_irregular(const Result& one) {
  return one;
}
template <class... Result>
irregular_result<std::tuple<Result...>> make_irregular(const std::tuple<Result...>& all) {
  return std::apply(
      [](const auto&... one) { return irregular_result<std::tuple<Result...>>(make_irregular(one)...); },
      all);
}

}  // namespace cca::recording::detail
