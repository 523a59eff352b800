// wire.unknown_port: a path names a port that exists, of a node of the same graph.
#pragma once

#include <cca/graph/diagnosis/nearest_port.hpp>
#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct wire_unknown_port {
  static constexpr std::string_view id = "wire.unknown_port";

  static constexpr bool is_broken(when::unknown_port, const flat_view&, const finding& f) {
    return !f.is_opposite;
  }

  static constexpr void tell(auto& m) {
    const auto& item = m.item();
    m.at_wire();
    const auto wrong = m.found().at_reader ? item.to : item.from;
    tell_item(m);
    m.say() << " in " << m.graph().name << " names `" << wrong << "`, but ";
    const auto first = wrong.substr(0, wrong.find('.'));
    const auto* node = node_named(m.graph(), first);
    if (first == wrong) m.say() << "a port is named with its node: `node.port`";
    else if (!names_port(wrong) && node && node->inner)
      return tell_inner_path(m, *node, wrong.substr(first.size() + 1));
    else if (!node) m.say() << "there is no node `" << first << "`";
    else
      m.say() << "`" << node->from << "` (" << (node->inner ? node->inner->name : node->component->name())
              << ") " << (node->inner ? "exposes" : "has") << " no such "
              << (item.kind == item_kind::expose ? "port"
                  : m.found().at_reader          ? "input"
                                                 : "output");
    auto best = nearest_port(m.graph(), wrong, !m.found().at_reader);
    if (best.size == 0 && item.kind == item_kind::expose) best = nearest_port(m.graph(), wrong, false);
    if (best.size > 0) m.say() << "; did you mean `" << best.view() << "`?";
    else if (node && first != wrong)
      tell_ports(m, *node, !m.found().at_reader, item.kind == item_kind::expose);
  }

private:
  // What a node has, where no name is near: of one side, or of both.
  static constexpr void tell_ports(auto& m, const item_info& node, bool outputs, bool both) {
    constexpr int most = 8;
    int count = 0;
    bool observes = false;
    const auto add = [&](std::string_view port, bool is_output) {
      if ((is_output != outputs && !both) || ++count > most) return;
      m.say() << (count == 1 ? "; it has `" : ", `") << port << "`";
    };
    if (node.component)
      for (const auto function : functions_of(*node.component)) {
        for (int p = 0; function && p < function->input_count; ++p) {
          if (function->inputs[p].space) add(function->inputs[p].name, false);
          else observes = true;
        }
        for (int p = 0; function && p < function->output_count; ++p) add(function->outputs[p].name, true);
      }
    for (int e = 0; node.inner && e < node.inner->count; ++e)
      if (const auto& inner = node.inner->items[e]; inner.kind == item_kind::expose)
        add(inner.to, is_output_named(*node.inner, inner.from));
    if (count > most) m.say() << " and others";
    if (count == 0 && observes && !outputs) m.say() << ": what it observes comes without a wire";
    else if (count == 0)
      m.say() << ": it has no " << (both ? "ports" : outputs ? "outputs" : "inputs") << " at all";
  }
  static constexpr void tell_item(auto& m) {
    if (m.item().kind == item_kind::wire) {
      m.say() << "the wire ";
      m.wire();
    } else {
      m.say() << (m.item().kind == item_kind::expose ? "cca::expose<`" : "cca::latency<`") << m.item().from
              << "`, `" << m.item().to << "`>";
    }
  }

  // `inside` is a path from the inner graph on.
  static constexpr void tell_inner_path(auto& m, const item_info& node, std::string_view inside) {
    const auto port = inside.substr(inside.rfind('.') + 1);
    m.say() << "a path into an inner graph cannot be wired: ";
    for (int i = 0; i < node.inner->count; ++i)
      if (const auto& shown = node.inner->items[i]; shown.kind == item_kind::expose && shown.from == inside) {
        m.say() << node.inner->name << " exposes this port as `" << node.from << "." << shown.to
                << "`, name that";
        return;
      }
    m.say() << "let " << node.inner->name << " expose the port, with cca::expose<`" << inside << "`, `"
            << port << "`>, and name `" << node.from << "." << port << "` here";
  }

  static constexpr const item_info* node_named(const graph_info& graph, std::string_view name) {
    for (int i = 0; i < graph.count; ++i)
      if ((graph.items[i].kind == item_kind::node || graph.items[i].kind == item_kind::graph) &&
          graph.items[i].from == name)
        return &graph.items[i];
    return nullptr;
  }
};

}  // namespace cca::detail
