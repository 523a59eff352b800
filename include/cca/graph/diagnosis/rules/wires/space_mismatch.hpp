// space.mismatch: both ends of a wire have the same domain type, axes, frame and rate.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct space_mismatch {
  static constexpr std::string_view id = "space.mismatch";

  static constexpr bool is_broken(when::connection, const flat_view& g, const finding& f) {
    return !matches(*port_of(g, g.outputs[f.output]).space, *port_of(g, g.inputs[f.input]).space);
  }

  static constexpr void tell(auto& m) {
    const auto& from = m.g.outputs[m.found().output];
    const auto& to = m.g.inputs[m.found().input];
    const auto &a = m.space(from), &b = m.space(to);
    m.at_wire();
    m.wired_port(from, m.item().from);
    m.say() << " publishes ";
    add_space(m.say(), a);
    m.say() << " but ";
    m.wired_port(to, m.item().to);
    m.say() << " expects ";
    add_space(m.say(), b);
    const auto base = [](std::string_view name) { return name.substr(0, name.find('<')); };
    if (a.domain != b.domain && base(a.domain) == base(b.domain))
      m.say() << ": the frames differ; put a transformation between them";
    else if (a.domain != b.domain)
      m.say() << ": the domain types differ; put a mapping between them, or wire another port";
    else if (has_same_axes_in_another_order(a, b) && !has_same_axes(a, b))
      m.say() << ": the axes are in another order; give both ends one space";
    else if (!has_same_axes(a, b))
      m.say() << ": the axes differ; use a splitter or a collector, or give both ends one space";
    else if (a.hz != b.hz)
      m.say() << ": the rates differ; give both spaces one rate, or let one of them state none";
    else
      m.say()
          << ": their domain types, axes or frames have the same names but are different types; use those of "
             "one namespace";
  }

private:
  static constexpr bool has_same_axes(const space_info& a, const space_info& b) {
    bool same = a.axis_count == b.axis_count;
    for (int i = 0; same && i < a.axis_count; ++i) same = a.axes[i] == b.axes[i];
    return same;
  }

  static constexpr bool has_same_axes_in_another_order(const space_info& a, const space_info& b) {
    bool all = a.axis_count == b.axis_count;
    for (int i = 0; all && i < a.axis_count; ++i) {
      all = false;
      for (int j = 0; j < b.axis_count; ++j) all |= a.axes[i] == b.axes[j];
    }
    return all;
  }
};

}  // namespace cca::detail
