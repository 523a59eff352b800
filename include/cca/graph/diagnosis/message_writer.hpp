// Writes a message: names of nodes, ports and wires as the user knows them.
#pragma once

#include <cca/graph/plan/paths.hpp>

namespace cca::detail {

struct message_writer {
  flat_view g;
  text where{}, message{};

  constexpr text& say() { return message; }
  constexpr const finding& found() const { return g.found; }
  constexpr const item_info& item() const { return *g.found.item; }
  constexpr const graph_info& graph() const { return *g.scopes[g.found.scope].graph; }

  // These write `where`, what is at fault; all below write the message.
  constexpr void at_node() {
    add_scope_path(where, g, g.found.scope);
    where << item().from;
  }
  constexpr void at_wire() {
    add_scope_path(where, g, g.found.scope);
    where << item().from << " -> ";
    add_scope_path(where, g, g.found.scope);
    where << item().to;
  }
  constexpr void at(const input& i) { add_port(where, g, i); }
  constexpr void at(const output& o) { add_port(where, g, o); }

  // `dmp.gait` (gait_shape)
  constexpr void node() {
    say() << "`";
    add_scope_path(say(), g, g.found.scope);
    say() << item().from << "`";
    if (item().component) say() << " (" << item().component->name() << ")";
    if (item().inner) say() << " (" << item().inner->name << ")";
  }
  template <class Port>
  constexpr void port(const Port& p) {
    say() << "`";
    add_port(say(), g, p);
    say() << "`";
  }
  // The same; if the wire names it as an inner graph exposes it, with that name.
  template <class Port>
  constexpr void wired_port(const Port& p, std::string_view name) {
    port(p);
    text path;
    add_port(path, g, p);
    if (!path.view().ends_with(name)) say() << " (exposed as `" << name << "`)";
  }
  constexpr const space_info& space(const input& i) const { return *port_of(g, i).space; }
  constexpr const space_info& space(const output& o) const { return *port_of(g, o).space; }

  // As the user wrote it, but in backquotes: compilers print other quotes with backslashes.
  constexpr void wire() { say() << "`" << item().from << "` -> `" << item().to << "`"; }
  constexpr void wire_with(std::string_view from, std::string_view to, std::string_view option) {
    say() << "cca::wire<`" << from << "`, `" << to << "`, " << option << ">";
  }

  // `cpg.phase` is published every 10 beats but `gait.phase` is read every beat
  constexpr void two_clocks(const output& from, const input& to) {
    port(from);
    done(" published", published(g, from));
    say() << " but ";
    port(to);
    done(" read", g.calls[to.call].fires);
  }
  constexpr void done(std::string_view what, clock c) {
    say() << (c.never() ? " is never" : " is") << what;
    if (c.never()) return;
    say() << " ";
    add_clock(say(), c);
  }
};

}  // namespace cca::detail
