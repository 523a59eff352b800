// In which order the outputs of a beat are compared, how a sample looks in a message, and who asks for modes
// beside what is computed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <cca/base/messages/first_words.hpp>
#include <cca/base/array_size.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/graph/deployment/part.hpp>
#include <cca/graph/modes/plan_of_modes.hpp>
#include <cca/record/mcap/printable.hpp>
#include <cca/runtime/stoppable_parts.hpp>
#include <cca/space/origin.hpp>

namespace cca::recording::detail {

// number_of(output) for each output of a loop, in the order of its beat.
template <class Loop, class F>
std::vector<int> outputs_in_order(F number_of) {
  using cca::detail::array_size;
  std::vector<int> all;
  const auto& plan = cca::detail::plan_of<Loop>;
  for (int rank = 0; rank < cca::detail::counts_of<Loop>.order_count; ++rank) {
    const auto& call = plan.calls[array_size(plan.order[array_size(rank)])];
    for (int p = 0; p < call.function->output_count; ++p) all.push_back(number_of(call.first_output + p));
  }
  return all;
}

// Of a graph one order, of a set of modes one for each, with the numbers of the whole set.
template <class Graph>
std::vector<std::vector<int>> orders_of_beats() {
  if constexpr (Modes<Graph>) {
    return []<int... I>(std::integer_sequence<int, I...>) {
      return std::vector<std::vector<int>>{outputs_in_order<cca::detail::mode_part<Graph, I>>([](int output) {
        using part = cca::detail::mode_part<Graph, I>;
        return cca::detail::shared_plan_of<Graph>
            .view_of(cca::detail::shown_plan<part>, cca::detail::shown_plan<Graph>)
            .shared_output(output);
      })...};
    }(std::make_integer_sequence<int, cca::detail::mode_count<Graph>>{});
  } else {
    return {outputs_in_order<Graph>([](int output) { return output; })};
  }
}

// Whether a component that a replay does not compute may ask for a mode: a resource node, or one that is
// played.
template <class Graph>
bool are_modes_asked_beside(bool is_playing) {
  for (const auto& call : cca::detail::plan_of<Graph>.calls)
    if (call.function && call.function->requested_count > 0 &&
        (call.phase != cca::detail::phase_of_beat::process ||
         (is_playing && cca::detail::is_free_node<Graph>(call.node))))
      return true;
  return false;
}

// The same of a part that may be stopped.
template <class Loop, class F>
bool is_part_asked_beside(const std::string& part, F is_played) {
  using cca::detail::array_size;
  const auto& plan = cca::detail::plan_of<Loop>;
  for (int r = 0; r < cca::detail::counts_of<Loop>.request_count; ++r)
    if (const auto& one = plan.requests[array_size(r)];
        (plan.calls[array_size(one.call)].phase != cca::detail::phase_of_beat::process ||
         is_played(plan.calls[array_size(one.call)].node)) &&
        cca::detail::path_of_part<Loop>(one.part) == part)
      return true;
  return false;
}

// What a replay has compared of all that it computed.
class comparison {
public:
  void add() { has_some = true; }
  void add_output(int output, bool is_recorded) {
    if (is_recorded) has_some = true;
    else missing.insert(output);
  }

  // Why nothing was compared; empty: something was, or nothing is computed that could be.
  template <class Graph>
  std::string complaint() const {
    if (has_some || missing.empty()) return {};
    const auto name = [o = missing.begin()](std::size_t) mutable {
      return "`" + std::string(cca::detail::path_of_output<Graph>(*o++)) + "`";
    };
    return "the recording lacks all that components compute: " +
           cca::detail::first_words(missing.size(), 4, ", ", name);
  }

private:
  bool has_some = false;
  std::set<int> missing;
};

inline std::string sample_text(std::int64_t origin, const std::int64_t* words_of, std::size_t size) {
  if (origin == never) return "nothing";
  std::ostringstream text;
  text.precision(17);
  text << '[';
  for (std::size_t i = 0; i < size; ++i) {
    double c;
    std::memcpy(&c, words_of + i, sizeof c);
    text << (i ? " " : "") << c;
  }
  text << "] of " << origin << " ns";
  return text.str();
}

inline std::string fault_text(const std::string& why, const std::string& of) {
  return why.empty() ? "no fault" : "the fault `" + printable(why) + "` of `" + of + "`";
}

}  // namespace cca::recording::detail
