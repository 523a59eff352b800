// The graph as a picture: Mermaid for pages, DOT for graphviz, with spaces, rates and policies on the wires.
//
//   std::cout << cca::describe<trot<cca::sim::oncilla>>::mermaid();
//
// The environments of a deployment are boxes. A wire from one to another shows its transport and delay. The
// transport is chosen when the program starts, so it is an argument: mermaid("DDS"). The picture of a set of
// modes has a box for each mode (graph/describe_modes.hpp).
//
// Works for graphs that break a rule as far as their parts are known, so that one can look at them too.
#pragma once

// Included first: if it refuses something, the compilers list every file around it.
#include <cca/component/port.hpp>

#include <string>
#include <string_view>
#include <utility>

#include <cca/graph/deployment/environments.hpp>
#include <cca/graph/plan/paths.hpp>
#include <cca/graph/layout/types.hpp>

namespace cca {
namespace detail {

// A template, so that it is compiled only where a graph is described.
template <class String>
class picture_writer {
public:
  // `of_mode`: begins each name, where several graphs are in one picture, each in a box.
  picture_writer(const flat_view& graph, std::string_view between_environments, String of_mode = {})
      : g(graph), transport(between_environments), prefix(std::move(of_mode)) {}

  static String mermaid_head() { return "flowchart LR\n"; }
  String mermaid() {
    add_boxes(false);
    for (int i = 0; i < g.first_link; ++i)
      if (const auto& in = g.inputs[i]; in.writer >= 0)
        text += indent_at(1) + id(node_of_output(in.writer)) + (in.delay > 0 ? " -. \"" : " -- \"") +
                label(in, "<br/>") + (in.delay > 0 ? "\" .-> " : "\" --> ") + id(g.calls[in.call].node) +
                "\n";
    return text;
  }

  static String dot_head(std::string_view title) {
    return "digraph \"" + quoted(title) +
           "\" {\n  rankdir=LR;\n  node [shape=box, style=rounded, fontname=\"sans-serif\"];\n"
           "  edge [fontname=\"sans-serif\", fontsize=10];\n";
  }
  String dot() {
    add_boxes(true);
    for (int i = 0; i < g.first_link; ++i)
      if (const auto& in = g.inputs[i]; in.writer >= 0)
        text += indent_at(1) + id(node_of_output(in.writer)) + " -> " + id(g.calls[in.call].node) +
                " [label=\"" + label(in, "\\n") + "\"" + (in.delay > 0 ? ", style=dashed" : "") + "];\n";
    return text;
  }

  // The beginning of a box. Then follows its content, then box_end().
  static String box(bool as_dot, const String& name, std::string_view title, int depth = 1) {
    const String indent(static_cast<std::size_t>(2 * depth), ' ');
    return as_dot ? indent + "subgraph cluster_" + name + " {\n" + indent + "  label=\"" + quoted(title) +
                        "\";\n" + indent + "  style=bold;\n"
                  : indent + "subgraph " + name + "[\"<b>" + escaped(title) + "</b>\"]\n";
  }
  static String box_end(bool as_dot, int depth = 1) {
    return String(static_cast<std::size_t>(2 * depth), ' ') + (as_dot ? "}\n" : "end\n");
  }

private:
  String id(int node_index) const { return prefix + "n" + std::to_string(node_index); }
  String indent_at(int depth) const {
    return String(static_cast<std::size_t>(2 * (depth + is_in_box())), ' ');
  }
  int is_in_box() const { return prefix.empty() ? 0 : 1; }
  int node_of_output(int o) const { return g.calls[g.outputs[o].call].node; }

  // Environments are boxes, and nodes without one stand outside of them.
  void add_boxes(bool as_dot) {
    add_scope(0, 1, -1, as_dot);
    for (int e = 0; g.is_spread && e < placement_in(g).count; ++e) {
      if (is_in_box() && !has_nodes(e)) continue;
      text += box(as_dot, prefix + "e" + std::to_string(e), environment_in(g, e).name, 1 + is_in_box());
      add_scope(0, 2, e, as_dot);
      text += box_end(as_dot, 1 + is_in_box());
    }
  }

  // What runs in one environment. Inner graphs are boxes around their nodes, but for those whose nodes run in
  // several environments.
  void add_scope(int s, int depth, int environment, bool as_dot) {
    const String indent = indent_at(depth);
    for (int l = 0; l < g.node_count; ++l)
      if (g.nodes[l].scope == s && g.nodes[l].place == environment)
        text += indent + (as_dot ? dot_node(l) : mermaid_node(l));
    for (int inner = s + 1; inner < g.scope_count; ++inner) {
      if (g.scopes[inner].parent != s) continue;
      if (is_split(inner)) {
        add_scope(inner, depth, environment, as_dot);
        continue;
      }
      if (environment_of(inner) != environment) continue;
      const String name = name_in(s, *g.scopes[inner].item);
      text += as_dot ? indent + "subgraph cluster_" + prefix + std::to_string(inner) + " {\n" + indent +
                           "  label=\"" + name + "\";\n"
                     : indent + "subgraph " + prefix + "g" + std::to_string(inner) + "[\"" + name + "\"]\n";
      add_scope(inner, depth + 1, environment, as_dot);
      text += indent + (as_dot ? "}\n" : "end\n");
    }
  }

  bool has_nodes(int environment) const {
    for (int l = 0; l < g.node_count; ++l)
      if (g.nodes[l].place == environment) return true;
    return false;
  }
  bool is_inside(int node, int s) const {
    for (int at = g.nodes[node].scope; at >= s; at = g.scopes[at].parent)
      if (at == s) return true;
    return false;
  }
  // That of the first component in a graph; -1: none.
  int environment_of(int s) const {
    for (int l = 0; l < g.node_count; ++l)
      if (is_inside(l, s)) return g.nodes[l].place;
    return -1;
  }
  bool is_split(int s) const {
    const int first = environment_of(s);
    for (int l = 0; l < g.node_count; ++l)
      if (is_inside(l, s) && g.nodes[l].place != first) return true;
    return false;
  }
  // Where the graph around it has no box, its path from the outermost graph.
  String name_in(int s, const item_info& item) const {
    detail::text name;
    if (s > 0 && is_split(s)) add_scope_path(name, g, s);
    name << item.from;
    return String(name.view());
  }
  String name_of(int l) const { return name_in(g.nodes[l].scope, *g.nodes[l].item); }

  String mermaid_node(int l) const {
    const bool resource = g.nodes[l].item->component->resource();
    return id(l) + (resource ? "[(\"" : "[\"") + name_of(l) + "<br/><i>" + escaped(when(l)) + "</i>" +
           (resource ? "\")]\n" : "\"]\n");
  }
  String dot_node(int l) const {
    return id(l) + " [label=\"" + name_of(l) + "\\n" + when(l) + "\"" +
           (g.nodes[l].item->component->resource() ? ", shape=cylinder" : "") + "];\n";
  }

  // When a component fires: its clock as a rate, or its strategy.
  String when(int l) const {
    const auto& t = g.calls[g.nodes[l].first_call];
    if (const auto& item = *g.nodes[l].item; item.is_stoppable()) {
      detail::text stated;
      item.strategy->add_name(stated);
      return String(stated.view());
    }
    if (g.hz > 0 && t.fires.known()) return hertz(g.hz / static_cast<double>(t.fires.period));
    detail::text name;
    strategy_of_call(g, t).add_name(name);
    return String(name.view());
  }

  String label(const input& in, const char* line_break) const {
    const auto& out = g.outputs[in.writer];
    String from(port_of(g, out).name), to(port_of(g, in).name);
    String all = from == to ? from : from + " → " + to;
    const auto c = published(g, out);
    const std::string_view space = port_of(g, out).space->name;
    all += line_break + (line_break[0] == '<' ? String(space) : quoted(space));
    if (g.hz > 0 && c.known()) all += ", " + hertz(g.hz / static_cast<double>(c.period));
    if (in.delay > 0)
      all += line_break + (crosses(in) ? joined(transport, line_break) : String()) + "delayed " +
             std::to_string(in.delay);
    if (in.wire->has_queue())
      all += String(line_break) + (in.wire->policy == policy_kind::merged ? "merged " : "queue ") +
             std::to_string(in.wire->capacity);
    return line_break[0] == '<' ? keep_breaks(all) : all;
  }

  bool crosses(const input& in) const {
    return g.nodes[g.calls[in.call].node].place != g.nodes[node_of_output(in.writer)].place;
  }

  static String joined(std::string_view name, const char* line_break) {
    return (line_break[0] == '<' ? String(name) : quoted(name)) + ", ";
  }

  static String hertz(double hz) {
    detail::text t;
    t << hz << " Hz";
    return String(t.view());
  }

  static String escaped(std::string_view plain) {
    String html;
    for (const char c : plain)
      c == '<' ? html += "&lt;" : c == '>' ? html += "&gt;" : c == '"' ? html += "&quot;" : html += c;
    return html;
  }
  // For DOT, in quotation marks.
  static String quoted(std::string_view plain) {
    String text;
    for (const char c : plain) c == '"' ? text += "\\\"" : c == '\\' ? text += "\\\\" : text += c;
    return text;
  }
  // Names of spaces may hold `<`, a line break does.
  static String keep_breaks(std::string_view all) {
    String html;
    for (std::size_t at = 0;;) {
      const auto next = all.find("<br/>", at);
      html += escaped(all.substr(at, next - at));
      if (next == all.npos) return html;
      html += "<br/>";
      at = next + 5;
    }
  }

  flat_view g;
  std::string_view transport;
  String prefix, text;
};

constexpr std::string_view title_of_picture(const flat_view& g) {
  return g.is_spread ? placement_in(g).deployment->name : g.scopes[0].graph->name;
}

}  // namespace detail

template <class Graph>
struct describe {
  static std::string mermaid(std::string_view transport = "memory") {
    auto plan = detail::plan_of<Graph>;
    using writer = detail::picture_writer<std::string>;
    return writer::mermaid_head() + writer(plan.view(), transport).mermaid();
  }
  static std::string dot(std::string_view transport = "memory") {
    auto plan = detail::plan_of<Graph>;
    using writer = detail::picture_writer<std::string>;
    return writer::dot_head(detail::title_of_picture(plan.view())) + writer(plan.view(), transport).dot() +
           "}\n";
  }
};

}  // namespace cca
