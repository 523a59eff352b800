// What the queues of a controller or a deployment have lost because they were full, between two beats.
//
//   c.dropped<"log.x">()   by the queue at this input, of `queue` or `merged`, since it was made; 0: no queue
//   c.dropped("log.x")     the same by a path that is known only at run time
//   c.dropped()            by all queues
//
// An input says the same of itself: `x.dropped()`. A program prints it in its summary (main/end_of_run.hpp).
// Errors: wire.unknown_port; cca::refused, if there is no input of a path that is known only at run time, or
// another process runs its component.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/nearest.hpp>
#include <cca/base/refused.hpp>
#include <cca/graph/plan/paths.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

// The queues of the components that a loop runs.
template <class Graph>
struct has_own_queue {
  static constexpr bool holds(std::size_t i) {
    const input& in = plan_of<Graph>.inputs[i];
    return is_queued(in) && in.way_of < 0 && !plan_of<Graph>.calls[array_size(in.call)].elsewhere;
  }
};
template <class Graph>
std::string path_of_input(int number) {
  const input& in = plan_of<Graph>.inputs[array_size(number)];
  if (in.outside) return path_of_output<Graph>(in.writer);  // an `observe` of the graph
  const call& reader = plan_of<Graph>.calls[array_size(in.call)];
  return path_of_node<Graph>(reader.node) + "." + std::string(reader.function->inputs[in.port].name);
}

template <class Graph>
constexpr bool is_input(std::string_view path) {
  const auto dot = path.rfind('.');
  if (dot == path.npos) return false;
  const int node = node_at<Graph>(path.substr(0, dot));
  for (int c = 0; node >= 0 && c < counts_of<Graph>.call_count; ++c)
    if (const call& one = plan_of<Graph>.calls[array_size(c)]; one.node == node)
      for (int p = 0; p < one.function->input_count; ++p)
        if (one.function->inputs[p].name == path.substr(dot + 1)) return true;
  return false;
}

template <class Graph, fixed_string Path>
struct unknown_input {
  static constexpr void tell(text& m) {
    m << "wire.unknown_port: dropped<`" << Path.view() << "`>() names no input of " << type_name<Graph>();
    text best;
    auto least = std::max<std::size_t>(1, Path.view().size() / 3) + 1;
    const flat_view g = plan_of<Graph>.view();
    for (int c = 0; c < counts_of<Graph>.call_count; ++c)
      for (int p = 0; p < g.calls[c].function->input_count; ++p) {
        text path;
        add_node_path(path, g, g.calls[c].node);
        path << "." << g.calls[c].function->inputs[p].name;
        if (const auto distance = edit_distance(Path.view(), path.view()); distance < least) {
          least = distance;
          best = path;
        }
      }
    if (best.size > 0) m << "; did you mean `" << best.view() << "`?";
    else m << ": write `node.port`, from the outermost graph on";
  }
};

// `Self` has for_each_state(f): f.template operator()<Graph>(state) for the state of each loop that it runs,
// and refuse_if_elsewhere(node).
template <class Self, class Graph>
class dropped_samples {
public:
  template <fixed_string Path>
  std::int64_t dropped() const {
    static_assert(holds_or_tells<is_input<Graph>(Path.view()), unknown_input<Graph, Path>>::value);
    return dropped(Path.view());
  }
  std::int64_t dropped(std::string_view path) const {
    std::int64_t all = 0;
    if (find(path))
      for_each_queue([&](const std::string& input, std::int64_t lost, int) {
        if (input == path) all += lost;
      });
    return all;
  }
  std::int64_t dropped() const {
    std::int64_t all = 0;
    for_each_queue([&](const std::string&, std::int64_t lost, int) { all += lost; });
    return all;
  }

  // f(path of the input, samples lost, room) for each queue.
  template <class F>
  void for_each_queue(F f) const {
    self().for_each_state([&]<class Loop>(const auto& state) {
      [&]<int... Input>(std::integer_sequence<int, Input...>) {
        const int all[] = {0, (tell<Loop, Input>(state, f), 0)...};
        (void)all;
      }(chosen < counts_of<Loop>.queue_count == 0 ? 0 : counts_of<Loop>.input_count,
        has_own_queue < Loop >> {});
    });
  }

private:
  const Self& self() const { return static_cast<const Self&>(*this); }

  template <class Loop, int Input, class State, class F>
  static void tell(const State& state, F& f) {
    constexpr place at = layout_of<Loop>.sources[Input];
    f(path_of_input<Loop>(Input), sample_in<Loop, at.array>(state, at.index).dropped(),
      input_of<Loop, Input>.wire->capacity);
  }

  // Refused: there is no input of this path. False: it has no queue.
  bool find(std::string_view path) const {
    std::vector<std::string> paths;
    for (int c = 0; c < counts_of<Graph>.call_count; ++c) {
      const call& one = plan_of<Graph>.calls[array_size(c)];
      for (int p = 0; p < one.function->input_count; ++p) {
        paths.push_back(path_of_node<Graph>(one.node) + "." + std::string(one.function->inputs[p].name));
        if (paths.back() != path) continue;
        self().refuse_if_elsewhere(one.node);
        return counts_of<Graph>.queue_count > 0;
      }
    }
    const std::vector<std::string_view> names(paths.begin(), paths.end());
    const auto near = nearest_name(path, names);
    throw refused("cca::controller: dropped(`" + std::string(path) + "`): there is no such input" +
                  (near.empty() ? "" : "; did you mean `" + std::string(near) + "`?"));
  }
};

}  // namespace cca::detail
