// The Semantics, slow and obvious: it keeps whole histories and reads them by the definitions of the text, in
// the order of the text. Nothing here depends on how the library works. Each definition is a virtual
// function, so that a mutant (mutants.cpp) can replace one of them by a wrong one.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "run_time_graph.hpp"

namespace semantics {

class interpreter {
public:
  explicit interpreter(graph what) : g(std::move(what)), modes(std::exchange(g.modes, {})) {}
  virtual ~interpreter() = default;

  graph g;                   // of several modes: the active one, with what has happened
  std::vector<graph> modes;  // as described; empty: there is one graph
  std::int64_t k = 0;
  bool faulted = false;
  log firings;
  std::int64_t published = 0;        // how many samples, so far
  std::map<int, std::int64_t> kept;  // of the user's strategies with a state, by their numbers

  // ---- time ----

  std::int64_t time() const { return k * g.period; }

  // ---- one beat: every sense, every component, every act; each decides whether it fires ----

  void beat() {
    if (faulted) return;
    if (k == 0) {
      look_up_patterns();
      for (graph& mode : modes) {
        std::swap(g, mode);
        look_up_patterns();
        std::swap(g, mode);
      }
    }
    if (std::count(g.looks.begin(), g.looks.end(), k) > 0) look_from_outside();
    for (std::size_t p = 0; p < g.parts.size(); ++p) {
      if (is_time(g.parts[p].stop_in)) set_part(p, true);
      if (is_time(g.parts[p].start_in)) set_part(p, false);
    }
    for (const auto& [beat, mode] : g.switches)
      if (is_time(beat)) {
        switch_to(mode);
        break;
      }
    begin();
    if (faulted) return on_fault();
    for (const function which : {function::sense, function::process, function::act}) {
      std::vector<bool> was_called(g.calls.size(), false);
      for (int next = next_call(which, was_called); next >= 0; next = next_call(which, was_called)) {
        was_called[next] = true;
        call& t = g.calls[next];
        if (!rests(t.node) && fires_now(t)) fire(t);
        if (faulted) return on_fault();
      }
    }
    ++k;
    take_requests();
    take_mode();
  }

  // What somebody outside asks for before a beat has effect in that beat.
  virtual bool is_time(std::int64_t beat) const { return beat == k; }

  // ---- a program looks, between two beats, at what graphs observe: each time is a firing. Without a queue a
  // sample is fresh if it came in the last beat. What several patterns name without a policy is seen once.
  // ----

  virtual void look_from_outside() {
    --k;  // the beat that has ended
    log all;
    std::set<std::tuple<int, bool, int>> without_policy;
    for (call& t : g.calls) {
      if (t.which != function::look) continue;
      t.last_fired = k - 1;
      for (input& in : t.inputs) {
        if (!has_policy(t) && !without_policy.insert(in.heard).second) continue;
        const seen_input seen = look(t, in);
        take_from_outside(in);
        ++in.reads;
        in.fresh_reads += seen.fresh;
        firing f;
        f.id = looker;
        f.which = function::look;
        f.beat = k + 1;
        f.inputs.push_back({in.name, seen.value, seen.origin, seen.fresh, true});
        all.push_back(f);
      }
    }
    all = in_order_of_content(all);
    firings.insert(firings.end(), all.begin(), all.end());
    ++k;
  }
  virtual void take_from_outside(input& in) const { take(in); }
  virtual bool has_policy(const call& look) const {
    return look.patterns[0].delay > 0 || look.patterns[0].as.is == policy::queue;
  }

  // ---- parts: a component runs if no part that has it is stopped ----

  virtual bool rests(int node) const {
    for (const int p : g.nodes[node].parts)
      if (g.parts[p].is_stopped) return true;
    return false;
  }

  virtual void set_part(std::size_t p, bool stops) {
    std::vector<bool> rested;
    for (std::size_t n = 0; n < g.nodes.size(); ++n) rested.push_back(rests(static_cast<int>(n)));
    g.parts[p].is_stopped = stops;
    for (std::size_t n = 0; n < g.nodes.size(); ++n)
      if (rested[n] && !rests(static_cast<int>(n))) start(static_cast<int>(n));
  }

  // When the next beat begins: of several requests in one beat the last one counts. A beat that ends by a
  // fault has none.
  virtual void ask(const request& r) { g.parts[r.part].asked = r.starts ? 1 : -1; }
  void take_requests() {
    for (std::size_t p = 0; p < g.parts.size(); ++p) {
      const int asked = std::exchange(g.parts[p].asked, 0);
      if (asked == 0 || g.parts[p].is_stopped == (asked < 0)) continue;
      ++g.parts[p].changes;
      set_part(p, asked < 0);
    }
  }

  // ---- modes: what several modes have is one component, which goes on; what a mode lacks is away ----

  // When the next beat begins; of several requests the later call's counts.
  std::string asked_mode;
  virtual void ask_for_mode(const std::string& mode) { asked_mode = mode; }
  virtual void take_mode() {
    if (const std::string mode = std::exchange(asked_mode, {}); !mode.empty()) {
      const std::string before = g.mode;
      switch_to(mode);
      g.switched += g.mode != before;
    }
  }

  std::map<std::string, std::function<void(firing&)>>
      habits;  // with their states, of all modes, by the paths
  virtual void switch_to(const std::string& mode) {
    const auto next =
        std::find_if(modes.begin(), modes.end(), [&](const graph& one) { return one.mode == mode; });
    if (mode == g.mode || next == modes.end()) return;
    for (const call& t : g.calls)
      for (const input& in : t.inputs) lost[name_of_queue(t, in)] = in.dropped;
    const graph last = std::exchange(g, *next);
    g.switched = last.switched;
    for (const node& n : last.nodes) habits[n.path] = n.does;
    for (node& n : g.nodes)
      if (const auto known = habits.find(n.path); known != habits.end()) n.does = known->second;
    for (const node& n : g.nodes) {
      const node* before = find_node(last, n.path);
      goes_on(before ? &before->when : nullptr, n.when);
    }
    for (part& p : g.parts)
      for (const part& before : last.parts)
        if (before.path == p.path) part_goes_on(before, p);
    for (call& t : g.calls) {
      const call* before = find_call(last, g.nodes[t.node].path, t.which);
      if (before && t.which != function::look) call_goes_on(*before, t);
      for (input& in : t.inputs) {
        begin_input(last, before, in, t.which == function::look);
        in.dropped = lost[name_of_queue(t, in)];
      }
    }
  }
  // What a queue has lost is counted as long as it is the same one, whichever modes come between.
  std::map<std::string, int> lost;
  std::string name_of_queue(const call& t, const input& in) const {
    if (in.is != policy::queue || !in.wired()) return {};
    std::ostringstream name;
    name << (t.which == function::look ? "" : g.nodes[t.node].path) << ' ' << static_cast<int>(t.which) << ' '
         << in.name << ' ' << in.capacity << ' ' << static_cast<int>(in.full) << ' ' << in.is_merged;
    if (!in.is_merged) name << ' ' << path_of(g, in.ways[0]) << ' ' << in.ways[0].delay;
    return name.str();
  }
  static const node* find_node(const graph& in, const std::string& path) {
    for (const node& n : in.nodes)
      if (n.path == path) return &n;
    return nullptr;
  }
  static const call* find_call(const graph& in, const std::string& path, function which) {
    for (const call& t : in.calls)
      if (t.which == which && in.nodes[t.node].path == path) return &t;
    return nullptr;
  }
  // A strategy that both modes state goes on, another one begins.
  void goes_on(const strategy* before, const strategy& s) {
    kept.erase(s.number);
    const bool is_same = before && before->is == s.is && before->n == s.n && before->phase == s.phase &&
                         before->names == s.names && before->parts.size() == s.parts.size();
    if (is_same && kept.count(before->number) > 0) kept[s.number] = kept[before->number];
    for (std::size_t i = 0; i < s.parts.size(); ++i)
      goes_on(is_same ? &before->parts[i] : nullptr, s.parts[i]);
  }
  virtual void part_goes_on(const part& before, part& p) {
    p.is_stopped = before.is_stopped;
    p.changes = before.changes;
  }
  // What it published is seen by its readers, in whichever mode it was.
  virtual void call_goes_on(const call& before, call& t) {
    t.last_fired = before.last_fired;
    t.oldest_seen = before.oldest_seen;
    t.is_new = before.is_new;
    t.firings = before.firings;
    for (std::size_t i = 0; i < t.outputs.size(); ++i) t.outputs[i].history = before.outputs[i].history;
  }
  // A queue is kept if both modes have it, with what is on its way; else it begins empty.
  void begin_input(const graph& last, const call* before, input& in, bool is_look) {
    const input* same = nullptr;
    for (const call& t : last.calls)
      for (const input& one : t.inputs)
        if ((is_look ? t.which == function::look : &t == before) && one.is_heard == in.is_heard &&
            one.name == in.name && is_same_queue(last, one, in))
          same = &one;
    if (before && !is_look)
      for (const input& one : before->inputs)
        if (one.name == in.name) in.reads = one.reads, in.fresh_reads = one.fresh_reads;
    for (way& w : in.ways) {
      w.since = k;
      for (const way& old : same ? same->ways : std::vector<way>())
        if (path_of(last, old) == path_of(g, w) && old.delay == w.delay) w.since = old.since;
    }
    if (same) queue_goes_on(*same, in);
  }
  static std::string path_of(const graph& in, const way& w) {
    const call& t = in.calls[w.writer];
    return in.nodes[t.node].path + "." + t.outputs[w.port].name;
  }
  virtual bool is_same_queue(const graph& last, const input& a, const input& b) const {
    if (a.is != policy::queue || b.is != policy::queue || !a.wired() || !b.wired()) return false;
    if (a.is_merged != b.is_merged || a.capacity != b.capacity || a.full != b.full) return false;
    return b.is_merged ||
           (path_of(last, a.ways[0]) == path_of(g, b.ways[0]) && a.ways[0].delay == b.ways[0].delay);
  }
  virtual void queue_goes_on(const input& before, input& in) {
    in.waiting = before.waiting;
    in.taken = before.taken;
    in.arrived_in = before.arrived_in;
    in.arrivals = before.arrivals;
    in.ways_taken = before.ways_taken;
  }

  virtual bool fires_now(call& t) { return fires(when(t), t); }

  // Delayed samples enter their queues, in the order in which they were published.
  virtual void begin() {
    for (call& t : g.calls)
      for (input& in : t.inputs) {
        if (in.is != policy::queue) continue;
        std::vector<publication> arrived;
        for (std::size_t w = 0; w < in.ways.size(); ++w)
          for (const publication& p : history(in.ways[w]))
            if (in.ways[w].delay > 0 && arrival(in.ways[w], p) == k && p.beat >= in.ways[w].since) {
              arrived.push_back(p);
              arrived.back().way = static_cast<int>(w);
              arrived.back().closed_loop = closes_loop(t, in.ways[w]);
            }
        std::sort(arrived.begin(), arrived.end(),
                  [this](const publication& a, const publication& b) { return comes_before(a, b); });
        for (const publication& p : arrived) enter(in, p);
      }
  }
  virtual bool comes_before(const publication& a, const publication& b) const {
    return std::pair(a.number, a.way) < std::pair(b.number, b.way);
  }

  // ---- scopes: a pattern is looked up in the graph in which it stands, then in the graphs around it ----

  using words = std::vector<std::string>;
  static words split(const std::string& path) {
    words all;
    std::istringstream from(path);
    for (std::string one; std::getline(from, one, '.');) all.push_back(one);
    return all;
  }

  // `*` is exactly one name, `**` any number of names, none included.
  virtual bool matches(const words& pattern, const words& path) const {
    if (pattern.empty()) return path.empty();
    const words rest(pattern.begin() + 1, pattern.end());
    if (pattern[0] != "**")
      return !path.empty() && (pattern[0] == "*" || pattern[0] == path[0]) &&
             matches(rest, words(path.begin() + 1, path.end()));
    for (std::size_t skipped = 0; skipped <= path.size(); ++skipped)
      if (matches(rest, words(path.begin() + static_cast<std::ptrdiff_t>(skipped), path.end()))) return true;
    return false;
  }

  // The paths of the graphs in which a pattern is looked up, one after the other.
  virtual std::vector<words> graphs_for(const std::string& pattern, const std::string& node) const {
    if (pattern[0] == '/') return {words()};
    std::vector<words> graphs;
    for (words graph = split(node); !graph.empty();) {
      graph.pop_back();
      graphs.push_back(graph);
    }
    return graphs;
  }

  // The name under which a port is heard: its own, or another one; empty: the pattern does not name it.
  std::string heard_as(const words& pattern, const words& graph, const std::string& own) const {
    std::vector<std::string> names{own};
    if (const auto more = g.second_names.find(own); more != g.second_names.end())
      names.insert(names.end(), more->second.begin(), more->second.end());
    for (const std::string& name : names) {
      const words path = split(name);
      if (path.size() < graph.size() || !std::equal(graph.begin(), graph.end(), path.begin())) continue;
      if (matches(pattern, words(path.begin() + static_cast<std::ptrdiff_t>(graph.size()), path.end())))
        return name;
    }
    return {};
  }

  // Outputs, and with `**` at the end also the wired inputs.
  virtual bool names_inputs(const words& pattern) const { return pattern.back() == "**"; }
  std::vector<input> heard_in(const words& graph, const observed& o, std::size_t observer) const {
    const words pattern = split(o.pattern[0] == '/' ? o.pattern.substr(1) : o.pattern);
    std::vector<input> all;
    for (std::size_t t = 0; t < g.calls.size(); ++t) {
      if (t == observer) continue;
      const std::string node = g.nodes[g.calls[t].node].path + ".";
      for (std::size_t p = 0; p < g.calls[t].outputs.size(); ++p) {
        const output& out = g.calls[t].outputs[p];
        input in = o.as;
        in.name = heard_as(pattern, graph, node + out.name);
        in.width = out.width;
        in.initial.resize(static_cast<std::size_t>(out.width));
        in.ways = {{static_cast<int>(t), static_cast<int>(p), o.delay}};
        in.heard = {static_cast<int>(t), false, static_cast<int>(p)};
        if (!in.name.empty()) all.push_back(in);
      }
      if (!names_inputs(pattern)) continue;
      for (std::size_t i = 0; i < g.calls[t].inputs.size(); ++i) {
        input in = g.calls[t].inputs[i];
        if (!in.wired() || in.is_heard) continue;
        const auto call = static_cast<int>(t), number = static_cast<int>(i);
        if (in.is == policy::queue && o.delay == 0) in.shown_call = call, in.shown_input = number;
        if (in.is == policy::queue && o.delay > 0) in.ways = {{call, number, 0, true}};
        in.is = policy::latest;
        in.heard = {static_cast<int>(t), true, static_cast<int>(i)};
        in.name = heard_as(pattern, graph, node + in.name);
        for (way& w : in.ways) w.delay += o.delay;
        if (!in.name.empty()) all.push_back(in);
      }
    }
    return all;
  }

  // In the order of their paths: the text leaves open which.
  void look_up_patterns() {
    for (std::size_t t = 0; t < g.calls.size(); ++t)
      for (const observed& o : g.calls[t].patterns)
        for (const words& graph : graphs_for(o.pattern, g.nodes[g.calls[t].node].path)) {
          std::vector<input> heard = heard_in(graph, o, t);
          std::sort(heard.begin(), heard.end(),
                    [](const input& a, const input& b) { return a.name < b.name; });
          for (input& in : heard) {
            in.is_heard = true;
            g.calls[t].inputs.push_back(in);
          }
          if (!heard.empty()) break;
        }
  }

  // Nothing that has arrived is fresh, and its strategy begins anew.
  virtual void start(int started) {
    forget(g.nodes[started].when);
    for (call& t : g.calls)
      if (t.node == started) {
        t.last_fired = k - 1;
        t.is_new = true;
      }
  }

  void forget(const strategy& s) {
    kept.erase(s.number);
    for (const strategy& part : s.parts) forget(part);
  }

  // Its predecessors, over wires without delay, have all been called.
  bool is_ready(const call& t, const std::vector<bool>& was_called) const {
    for (const input& in : t.inputs)
      for (const way& w : in.ways)
        if (w.delay == 0 && g.calls[w.writer].which == t.which && !was_called[w.writer]) return false;
    return true;
  }

  // The first declared whose predecessors, over wires without delay, have all been called.
  virtual int next_call(function which, const std::vector<bool>& was_called) const {
    for (std::size_t i = 0; i < g.calls.size(); ++i) {
      if (g.calls[i].which != which || was_called[i]) continue;
      if (is_ready(g.calls[i], was_called)) return static_cast<int>(i);
    }
    return -1;
  }

  void fire(call& t) {
    firing f;
    f.id = g.nodes[t.node].id;
    f.which = t.which;
    f.beat = k;
    f.time = time();
    f.dt = dt(t);
    f.may_fault = t.may_fault;
    std::vector<seen_input> seen_inputs;
    for (input& in : t.inputs) {
      seen_inputs.push_back(look(t, in));
      take(in);
      ++in.reads;
      in.fresh_reads += seen_inputs.back().fresh;
      f.inputs.push_back({in.name, seen_inputs.back().value, seen_inputs.back().origin,
                          seen_inputs.back().fresh, in.wired(), in.is_heard ? 0 : in.dropped});
    }
    for (const output& out : t.outputs) f.outputs.push_back({std::vector<double>(out.width), out.is_maybe});

    does(g.nodes[t.node], f);
    if (g.nodes[t.node].skeleton.empty()) firings.push_back(f);

    const std::int64_t from = origin(t, seen_inputs);
    t.last_fired = k;
    t.is_new = false;
    t.oldest_seen = oldest(t, seen_inputs);
    ++t.firings;
    if (f.fault) faulted = true;
    for (const request& r : g.nodes[t.node].asks)
      if (wants(g.nodes[t.node].id, k, r.salt)) ask(r);
    for (const auto& [mode, salt] : g.nodes[t.node].switches)
      if (wants(g.nodes[t.node].id, k, salt)) ask_for_mode(mode);
    for (std::size_t i = 0; i < t.outputs.size() && !faulted; ++i)
      if (f.outputs[i].published)
        publish(t, i, {k, f.outputs[i].value, stamp(f.outputs[i], from), published++});
  }

  virtual void does(node& n, firing& f) { n.does(f); }

  // Seconds since it last fired; the first time N beats for timed<N>, else one.
  virtual double dt(const call& t) const {
    const strategy own = when(t);
    const strategy s = own.is == strategy::stoppable ? own.parts[0] : own;
    const std::int64_t beats = !t.is_new ? k - t.last_fired : s.is == strategy::timed ? s.n : 1;
    return static_cast<double>(beats * g.period) / 1e9;
  }

  void publish(call& writer, std::size_t port, const publication& p) {
    writer.outputs[port].history.push_back(p);
    for (call& t : g.calls)
      for (input& in : t.inputs)
        for (std::size_t w = 0; w < in.ways.size(); ++w)
          if (in.is == policy::queue && &g.calls[in.ways[w].writer] == &writer &&
              in.ways[w].port == static_cast<int>(port) && enters_at_once(in.ways[w])) {
            publication one = p;
            one.way = static_cast<int>(w);
            one.closed_loop = closes_loop(t, in.ways[w]);
            enter(in, one);
          }
  }
  virtual bool enters_at_once(const way& w) const { return w.delay == 0; }

  // Into a queue, in this beat.
  virtual void enter(input& in, const publication& p) {
    if (in.arrived_in != k) in.arrivals = 0;
    in.arrived_in = k;
    ++in.arrivals;
    push(in, p);
  }

  // ---- what an input sees ----

  const std::vector<publication>& history(const way& w) const {
    const call& writer = g.calls[w.writer];
    return w.is_taken ? writer.inputs[w.port].all_taken : writer.outputs[w.port].history;
  }

  // A sample published in beat j arrives in beat j, or, delayed<N>, when beat j + N begins.
  virtual std::int64_t arrival(const way& w, const publication& p) const { return p.beat + w.delay; }

  // The newest that has arrived; none: nothing has come yet.
  virtual const publication* newest(const input& in) const {
    const publication* found = nullptr;
    for (const publication& p : history(in.ways[0]))
      if (arrival(in.ways[0], p) <= k) found = &p;
    return found;
  }

  virtual void push(input& in, const publication& p) {
    if (in.waiting.size() < in.capacity) return in.waiting.push_back(p);
    ++in.dropped;
    if (in.full == when_full::reject) faulted = true;
    if (in.full != when_full::drop_oldest) return;
    in.waiting.pop_front();
    in.waiting.push_back(p);
  }

  // The oldest waiting sample; if there is none, what it took last.
  virtual const publication* head(const input& in) const {
    if (!in.waiting.empty()) return &in.waiting.front();
    return in.taken ? &*in.taken : nullptr;
  }

  virtual void take(input& in) const {
    if (in.is != policy::queue || in.waiting.empty()) return;
    in.ways_taken |= 1 << in.waiting.front().way;
    in.taken = in.waiting.front();
    in.waiting.pop_front();
    in.all_taken.push_back(*in.taken);
    in.all_taken.back().beat = k;
  }

  virtual seen_input look(const call& t, const input& in) const {
    seen_input s;
    s.value = in.initial;
    if (!in.wired()) return s;
    if (in.shown_call >= 0) return look(t, g.calls[in.shown_call].inputs[in.shown_input]);
    const publication* p = in.is == policy::queue ? head(in) : newest(in);
    if (p) s = {p->value, p->origin, true, false, in.is == policy::queue ? p->way : 0, p->closed_loop};
    s.fresh = fresh(t, in);
    return s;
  }

  // ---- fresh ----

  virtual bool fresh(const call& t, const input& in) const {
    if (!in.wired()) return false;
    if (in.shown_call >= 0) return fresh(t, g.calls[in.shown_call].inputs[in.shown_input]);
    if (in.is == policy::queue) return !in.waiting.empty();
    for (const publication& p : history(in.ways[0]))
      if (arrival(in.ways[0], p) <= k && arrival(in.ways[0], p) > t.last_fired) return true;
    return false;
  }

  // How many samples wait in its queue; without one: 1 if it is fresh.
  virtual int waiting(const call& t, const input& in) const {
    return in.is == policy::queue ? static_cast<int>(in.waiting.size()) : fresh(t, in);
  }
  // How many samples have arrived in this beat.
  virtual int arrivals(const input& in) const {
    if (in.is == policy::queue) return in.arrived_in == k ? in.arrivals : 0;
    int count = 0;
    for (const way& w : in.ways)
      for (const publication& p : history(w)) count += arrival(w, p) == k;
    return count;
  }

  // ---- when a component fires ----

  virtual strategy when(const call& t) const {
    const strategy& s = g.nodes[t.node].when;
    if (s.is != strategy::by_default) return s;
    strategy d;
    d.is = t.which == function::process && !t.inputs.empty() ? strategy::restless : strategy::timed;
    return d;
  }

  virtual bool fires(const strategy& s, const call& t) {
    switch (s.is) {
      case strategy::by_default:
        return false;  // see `when`
      case strategy::timed:
        return (k - s.phase) % s.n == 0;
      case strategy::restless:
        for (const input& in : t.inputs)
          if (fresh(t, in)) return true;
        return false;
      case strategy::moderate:
        for (const input& in : t.inputs)
          if (in.wired() && !fresh(t, in)) return false;
        return true;
      case strategy::timeout:
        return k - std::max<std::int64_t>(t.last_fired + (t.is_new ? 1 : 0), 0) >= s.n;
      case strategy::port_triggered:
        for (const std::string& name : s.names)
          if (fresh(t, named(t, name))) return true;
        return false;
      case strategy::coordinated:
        return coordinated(t);
      case strategy::full_speed:
        return true;
      case strategy::inactive:
        return false;
      case strategy::any_of: {  // all parts are asked: some have a state
        bool any = false;
        for (const strategy& part : s.parts) any = fires(part, t) || any;
        return any;
      }
      case strategy::all_of: {
        bool all = true;
        for (const strategy& part : s.parts) all = fires(part, t) && all;
        return all;
      }
      case strategy::stoppable:
        return fires(s.parts[0], t);
      case strategy::user:
        return user_fires(s, t);
    }
    return false;
  }

  // Every input holds a sample that arrived, all of one time of origin, later than the oldest seen at the
  // last firing.
  virtual bool coordinated(const call& t) const {
    std::optional<std::int64_t> shared;
    for (const input& in : t.inputs) {
      if (!in.wired()) continue;
      const seen_input s = look(t, in);
      if (!s.arrived) return false;
      if (shared && *shared != s.origin) return false;
      shared = s.origin;
    }
    return shared && *shared > t.oldest_seen;
  }

  // An initial value is older than any sample.
  virtual std::int64_t oldest(const call& t, const std::vector<seen_input>& seen_inputs) const {
    std::optional<std::int64_t> found;
    for (std::size_t i = 0; i < seen_inputs.size(); ++i)
      if (t.inputs[i].wired())
        found = found ? std::min(*found, seen_inputs[i].origin) : seen_inputs[i].origin;
    return found.value_or(never);
  }

  const input& named(const call& t, const std::string& name) const {
    return *std::find_if(t.inputs.begin(), t.inputs.end(), [&](const input& in) { return in.name == name; });
  }

  // The strategies of the user's own in probe.hpp: they look at the beat, and at freshness, origin and value
  // of an input, or at how many samples wait there or arrive. One keeps a state.
  virtual bool user_fires(const strategy& s, const call& t) {
    const std::string& kind = s.names[0];
    if (kind == "every_nth") {
      std::int64_t& come = kept[s.number];
      come += arrivals(named(t, s.names[1]));
      if (come < s.n) return false;
      come -= s.n;
      return true;
    }
    if (kind == "while_waiting") return waiting(t, named(t, s.names[1])) >= s.n;
    if (kind == "on_beats") return k % s.n == s.phase || k % 7 == 0;
    if (kind == "patient") return dt(t) * 1e6 > static_cast<double>(s.n);
    const seen_input x = look(t, named(t, s.names[1]));
    if (kind == "above") return x.value[0] > static_cast<double>(s.n) * 0.25;
    if (kind == "older") return x.origin == never || time() - x.origin > s.n;
    return x.fresh && k % 2 == 1;  // fresh_on_odd
  }

  // ---- time of origin ----

  virtual std::int64_t origin(const call& t, const std::vector<seen_input>& seen_inputs) const {
    if (t.which == function::sense) return time();
    std::optional<std::int64_t> found;
    for (std::size_t i = 0; i < seen_inputs.size(); ++i)
      if (counts(t, t.inputs[i], seen_inputs[i]))
        found = found ? std::min(*found, seen_inputs[i].origin) : seen_inputs[i].origin;
    return found.value_or(time());
  }

  // Unless the component sets it.
  virtual std::int64_t stamp(const recorded_output& t, std::int64_t from) const {
    return t.sets_origin ? t.origin : from;
  }

  virtual bool counts(const call& t, const input& in, const seen_input& s) const {
    if (!in.wired() || !s.arrived) return false;
    if (in.is_merged && !in.is_heard) return !s.closed_loop;
    return !closes_loop(t, way_of(in, s));
  }
  static const way& way_of(const input& in, const seen_input& s) {
    return in.ways[std::min(static_cast<std::size_t>(s.way), in.ways.size() - 1)];
  }
  bool closes_loop(const call& t, const way& by) const {
    return by.delay > 0 && feeds(t.node, g.calls[by.writer].node);
  }

  // Over any wires; a node feeds itself only if a wire leads back to it. A resource node is one node.
  virtual bool feeds(int from, int to) const {
    std::vector<bool> reached(g.nodes.size(), false);
    for (bool grown = true; grown;) {
      grown = false;
      for (const call& t : g.calls)
        for (const input& in : t.inputs)
          for (const way& w : in.ways) {
            const int writer = g.calls[w.writer].node;
            if (reached[t.node] || (writer != from && !reached[writer])) continue;
            reached[t.node] = grown = true;
          }
    }
    return reached[to];
  }

  // ---- faults: every resource node's on_fault, in the same beat ----

  virtual void on_fault() {
    for (const node& n : g.nodes) {
      if (!n.resource) continue;
      firing f;
      f.id = n.id;
      f.which = function::on_fault;
      firings.push_back(f);
    }
  }
};

}  // namespace semantics
