// Messages about time: rates, clocks, queues, order, origins and age.
#pragma once

#include <cca/graph/cycle.hpp>
#include <cca/graph/telling.hpp>

namespace cca::detail {

constexpr void tell_rate_missing(auto& t) {
  t.where << t.graph().name;
  if (t.g.hz > 0)
    t.say() << t.graph().name << " or one of its spaces states " << t.g.hz
            << " Hz, and a beat is at least a nanosecond long: state at most 1,000,000,000 Hz";
  else
    t.say()
        << "neither " << t.graph().name
        << " nor any of its spaces states a rate, so a beat has no length: add cca::rate<1000> to the graph";
}

constexpr void tell_rate_mismatch(auto& t) {
  if (t.item().kind == item_kind::rate) {
    if (t.found().scope == 0) {
      t.where << t.graph().name;
      t.say() << t.graph().name << " states two rates, " << t.g.hz << " Hz and " << t.item().hz
              << " Hz, but all of it runs in one beat: keep one";
      return;
    }
    add_scope_path(t.where, t.g, t.found().scope);
    if (t.where.size > 0) --t.where.size;  // without the dot
    t.say() << "the inner graph `" << t.where.view() << "` (" << t.graph().name << ") states " << t.item().hz
            << " Hz, but " << t.g.scopes[0].graph->name << " runs at " << t.g.hz
            << " Hz: give both one rate, or let the inner one state none";
    return;
  }
  const auto& out = t.g.outputs[t.found().a];
  const auto c = published(t.g, out);
  t.at(out);
  t.port(out);
  t.say() << " is published ";
  add_clock(t.say(), c);
  t.say() << ", that is at " << t.g.hz / static_cast<double>(c.period) << " Hz, but its space is ";
  add_space(t.say(), t.space(out));
  t.say() << ": change the strategy of `";
  add_node_path(t.say(), t.g, t.g.calls[out.call].node);
  t.say() << "`, or the rate of the space, or let the space state none";
}

constexpr void tell_rate_unstated(auto& t) {
  t.at_wire();
  t.two_clocks(t.g.outputs[t.found().a], t.g.inputs[t.found().b]);
  t.say() << ", and the wire does not say what happens between them: write ";
  t.wire_with(t.item().from, t.item().to, "cca::latest");
  t.say() << ", or cca::queue or cca::delayed instead";
}

constexpr void tell_overflow(auto& t) {
  t.at_wire();
  const auto& out = t.g.outputs[t.found().a];
  const auto& in = t.g.inputs[t.found().b];
  t.two_clocks(out, in);
  const bool falls_behind =
      published(t.g, out).period < t.g.calls[in.call].fires.period || t.g.calls[in.call].fires.never();
  t.say() << ", so the queue of " << t.item().number
          << " between them is full sooner or later, which cca::reject forbids: read "
          << (falls_behind ? "faster" : "sooner")
          << ", or say what is lost: cca::drop_oldest or cca::drop_newest";
}

constexpr void tell_never_fires(auto& t) {
  t.at_node();
  t.node();
  if (t.found().b == 0)
    t.say() << " fires when an input is fresh, but none of those that it waits for is wired: wire one, or "
               "make it cca::timed";
  else if (t.found().b == 2)
    t.say() << " counts beats by a number below 1: in cca::timed<N> and cca::timeout<N> it is at least 1";
  else
    t.say() << " never fires: the clocks under its cca::all_of have no beat in common; change a period or a "
               "phase";
}

constexpr void tell_coordination(auto& t) {
  const auto &a = t.g.inputs[t.found().a], &b = t.g.inputs[t.found().b];
  t.at_node();
  t.node();
  t.say() << " is cca::coordinated, but ";
  t.port(a);
  t.say() << " (from ";
  t.port(t.g.outputs[a.writer]);
  t.say() << ", ";
  add_clock(t.say(), published(t.g, t.g.outputs[a.writer]));
  t.say() << ") and ";
  t.port(b);
  t.say() << " (from ";
  t.port(t.g.outputs[b.writer]);
  t.say() << ", ";
  add_clock(t.say(), published(t.g, t.g.outputs[b.writer]));
  t.say() << ") never hold samples of one time of origin, so it would never fire: feed them from one source "
             "at one rate, with equal delays, or make it cca::moderate";
}

constexpr void tell_latency(auto& t) {
  t.at_wire();
  t.say() << "a sample of `" << t.item().from << "` can be ";
  if (t.found().a < 0) t.say() << "of any age";
  else t.say() << t.found().a << (t.found().a == 1 ? " beat old" : " beats old");
  t.say() << " when `" << t.item().to << "` is read, but " << t.graph().name << " requires at most "
          << t.item().number << ": "
          << (t.found().a < 0
                  ? "a clock on the way is known only at run time; make those components cca::timed"
                  : "shorten a delay or a queue on the way, or run the components on it more often");
}

constexpr void tell_loop(auto& t) {
  const auto loop = find_cycle(t.g);
  if (loop.length == 0) {
    for (int l = 0; l < t.g.link_count; ++l) {
      const auto& ear = t.g.inputs[t.g.links[l].input];
      const auto& heard = t.g.outputs[t.g.links[l].output];
      if (t.g.calls[ear.call].rank >= 0 || t.g.calls[heard.call].rank >= 0) continue;
      add_node_path(t.where, t.g, t.g.calls[ear.call].node);
      t.say() << "`" << t.where.view() << "` listens to `" << port_of(t.g, ear).name << "`, and so to ";
      t.port(heard);
      t.say() << ", which depends on what it publishes itself, so neither can come first; let it listen a "
                 "beat later: cca::observe<`"
              << port_of(t.g, ear).name << "`, cca::delayed<1>>";
      return;
    }
    return;
  }
  const auto input_at = [&](int i) -> const input& {
    return t.g.inputs[loop.inputs[static_cast<std::size_t>(i)]];
  };
  for (int i = 0; i < loop.length; ++i) {
    t.say() << (i > 0 ? ", " : "");
    t.port(t.g.outputs[input_at(i).writer]);
    t.say() << " -> ";
    t.port(input_at(i));
  }
  t.say() << (loop.backwards
                  ? " leads back within a beat, which is: every sense, then every component, then every act"
              : loop.length == 1
                  ? " is a loop without delay, so its component would have to come before itself"
                  : " are a loop without delay, so none of their components can come first")
          << "; say where it may be a beat late: ";
  const auto& last = input_at(loop.length - 1);
  t.wire_with(last.wire->from, last.wire->to, "cca::delayed<1>");
  add_port(t.where, t.g, t.g.outputs[last.writer]);
  t.where << " -> ";
  add_port(t.where, t.g, last);
}

}  // namespace cca::detail
