// A tape as code: one function with the operations of the tape and nothing else.
//
//   straight_line<product_of_two>::evaluate({out}, first, second)   // pointers to results and to inputs
//
// A function of its own, not inlined: it is large, and a program that needs it twice has it once.
// An input that is NaN or infinite makes each output that needs it NaN, if it is not already: tape.hpp.
#pragma once

#include <array>
#include <limits>
#include <utility>

#include <cca/base/inlining.hpp>
#include <cca/base/recording/tape.hpp>

namespace cca::detail {

// Operation I of a tape, on its numbers: doubles, or lanes of them.
template <class Algorithm, int I, class Number>
[[gnu::always_inline]] inline void operate(Number* v) {
  constexpr const auto& t = tape_of<Algorithm>;
  constexpr recorded_operation o(t.operation[I]);
  constexpr int a = o.first(), b = o.second(), to = t.inputs + t.constants + I;
  if constexpr (o.what() == operation::add) v[to] = v[a] + v[b];
  else if constexpr (o.what() == operation::subtract) v[to] = v[a] - v[b];
  else if constexpr (o.what() == operation::multiply) v[to] = v[a] * v[b];
  else v[to] = v[a] / v[b];
}
// The number of an output.
template <int Row, class Number>
[[gnu::always_inline]] inline Number number_on_tape(const Number* v) {
  if constexpr (Row < 0) return -v[~Row];
  else return v[Row];
}

template <class Algorithm>
class straight_line {
  static constexpr std::size_t result_count = Algorithm::results.size();

public:
  struct results {
    double* at[result_count];
  };

private:
  static constexpr const auto& t = tape_of<Algorithm>;
  static constexpr int rows = t.inputs + t.constants + t.operations;

  // In lists, not folds, and why the whole is not inlined: docs/compilers.md.
  template <int... I>
  [[gnu::always_inline]] static void constants(double* v, std::integer_sequence<int, I...>) {
    const bool done[]{(v[t.inputs + I] = t.constant[I], true)..., true};
    (void)done;
  }
  template <int... I>
  [[gnu::always_inline]] static void operations(double* v, std::integer_sequence<int, I...>) {
    const bool done[]{(operate<Algorithm, I>(v), true)..., true};
    (void)done;
  }
  template <int First, int... I>
  [[gnu::always_inline]] static void store(const double* v, double* out, std::integer_sequence<int, I...>) {
    const bool done[]{(out[I] = number_on_tape<t.output[First + I]>(v), true)..., true};
    (void)done;
  }
  static constexpr int results_before(std::size_t array) {
    int sum = 0;
    for (std::size_t i = 0; i < array; ++i) sum += Algorithm::results[i];
    return sum;
  }
  template <std::size_t... S>
  [[gnu::always_inline]] static void store_all(const double* v,
                                               const results& out,
                                               std::index_sequence<S...>) {
    (store<results_before(S)>(v, out.at[S], std::make_integer_sequence<int, Algorithm::results[S]>{}), ...);
  }
  template <int... I>
  [[gnu::always_inline]] static double sum_of_checked(const double* v, std::integer_sequence<int, I...>) {
    return (v[t.checked[I]] + ... + 0.0);
  }
  template <int... I>
  [[gnu::always_inline]] static void load(double* v, const double* in, std::integer_sequence<int, I...>) {
    const bool done[]{(v[I] = in[I], true)..., true};
    (void)done;
  }
  template <int... S, class... In>
  [[gnu::always_inline]] static void load_all(double* v, std::integer_sequence<int, S...>, const In*... in) {
    int at = 0;
    ((load(v + at, in, std::make_integer_sequence<int, Algorithm::sizes[S]>{}), at += Algorithm::sizes[S]),
     ...);
  }

  static constexpr auto owners = [] {
    std::array<std::uint64_t, static_cast<std::size_t>(t.outputs)> of{};
    for (std::size_t i = 0; i < of.size(); ++i) of[i] = t.owners[i];
    return of;
  }();
  template <class... In>
  [[gnu::noinline, gnu::cold]] static void lose_no_nan(results out, const In*... in) {
    const double* const arrays[]{in...};
    for (int array = 0, input = 0; array < static_cast<int>(sizeof...(In)); ++array)
      for (int i = 0; i < Algorithm::sizes[static_cast<std::size_t>(array)]; ++i, ++input) {
        if (arrays[array][i] - arrays[array][i] == 0) continue;
        const int owner = Algorithm::owner(Algorithm::group(input));
        for (std::size_t result = 0, o = 0; result < result_count; ++result)
          for (int k = 0; k < Algorithm::results[result]; ++k, ++o)
            if (owner < 0 || (owners[o] >> owner & 1) != 0)
              out.at[result][k] = std::numeric_limits<double>::quiet_NaN();
      }
  }

public:
  template <class... In>
  [[gnu::noinline]] static void evaluate(results out, const In*... in) {
    static_assert(sizeof...(In) == Algorithm::sizes.size());
    double v[std::size_t{rows + 1}];
    load_all(v, std::make_integer_sequence<int, static_cast<int>(sizeof...(In))>{}, in...);
    constants(v, std::make_integer_sequence<int, t.constants>{});
    operations(v, std::make_integer_sequence<int, t.operations>{});
    store_all(v, out, std::make_index_sequence<result_count>{});
    if constexpr (t.checks > 0) {
      const double sum = sum_of_checked(v, std::make_integer_sequence<int, t.checks>{});
      if (!(sum - sum == 0)) [[unlikely]]
        lose_no_nan(out, in...);
    }
  }
};

// The only result, a vector or a matrix. A function of its own: there no compiler copies it on the way out.
template <class Algorithm, class Result, class... In>
inline Result recorded_result(const In*... in) {
  Result r;
  straight_line<Algorithm>::evaluate({r.data()}, in...);
  return r;
}

}  // namespace cca::detail
