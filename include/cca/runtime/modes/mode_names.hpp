// What the controllers of a set of modes say of it: its modes by name, what they refuse, and which inputs of
// a component are wired.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/fixed_string.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/messages/tell_names.hpp>
#include <cca/base/nearest.hpp>
#include <cca/base/refused.hpp>
#include <cca/runtime/modes/mode_switch.hpp>

namespace cca::detail {

// In one mode or more.
template <Modes M>
struct wired_inputs<M> {
  template <class F>
  static void each(int node, F f) {
    [&]<int... I>(std::integer_sequence<int, I...>) {
      (each_in<I>(node, f), ...);
    }(std::make_integer_sequence<int, mode_count<M>>{});
  }

private:
  template <int I, class F>
  static void each_in(int node, F& f) {
    using part = mode_part<M, I>;
    for (int n = 0; n < counts_of<part>.node_count; ++n)
      if (shared_nodes<M, I>[array_size(n)] == node) wired_inputs<part>::each(n, f);
  }
};

template <class M, fixed_string Mode>
struct unknown_mode_called {
  static constexpr void tell(text& m) {
    constexpr const auto& all = modes_of<M>::value;
    std::array<std::string_view, array_size(all.count)> names{};
    for (int i = 0; i < all.count; ++i) names[array_size(i)] = all.modes[i].name;
    m << "modes.unknown_mode: switch_to names the mode `" << Mode.view() << "`, which " << all.name
      << " lacks";
    tell_names(m, Mode.view(), names);
  }
};

template <class M>
class mode_names {
protected:
  static constexpr const auto& all = modes_of<M>::value;

  template <fixed_string Mode>
  static constexpr int mode_named() {
    constexpr int number = all.number_of(Mode.view());
    static_assert(holds_or_tells<(number >= 0), unknown_mode_called<M, Mode>>::value);
    return number;
  }
  static int number_of(std::string_view mode) {
    const int number = all.number_of(mode);
    if (number < 0) throw refused("cca::controller: switch_to: " + unknown_mode(mode));
    return number;
  }
  static std::string unknown_mode(std::string_view wrong) {
    std::vector<std::string_view> names;
    for (int m = 0; m < all.count; ++m) names.push_back(all.modes[m].name);
    std::string text(all.name);  // append: docs/compilers.md
    text.append(" has no mode `").append(wrong).append("`");
    if (const auto near = nearest_name(wrong, names); !near.empty())
      return text.append("; did you mean `").append(near).append("`?");
    text += "; it has";
    for (std::size_t m = 0; m < names.size(); ++m) text.append(m ? ", `" : " `").append(names[m]).append("`");
    return text;
  }
  [[noreturn]] static void refuse_part(const char* call, int number, std::string_view mode) {
    throw refused(std::string("cca::controller: ") + call + "(`" + path_of_part<M>(number) +
                  "`) is refused in the mode `" + std::string(mode) +
                  "`, which has no such component: it is started when a mode begins that has it");
  }
};

}  // namespace cca::detail
