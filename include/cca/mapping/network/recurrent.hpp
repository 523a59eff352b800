// Recurrent cells of fixed size, in double or float. Their state is the caller's: `gru` and `lstm` take the
// old one and return the new one.
//
//   W: of all gates, one below the other, by columns; R: the same for the old output; then the bias of W's
//   and, for a GRU, that of R's gates. Gates in the order of ONNX:
//
//   lstm(weights, x, h, c)   i, o, f, c:  c' = f c + i g,  h' = o tanh(c')
//   gru<Before>(weights, x, h)  z, r, h:  h' = (1 - z) g + z h
//      Before:  g = tanh(Wx + R(r h) + b)        linear_before_reset = 0
//      else:    g = tanh(Wx + b + r (R h + b'))  linear_before_reset = 1, as PyTorch has it
//
// If an input is NaN or infinite the output is NaN or any number; there is no status and no fault.
// Source: Hochreiter, Schmidhuber, Long short-term memory, 1997; Gers, Schmidhuber, Cummins, Learning to
// forget, 2000; Cho et al., Learning phrase representations using RNN encoder-decoder, 2014.
#pragma once

#include <cca/mapping/network/operators.hpp>

namespace cca::neural {

template <class Number, int Units>
struct lstm_state {
  numbers<Number, Units> h, c;
};

template <class Number, int From, int Units>
[[gnu::always_inline]] inline lstm_state<Number, Units> lstm(const Number* weights,
                                                             const numbers<Number, From>& x,
                                                             const numbers<Number, Units>& h,
                                                             const numbers<Number, Units>& c) {
  constexpr int all = 4 * Units;
  const Number* const recurrent = weights + all * From;
  const numbers<Number, all> begun =
      cca::detail::weighted_sums<Number, From, all>::from(weights, recurrent + all * Units, x);
  const numbers<Number, all> gates =
      cca::detail::weighted_sums<Number, Units, all>::from(recurrent, begun.data(), h);
  const numbers<Number, 3 * Units> open = sigmoid(part<0, 3 * Units>(gates));  // i, o, f
  const numbers<Number, Units> fresh = tangent(part<3 * Units, Units>(gates));
  const numbers<Number, Units> cell =
      open.template tail<Units>().cwiseProduct(c) + open.template head<Units>().cwiseProduct(fresh);
  return {open.template segment<Units>(Units).cwiseProduct(tangent(cell)), cell};
}

template <bool Before, class Number, int From, int Units>
[[gnu::always_inline]] inline numbers<Number, Units> gru(const Number* weights,
                                                         const numbers<Number, From>& x,
                                                         const numbers<Number, Units>& h) {
  constexpr int all = 3 * Units, two = 2 * Units;
  const Number* const recurrent = weights + all * From;
  const Number* const bias = recurrent + all * Units;
  const numbers<Number, all> outer = cca::detail::weighted_sums<Number, From, all>::from(weights, bias, x);
  if constexpr (Before) {  // R of z and r stands alone, that of h after it
    const numbers<Number, two> old =
        cca::detail::weighted_sums<Number, Units, two>::from(recurrent, bias + all, h);
    const numbers<Number, two> open = sigmoid(numbers<Number, two>(outer.template head<two>() + old));
    const numbers<Number, Units> kept = open.template tail<Units>().cwiseProduct(h);
    const numbers<Number, Units> inner = cca::detail::weighted_sums<Number, Units, Units>::from(
        recurrent + two * Units, bias + all + two, kept);
    const numbers<Number, Units> fresh =
        tangent(numbers<Number, Units>(outer.template tail<Units>() + inner));
    return fresh + open.template head<Units>().cwiseProduct(h - fresh);
  } else {
    const numbers<Number, all> old =
        cca::detail::weighted_sums<Number, Units, all>::from(recurrent, bias + all, h);
    const numbers<Number, two> open =
        sigmoid(numbers<Number, two>(outer.template head<two>() + old.template head<two>()));
    const numbers<Number, Units> fresh = tangent(numbers<Number, Units>(
        outer.template tail<Units>() + open.template tail<Units>().cwiseProduct(old.template tail<Units>())));
    return fresh + open.template head<Units>().cwiseProduct(h - fresh);
  }
}

}  // namespace cca::neural
