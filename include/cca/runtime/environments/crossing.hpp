// What goes from one environment to another: the outputs that are read there, and how their samples of one
// beat lie in a message.
//
//   word 0            the beat
//   the next words    one bit for each output: it was published
//   then              of each output the time of origin and the coordinates
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include <cca/graph/plan/part.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

constexpr int environment_of(const flat_view& g, int call) { return g.nodes[g.calls[call].node].environment; }

// The least delay with which an environment reads an output; 0: it does not read it.
constexpr int least_delay_to(const flat_view& g, int output, int environment) {
  int least = 0;
  const auto add = [&](int delay) { least = least == 0 || delay < least ? delay : least; };
  for (int i = g.outputs[output].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
    if (environment_of(g, g.inputs[i].call) == environment) add(g.inputs[i].delay);
  for (int l = 0; l < g.link_count; ++l)
    if (g.links[l].output == output && environment_of(g, g.inputs[g.links[l].input].call) == environment)
      add(delay_of(g, g.links[l]));
  return least;
}

template <class D>
struct crossing_outputs {
  std::array<int, array_size(graph_size<D>.outputs) + 1> numbers{}, first_word{};
  int count = 0, words = 0, least_delay = 0;
};

template <class D, int From, int To>
inline constexpr auto crossing_of = [] {
  crossing_outputs<D> found;
  auto plan = plan_of<D>;
  const flat_view g = plan.view();
  if (From == To) return found;
  for (int o = 0; o < g.output_count; ++o) {
    if (environment_of(g, g.outputs[o].call) != From) continue;
    const int delay = least_delay_to(g, o, To);
    if (delay == 0) continue;
    if (found.count == 0 || delay < found.least_delay) found.least_delay = delay;
    found.numbers[array_size(found.count++)] = o;
  }
  found.words = 1 + (found.count + 63) / 64;
  for (int n = 0; n < found.count; ++n) {
    found.first_word[array_size(n)] = found.words;
    found.words += 1 + port_of(g, g.outputs[found.numbers[array_size(n)]]).space->size;
  }
  return found;
}();

template <class D, int From, int To>
struct crossing {
  static constexpr int count = crossing_of<D, From, To>.count;
  static constexpr int words = crossing_of<D, From, To>.words;
  static constexpr int least_delay = crossing_of<D, From, To>.least_delay;
  using message = std::array<std::uint64_t, array_size(words)>;

  // The number of an output among those that cross; -1: it does not.
  static constexpr int number_of(int output) {
    for (int n = 0; n < count; ++n)
      if (crossing_of<D, From, To>.numbers[array_size(n)] == output) return n;
    return -1;
  }

  template <int Number, class Vector>
  CCA_INLINE static void write(message& to, const Vector& v, std::int64_t origin) {
    constexpr auto first = array_size(crossing_of<D, From, To>.first_word[Number]);
    to[1 + Number / 64] |= std::uint64_t{1} << Number % 64;
    to[first] = static_cast<std::uint64_t>(origin);
    for (int c = 0; c < v.size(); ++c) to[first + 1 + array_size(c)] = std::bit_cast<std::uint64_t>(v[c]);
  }

  // Into the samples of the reading environment, which are here when beat `came` begins.
  template <class State>
  static void deliver(State& state, const message& from, std::int64_t came) {
    [&]<int... Number>(std::integer_sequence<int, Number...>) {
      (deliver_one<Number>(state, from, came), ...);
    }(std::make_integer_sequence<int, count>{});
  }

private:
  template <int Number, class State>
  static void deliver_one(State& state, const message& from, std::int64_t came) {
    constexpr int output = crossing_of<D, From, To>.numbers[Number];
    constexpr auto first = array_size(crossing_of<D, From, To>.first_word[Number]);
    constexpr place at = layout_of<part<D, To>>.outputs[output];
    if ((from[1 + Number / 64] >> Number % 64 & 1) == 0) return;
    Eigen::Matrix<double, size_of_output<D, output>, 1> v;
    for (int c = 0; c < v.size(); ++c) v[c] = std::bit_cast<double>(from[first + 1 + array_size(c)]);
    sample_in<part<D, To>, at.array>(state, at.index)
        .put(v, static_cast<std::int64_t>(from[first]), static_cast<std::int64_t>(from[0]), came);
  }
};

}  // namespace cca::detail
