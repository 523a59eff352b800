// clang-format off
// A flat graph as text, one thing a line, so that you can read and shrink a failing one by hand:
//
//   architecture 17
//   period 1000000
//   feature 2 exposes                                   what the code has but the flat graph does not show
//   component arm.mix any_of 2 moderate timeout 15      path, strategy; `resource` for a resource node
//   part arm 20 35                                      may be stopped; is, before beat 20, and started before beat 35
//   asks orders arm stops 3                             a component stops or starts it by its results
//   habit 3 100 0 -1                                    id, publishes, origin, fault_at
//   skeleton switch 2 3000000                           instead of a habit: what skeletons.hpp knows
//   process                                             or sense, act: whose ports follow
//   switch 12 stand                                     before beat 12 somebody switches to this mode
//   mode stand                                          what follows is the graph of this mode
//   switches orders stand 98                            a component asks for it by its results; and a salt
//   exposed arm.p0 arm.mix.y                            a second name of a port
//   in x 2                                              name, axes; `optional`
//   observe arm.** delayed 1                            a pattern, and its policy as that of a wire
//   watch arm mix.* queue 4 drop_oldest                 the same of a graph, for programs; `-`: the outermost
//   look 7 20                                           before these beats a program looks
//   out y 1                                             `maybe`; and `fault` last, if it may stop
//   wire arm.mix.y body.act.x delayed 3 initial 0.5     or latest, queue 4 drop_oldest
// clang-format on
#pragma once

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include "interpreter.hpp"
#include "skeletons.hpp"

namespace semantics {

inline strategy read_strategy(std::istream& from) {
  strategy s;
  std::string word;
  from >> word;
  const auto names = [&] {
    int count = 0;
    for (from >> count; count > 0; --count) s.names.emplace_back(), from >> s.names.back();
  };
  const auto parts = [&] {
    int count = 0;
    for (from >> count; count > 0; --count) s.parts.push_back(read_strategy(from));
  };
  const auto found = std::find(std::begin(strategy_names), std::end(strategy_names), word);
  if (found == std::end(strategy_names)) throw std::runtime_error("description: no strategy '" + word + "'");
  s.is = static_cast<strategy::kind>(found - std::begin(strategy_names));
  if (s.is == strategy::timed) from >> s.n >> s.phase;
  if (s.is == strategy::timeout) from >> s.n;
  if (s.is == strategy::port_triggered) names();
  if (s.is == strategy::any_of || s.is == strategy::all_of) parts();
  if (s.is == strategy::stoppable) s.parts.push_back(read_strategy(from));
  if (s.is == strategy::user) {
    static int count = 0;
    s.number = ++count;
    s.names.resize(2), from >> s.names[0] >> s.names[1] >> s.n >> s.phase;
  }
  return s;
}

class describer {
public:
  graph g;                   // the newest mode, if there are several
  std::vector<graph> modes;  // those before it

  void line(const std::string& text) {
    std::istringstream from(text);
    std::string word;
    if (!(from >> word)) return;
    if (word == "architecture") from >> g.name;
    else if (word == "period") from >> g.period;
    else if (word == "component" || word == "resource") add_node(from, word == "resource");
    else if (word == "habit") set_habit(from);
    else if (word == "part") add_part(from);
    else if (word == "asks") add_request(from);
    else if (word == "mode") begin_mode(from);
    else if (word == "switch")
      g.switches.emplace_back(), from >> g.switches.back().first >> g.switches.back().second;
    else if (word == "switches") add_switch(from);
    else if (word == "skeleton") set_skeleton(from);
    else if (word == "sense") add_call(function::sense);
    else if (word == "process") add_call(function::process);
    else if (word == "act") add_call(function::act);
    else if (word == "in" || word == "optional") add_input(from, word == "optional");
    else if (word == "observe") add_observer(from);
    else if (word == "watch") add_watch(from);
    else if (word == "look") add_looks(from);
    else if (word == "exposed") add_second_name(from);
    else if (word == "out" || word == "maybe") add_output(from, word == "maybe");
    else if (word == "fault") g.calls.back().may_fault = true;
    else if (word == "wire") add_wire(from);
    else if (word == "feature") add_feature(from);
    else throw std::runtime_error("description: '" + text + "'");
    if (from.fail()) throw std::runtime_error("description: '" + text + "' lacks something");
  }

  // The first mode has all of them.
  graph whole() const {
    if (modes.empty()) return g;
    graph first = modes.front();
    first.modes = modes;
    first.modes.push_back(g);
    return first;
  }

private:
  graph header;  // what all modes have

  void add_node(std::istream& from, bool resource) {
    node& n = g.nodes.emplace_back();
    n.resource = resource;
    from >> n.path;
    n.when = read_strategy(from);
    n.does = [](firing&) {};
  }

  void set_habit(std::istream& from) {
    habit h;
    from >> h.id >> h.publishes >> h.origin >> h.fault_at;
    g.nodes.back().id = h.id;
    g.nodes.back().does = [h, m = memory{}](firing& f) mutable { respond(h, m, f); };
  }

  // After all nodes.
  void add_part(std::istream& from) {
    part& p = g.parts.emplace_back();
    from >> p.path >> p.stop_in >> p.start_in;
    if (p.stop_in < 0) p.stop_in = p.start_in = never;
    for (node& n : g.nodes)
      if (n.path == p.path || n.path.starts_with(p.path + "."))
        n.parts.push_back(static_cast<int>(g.parts.size()) - 1);
  }
  void add_request(std::istream& from) {
    std::string asking, asked, what;
    request r;
    from >> asking >> asked >> what >> r.salt;
    r.starts = what == "starts";
    for (std::size_t p = 0; p < g.parts.size(); ++p)
      if (g.parts[p].path == asked) r.part = static_cast<int>(p);
    for (node& n : g.nodes)
      if (n.path == asking && r.part >= 0) return n.asks.push_back(r);
    throw std::runtime_error("description: no part '" + asked + "', or no node '" + asking + "'");
  }

  void begin_mode(std::istream& from) {
    if (g.mode.empty()) header = g;
    else modes.push_back(g);
    g = header;
    from >> g.mode;
  }
  void add_switch(std::istream& from) {
    std::string asking, mode;
    int salt = 0;
    from >> asking >> mode >> salt;
    for (node& n : g.nodes)
      if (n.path == asking) return n.switches.emplace_back(mode, salt), void();
    throw std::runtime_error("description: no node '" + asking + "'");
  }

  void set_skeleton(std::istream& from) {
    node& n = g.nodes.back();
    from >> n.skeleton;
    n.does = skeleton(n.skeleton, from);
  }

  void add_call(function which) {
    call& t = g.calls.emplace_back();
    t.node = static_cast<int>(g.nodes.size()) - 1;
    t.which = which;
  }

  void add_input(std::istream& from, bool optional) {
    input& in = g.calls.back().inputs.emplace_back();
    in.optional = optional;
    from >> in.name >> in.width;
    in.initial.resize(in.width);
  }

  void add_output(std::istream& from, bool is_maybe) {
    output& out = g.calls.back().outputs.emplace_back();
    out.is_maybe = is_maybe;
    from >> out.name >> out.width;
  }

  void add_observer(std::istream& from) {
    observed& o = g.calls.back().patterns.emplace_back();
    from >> o.pattern;
    for (std::string word; from >> word;) {
      if (word == "delayed") from >> o.delay;
      if (word != "queue") continue;
      o.as.is = policy::queue;
      from >> o.as.capacity >> word;
      o.as.full = word == "drop_newest" ? when_full::drop_newest : when_full::drop_oldest;
    }
    from.clear();
  }

  void add_watch(std::istream& from) {
    node& n = g.nodes.emplace_back();
    from >> n.path;
    n.path = n.path == "-" ? "look" : n.path + ".look";
    n.does = [](firing&) {};
    add_call(function::look);
    add_observer(from);
  }
  void add_looks(std::istream& from) {
    for (std::int64_t beat; from >> beat;) g.looks.push_back(beat);
    from.clear();
  }

  void add_second_name(std::istream& from) {
    std::string second, own;
    from >> second >> own;
    g.second_names[own].push_back(second);
  }

  // A port by its path: call and place in it.
  template <class Ports>
  std::pair<int, int> find(const std::string& path, Ports ports) const {
    for (std::size_t t = 0; t < g.calls.size(); ++t)
      for (std::size_t i = 0; i < (g.calls[t].*ports).size(); ++i)
        if (g.nodes[g.calls[t].node].path + "." + (g.calls[t].*ports)[i].name == path)
          return {static_cast<int>(t), static_cast<int>(i)};
    throw std::runtime_error("description: no port '" + path + "'");
  }

  void add_feature(std::istream& from) {
    int count = 0;
    std::string name;
    from >> count >> std::ws;
    std::getline(from, name);
    g.features[name] += count;
  }

  void add_wire(std::istream& from) {
    std::string writer, reader, word;
    from >> writer >> reader >> word;
    const auto [t, i] = find(reader, &call::inputs);
    input& in = g.calls[t].inputs[i];
    if (in.wired() && !in.is_merged) throw std::runtime_error("description: two writers of '" + reader + "'");
    way& w = in.ways.emplace_back();
    std::tie(w.writer, w.port) = find(writer, &call::outputs);
    for (bool has_word = true; has_word; has_word = static_cast<bool>(from >> word)) {
      if (word == "delayed") {
        from >> w.delay;
      } else if (word == "queue" || word == "merged") {
        in.is = policy::queue;
        in.is_merged = word == "merged";
        from >> in.capacity >> word;
        in.full = word == "reject"        ? when_full::reject
                  : word == "drop_newest" ? when_full::drop_newest
                                          : when_full::drop_oldest;
      } else if (word == "initial") {
        for (double& coordinate : in.initial) from >> coordinate;
      }
    }
    from.clear();
  }
};

inline graph described(const std::string& text) {
  describer d;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) d.line(line);
  return d.whole();
}

}  // namespace semantics
