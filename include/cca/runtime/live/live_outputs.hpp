// The part of cca::live_access that shows what is observed: the newest sample of each output, for any thread.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/graph/diagnosis/nearest_output.hpp>
#include <cca/runtime/live/live_components.hpp>
#include <cca/runtime/live/live_output.hpp>

namespace cca::detail {

template <class Controller, class Graph>
class live_outputs {
public:
  // The newest sample of an output that an item `observe<...>` of the graph names; empty if there is none
  // yet. Of a set of modes: the last one that was published, also if the active mode lacks the output.
  // Refused: another path.
  std::optional<live_sample> newest(std::string_view path) const {
    for (const auto& output : outputs)
      if (output.path() == path) return output.newest();
    const flat_view g = plan_of<Graph>.view();
    if (output_named(g, path) < 0) {
      const text near = nearest_output(g, path);
      throw refused("cca::live_access: newest: there is no output `" + std::string(path) + "`" +
                    (near.size == 0 ? std::string(": give the path of one, as in `robot.angles`")
                                    : "; did you mean `" + std::string(near.view()) + "`?"));
    }
    throw refused("cca::live_access: nobody observes `" + std::string(path) + "`: add cca::observe<\"" +
                  std::string(path) + "\"> to the items of the graph" +
                  (live_loops<Controller>::count > 1 ? ", and ask the process that runs it" : ""));
  }

protected:
  explicit live_outputs(const Controller& c) {
    live_components::for_each_output(c, [&](const observation& o) {
      const auto known = std::ranges::find(outputs, o.path, &live_output::path);
      by_text.emplace_back(o.path.data(),
                           known != outputs.end() ? &*known : &outputs.emplace_back(o.path, o.values.size()));
    });
    std::ranges::sort(by_text, std::less<>(), &entry::first);
    live_components::observe_all(c, [&](const observation& o) {
      if (o.origin != never) put(o);
    });
  }

  // A loop's, between two of its beats.
  template <int Loop>
  void look(const Controller& c) noexcept {
    live_components::observe<Loop>(c, [&](const observation& o) {
      if (o.fresh) put(o);
    });
  }

private:
  // A path is static text: of each output, and in each mode, another one.
  using entry = std::pair<const char*, live_output*>;

  void put(const observation& o) noexcept {
    std::ranges::lower_bound(by_text, o.path.data(), std::less<>(), &entry::first)->second->put(o);
  }

  std::deque<live_output> outputs;
  std::vector<entry> by_text;
};

}  // namespace cca::detail
