// A tape: the operations of a recording that its results need, in the order in which they are computed.
//
//   struct product_of_two {                          // what is recorded
//     static constexpr std::array sizes{1, 1};       // its inputs come from arrays of these sizes
//     static constexpr std::array results{1};        // and its outputs go to arrays of these sizes
//     static constexpr int group(int input);         // inputs that are NaN together, at most 128 groups
//     static constexpr int owner(int group);         // 0 to 63; -1: every output needs it
//     static constexpr bool may_vanish(int group);   // an infinite one could leave no trace (1 / x)
//     static constexpr void record(recorder& r) { r.output(r.input(0) * r.input(1), 0b1); }
//     static constexpr bool is_small = true;         // for is_recorded: false if a try would be in vain
//   };
//   tape_of<product_of_two>                          // a constant; straight_line.hpp makes code of it
//
// Only what an output needs is kept. The numbers of a computation stand in one row: inputs, then constants,
// then one for each operation.
//
// Folding loses NaN: 0 * x is 0. So each output states the owners of the inputs of which it must not lose
// one; `checked` are the inputs that some output needs and does not contain.
// Cost: the algorithm is evaluated once; about 100 steps of the compiler's evaluation for each operation.
#pragma once

#include <array>

#include <cca/base/recording/recorder.hpp>

namespace cca::detail {

// A tape of more operations is full, as is one whose recorder was: then loops take over. So many make 25 to
// 33 KB of code, what a usual processor's nearest cache holds. Up to here a recording is faster than loops
// where its code comes from the second cache, as in a beat, and takes 0.8 to 1.2 of their time where it comes
// from the third; a recording of 38 KB takes 1.3 to 1.7 of it there (docs/performance.md, "Dynamics with cold
// caches"). An algorithm may state its own `most_kept`, to measure what lies beyond.
inline constexpr int most_kept_operations = 2300, most_groups = 128;
template <class Algorithm>
inline constexpr int most_kept_of = [] {
  if constexpr (requires { Algorithm::most_kept; }) return Algorithm::most_kept;
  else return most_kept_operations;
}();

template <int MostKept>
struct tape {
  int inputs = 0, constants = 0, operations = 0, outputs = 0, checks = 0;
  bool is_full = false;
  std::array<double, most_constants> constant{};
  std::array<std::uint32_t, std::size_t{MostKept}> operation{};  // words of recorded_operation
  std::array<int, recorder::most_outputs> output{};  // negative: ~number of the row, to be negated
  std::array<std::uint64_t, recorder::most_outputs> owners{};
  std::array<int, most_groups> checked{};
};

template <class Algorithm>
class tape_maker {
  static constexpr int most_kept = most_kept_of<Algorithm>;
  recorder r;
  tape<most_kept> t;
  struct set {
    std::uint64_t low, high;
    static constexpr set of(int group) {
      return group < 64 ? set{std::uint64_t{1} << group, 0} : set{0, std::uint64_t{1} << (group - 64)};
    }
    constexpr bool has(int group) const {
      return ((group < 64 ? low >> group : high >> (group - 64)) & 1) != 0;
    }
  };
  bool is_needed[most_operations]{};
  std::uint16_t renumbered[most_operations];
  set contains[most_operations];

  constexpr int row(int operand) const {
    return operand >= first_input      ? operand - first_input
           : operand >= first_constant ? t.inputs + operand - first_constant
                                       : t.inputs + t.constants + renumbered[operand];
  }
  constexpr int output(int i) const { return r.outputs[i] < 0 ? ~r.outputs[i] : r.outputs[i]; }
  constexpr set groups_of(int operand) const {
    if (operand < first_constant) return contains[operand];
    if (operand < first_input) return {0, 0};
    const int group = Algorithm::group(operand - first_input);
    return Algorithm::may_vanish(group) ? set{0, 0} : set::of(group);
  }

  constexpr void keep_what_is_needed() {
    for (int i = 0; i < r.output_count; ++i)
      if (const int o = output(i); o < first_constant) is_needed[o] = true;
    for (int i = r.operation_count; i-- > 0;) {
      if (!is_needed[i]) continue;
      const recorded_operation o(r.operations[i]);
      if (o.first() < first_constant) is_needed[o.first()] = true;
      if (o.second() < first_constant) is_needed[o.second()] = true;
    }
    t.constants = r.constant_count;
    for (int i = 0; i < t.constants; ++i) t.constant[i] = r.constants[i];
    for (int i = 0; i < r.operation_count; ++i) {
      if (!is_needed[i]) continue;
      if (t.operations == most_kept) {
        t.is_full = true;
        return;
      }
      const recorded_operation o(r.operations[i]);
      const set a = groups_of(o.first()), b = groups_of(o.second());
      contains[i] = {a.low | b.low, a.high | b.high};
      renumbered[i] = static_cast<std::uint16_t>(t.operations);
      t.operation[t.operations++] = recorded_operation(o.what(), row(o.first()), row(o.second())).word;
    }
    t.outputs = r.output_count;
    for (int i = 0; i < r.output_count; ++i) {
      t.output[i] = r.outputs[i] < 0 ? ~row(output(i)) : row(output(i));
      t.owners[i] = r.owners[i];
    }
  }

  constexpr void find_what_to_check() {
    for (int i = 0, seen = 0; i < t.inputs; ++i) {
      const int group = Algorithm::group(i);
      if (group < seen) continue;
      seen = group + 1;
      const int owner = Algorithm::owner(group);
      for (int o = 0; o < r.output_count; ++o) {
        if (owner >= 0 && (r.owners[o] >> owner & 1) == 0) continue;
        if (groups_of(output(o)).has(group)) continue;
        t.checked[t.checks++] = i;
        break;
      }
    }
  }

public:
  constexpr tape_maker() {}
  constexpr tape<most_kept> made() {
    for (const int size : Algorithm::sizes) t.inputs += size;
    Algorithm::record(r);
    t.is_full = r.is_full;
    if (t.is_full) return t;
    keep_what_is_needed();
    if (!t.is_full) find_what_to_check();
    return t;
  }
};

template <class Algorithm>
inline constexpr auto tape_of = tape_maker<Algorithm>().made();

// Whether an algorithm is small enough; `is_small` spares the compiler a try.
template <class Algorithm>
constexpr bool is_recorded() {
  if constexpr (Algorithm::is_small) {
    return !tape_of<Algorithm>.is_full;
  } else {
    return false;
  }
}

}  // namespace cca::detail
