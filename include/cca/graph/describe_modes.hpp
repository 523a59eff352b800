// The picture of a set of modes, and of a deployment of one: a box for each mode, with its picture.
//
//   std::cout << cca::describe<legs>::mermaid();
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <cca/graph/describe.hpp>
#include <cca/graph/modes/plan_of_modes.hpp>

namespace cca {

template <Modes M>
struct describe<M> {
  static std::string mermaid(std::string_view transport = "memory") {
    return writer::mermaid_head() + boxes(false, transport);
  }
  static std::string dot(std::string_view transport = "memory") {
    return writer::dot_head(detail::type_name<M>()) + boxes(true, transport) + "}\n";
  }

private:
  using writer = detail::picture_writer<std::string>;

  static std::string boxes(bool as_dot, std::string_view transport) {
    std::string text;
    [&]<int... I>(std::integer_sequence<int, I...>) {
      ((text += box<typename detail::modes_of<M>::template graph<I>>(I, as_dot, transport)), ...);
    }(std::make_integer_sequence<int, detail::mode_count<M>>{});
    return text;
  }
  // An item that is no mode has no graph.
  template <class Graph>
  static std::string box([[maybe_unused]] int mode,
                         [[maybe_unused]] bool as_dot,
                         [[maybe_unused]] std::string_view transport) {
    if constexpr (cca::Graph<Graph>) {
      auto plan = detail::plan_of<Graph>;
      // A deployment has the clocks that hold after a switch; here those of each mode by itself.
      if constexpr (requires { typename Graph::cca_architecture; })
        for (std::size_t c = 0; c < plan.calls.size(); ++c)
          plan.calls[c].fires = detail::plan_of<typename Graph::cca_architecture>.calls[c].fires;
      const std::string name = "m" + std::to_string(mode);
      writer of_mode(plan.view(), transport, name + "_");
      return writer::box(as_dot, name, detail::modes_of<M>::value.modes[mode].name) +
             (as_dot ? of_mode.dot() : of_mode.mermaid()) + writer::box_end(as_dot);
    } else {
      return {};
    }
  }
};

}  // namespace cca
