// Patterns: what an `observe` names. A pattern is a path whose names may be `*` (one name) and `**` (any
// number of names, none included).
//
//   dmp.status.*         the ports of one component
//   dmp.**               everything below: outputs, and wired inputs with what they show
//   /mind.**.status.*    from the outermost graph
//   *.status.*|*.status  several, looked up together
//
// It is looked up in a graph, then in the graphs around it; the first graph in which it names anything
// counts. A port that a graph exposes has a second name there, as for wires. It is heard once, under its own
// path if the pattern names that.
#pragma once

#include <array>
#include <string_view>

#include <cca/base/text.hpp>
#include <cca/graph/plan/flat.hpp>
#include <cca/graph/plan/names.hpp>
#include <cca/graph/plan/scratch.hpp>

namespace cca::detail {

inline constexpr int most_names = 34;  // in a path

struct words_of_path {
  std::array<std::string_view, most_names> words{};
  int first = most_names;  // filled from the end: a path is known from its port outwards

  constexpr void put_before(std::string_view word) {
    if (first > 0) words[static_cast<std::size_t>(--first)] = word;
  }
  constexpr const std::string_view* begin() const { return words.data() + first; }
  constexpr int count() const { return most_names - first; }
};

// Asked for each port: to compare with a literal takes several times as many constexpr steps.
constexpr bool is_one_name(std::string_view word) { return word.size() == 1 && word.front() == '*'; }
constexpr bool is_any_names(std::string_view word) {
  return word.size() == 2 && word.front() == '*' && word.back() == '*';
}

constexpr bool matches(const std::string_view* word, int words, const std::string_view* name, int names) {
  for (; words > 0 && !is_any_names(*word); ++word, --words, ++name, --names)
    if (names == 0 || (!is_one_name(*word) && *word != *name)) return false;
  if (words == 1) return true;
  if (words == 0) return names == 0;
  for (int skipped = 0; skipped <= names; ++skipped)
    if (matches(word + 1, words - 1, name + skipped, names - skipped)) return true;
  return false;
}

// One alternative of a pattern.
struct one_pattern {
  words_of_path path{};
  bool from_outermost = false;

  constexpr one_pattern() = default;
  constexpr explicit one_pattern(std::string_view text) {
    from_outermost = text.starts_with('/');
    if (from_outermost) text.remove_prefix(1);
    for (bool is_last = false; !is_last;) {
      const auto dot = text.rfind('.');
      is_last = dot == text.npos;
      const auto word = is_last ? text : text.substr(dot + 1);
      if (path.count() == 0 || !is_any_names(word) || !is_any_names(*path.begin())) path.put_before(word);
      text = text.substr(0, is_last ? 0 : dot);
    }
  }
  constexpr std::string_view last() const { return path.words.back(); }
  constexpr bool names_inputs() const { return is_any_names(last()); }
  // Before the whole path of a port is put together.
  constexpr bool may_name(std::string_view port) const {
    return is_any_names(last()) || is_one_name(last()) || last() == port;
  }
  constexpr bool names(const words_of_path& port) const {
    return matches(path.begin(), path.count(), port.begin(), port.count());
  }
};

// A pattern with its alternatives.
struct pattern {
  std::array<one_pattern, 4> alternatives{};
  std::size_t count = 0;

  constexpr explicit pattern(std::string_view rest) {
    while (!rest.empty() && count < alternatives.size()) {
      const auto end = rest.find('|');
      alternatives[count++] = one_pattern(rest.substr(0, end));
      rest = end == rest.npos ? std::string_view() : rest.substr(end + 1);
    }
  }
  constexpr bool may_name_inputs() const {
    for (std::size_t i = 0; i < count; ++i)
      if (alternatives[i].names_inputs()) return true;
    return false;
  }
};

// A name of a port: the graph in which it stands, node and port.
struct port_name {
  int scope = 0;
  std::string_view node{}, port{};
  std::uint64_t node_hash = 0;
  ref<item_info> as = nullptr;  // the cca::expose that gives it; null: the port's own

  // Of its path in the graph in which it stands.
  constexpr std::uint64_t path_hash() const { return hash(port, after_dot(node_hash)); }
};

template <class Port>
constexpr port_name own_name(const flat_view& g, const Port& p) {
  const auto& node = g.nodes[g.calls[p.call].node];
  return {node.scope, node.item->from, port_of(g, p).name, node.item->from_hash};
}

// Calls f(name) for each name of a port, its own first, until f returns true.
template <class F>
constexpr bool any_name(const flat_view& g, const port_name& name, F f) {
  if (f(name)) return true;
  const auto& inside = g.scopes[name.scope];
  if (inside.parent < 0) return false;  // what the outermost graph exposes has no name in another one
  const auto path = name.path_hash();
  for (int i = 0; i < inside.graph->count; ++i) {
    const auto& item = inside.graph->items[i];
    if (item.kind != item_kind::expose || item.from_hash != path) continue;
    if (any_name(g, {inside.parent, inside.item->from, item.to, inside.item->from_hash, &item}, f))
      return true;
  }
  return false;
}

// The name that a cca::expose gives to a port; null: its own.
template <class Port>
constexpr port_name name_as(const flat_view& g, const Port& p, ref<item_info> as) {
  port_name found = own_name(g, p);
  if (as)
    any_name(g, found, [&](const port_name& one) {
      const bool is_it = one.as && &*one.as == &*as;
      if (is_it) found = one;
      return is_it;
    });
  return found;
}

// The path of a name from a graph on. False: it stands outside of it.
constexpr bool find_path(words_of_path& path, const flat_view& g, const port_name& name, int in_scope) {
  path.first = most_names;
  path.put_before(name.port);
  path.put_before(name.node);
  int s = name.scope;
  for (; s != in_scope && s >= 0; s = g.scopes[s].parent)
    if (g.scopes[s].item) path.put_before(g.scopes[s].item->from);
  return s == in_scope;
}
constexpr words_of_path path_from(const flat_view& g, const port_name& name, int in_scope) {
  words_of_path path;
  return find_path(path, g, name, in_scope) ? path : words_of_path();
}
constexpr void add_path(text& t, const words_of_path& path) {
  for (int i = 0; i < path.count(); ++i) t << (i > 0 ? "." : "") << path.begin()[i];
}

// The name under which an observer hears something.
constexpr port_name name_of_link(const flat_view& g, const link& l) {
  return l.input < 0 ? name_as(g, g.outputs[l.output], l.heard_as)
                     : name_as(g, g.inputs[l.input], l.heard_as);
}

template <class F>
constexpr void for_each_observer(const flat_view& g, int call, F f) {
  const auto& t = g.calls[call];
  for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
    if (!port_of(g, g.inputs[i]).space) f(g.inputs[i]);
}

// The link by which a function hears a path, which is looked up as a pattern is; -1: it does not hear it.
constexpr int link_at(const flat_view& g, int call, std::string_view path, int scope) {
  const bool from_outermost = path.starts_with('/');
  if (from_outermost) path.remove_prefix(1);
  for (int s = from_outermost ? 0 : scope; s >= 0; s = g.scopes[s].parent)
    for (int l = 0; l < g.link_count; ++l) {
      if (const auto& own = g.inputs[g.links[l].observer]; own.call != call || own.outside) continue;
      text known;
      add_path(known, path_from(g, name_of_link(g, g.links[l]), s));
      if (known.view() == path) return l;
    }
  return -1;
}

// The names of all ports. They are found once for all patterns, which takes far fewer constexpr steps.
class names_of_ports {
public:
  explicit constexpr names_of_ports(const flat_view& g)
      : outputs(g.output_count - g.taken_count), first(outputs + g.first_link + 1) {
    for (int o = 0; o < outputs; ++o) add(g, o, own_name(g, g.outputs[o]));
    for (int i = 0; i < g.first_link; ++i) add(g, outputs + i, own_name(g, g.inputs[i]));
  }
  names_of_ports(const names_of_ports&) = delete;
  names_of_ports& operator=(const names_of_ports&) = delete;

  // As any_name.
  template <class F>
  constexpr bool any_of_output(int o, F f) const {
    return any(o, f);
  }
  template <class F>
  constexpr bool any_of_input(int i, F f) const {
    return any(outputs + i, f);
  }

private:
  constexpr void add(const flat_view& g, int number, const port_name& own) {
    any_name(g, own, [this](const port_name& name) {
      names.add(name);
      return false;
    });
    first[number + 1] = names.size();
  }
  template <class F>
  constexpr bool any(int number, F& f) const {
    for (int n = first[number]; n < first[number + 1]; ++n)
      if (f(names[n])) return true;
    return false;
  }

  int outputs;
  scratch first;
  growing_array<port_name> names;
};

// What a pattern names in one graph.
struct pattern_search {
  const flat_view& g;
  const names_of_ports& names;
  const pattern& whole;
  int in_scope;
  int observer = -1;    // the call that observes, which does not hear its own ports; -1: none
  words_of_path& path;  // of the port that is looked at: to make one for each takes many constexpr steps

  // `as` becomes the name under which it is found.
  constexpr bool finds(const port_name& name, bool is_input, ref<item_info>& as) const {
    for (std::size_t i = 0; i < whole.count; ++i) {
      const auto& one = whole.alternatives[i];
      if ((is_input && !one.names_inputs()) || (one.from_outermost && in_scope != 0) ||
          !one.may_name(name.port))
        continue;
      if (!find_path(path, g, name, in_scope) || !one.names(path)) continue;
      as = name.as;
      return true;
    }
    return false;
  }

  // Calls f(output, -1, name) and, after them, f(its writer, input, name); returns how many there are.
  template <class F>
  constexpr int for_each(F f) const {
    int count = 0;
    ref<item_info> as = nullptr;
    for (int o = 0; o < g.output_count - g.taken_count; ++o)
      if (g.outputs[o].call != observer &&
          names.any_of_output(o, [&](const port_name& name) { return finds(name, false, as); })) {
        f(o, -1, as);
        ++count;
      }
    if (!whole.may_name_inputs()) return count;
    for (int i = 0; i < g.first_link; ++i)
      if (const auto& in = g.inputs[i];
          in.writer >= 0 && in.way_of < 0 && in.call != observer &&
          names.any_of_input(i, [&](const port_name& name) { return finds(name, true, as); })) {
        f(in.writer, i, as);
        ++count;
      }
    return count;
  }
};

// Of the first graph in which the pattern names anything, from `scope` outwards.
template <class F>
constexpr int for_each_named(
    const flat_view& g, const names_of_ports& names, std::string_view text, int scope, int observer, F f) {
  const pattern whole(text);
  words_of_path path;
  for (int s = scope; s >= 0; s = g.scopes[s].parent)
    if (const int count = pattern_search{g, names, whole, s, observer, path}.for_each(f); count > 0)
      return count;
  return 0;
}

}  // namespace cca::detail
