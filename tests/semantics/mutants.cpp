#include "mutants.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace semantics {

namespace mutants {
namespace {

template <class Mutant>
std::unique_ptr<interpreter> made(graph g) {
  return std::make_unique<Mutant>(std::move(g));
}

using base = interpreter;

// ---- one beat ----

struct last_declared_first : base {
  using base::base;
  int next_call(function which, const std::vector<bool>& had) const override {
    for (std::size_t i = g.calls.size(); i-- > 0;) {
      if (g.calls[i].which != which || had[i]) continue;
      if (is_ready(g.calls[i], had)) return static_cast<int>(i);
    }
    return -1;
  }
};

struct declared_order : base {
  using base::base;
  int next_call(function which, const std::vector<bool>& had) const override {
    for (std::size_t i = 0; i < g.calls.size(); ++i)
      if (g.calls[i].which == which && !had[i]) return static_cast<int>(i);
    return -1;
  }
};

struct first_dt_is_one_beat : base {
  using base::base;
  double dt(const call& t) const override {
    return t.last_fired == never ? static_cast<double>(g.period) / 1e9 : base::dt(t);
  }
};

struct dt_is_always_one_beat : base {
  using base::base;
  double dt(const call&) const override { return static_cast<double>(g.period) / 1e9; }
};

// ---- scopes ----

struct looked_up_from_the_outside : base {
  using base::base;
  std::vector<words> graphs_for(const std::string& pattern, const std::string& node) const override {
    auto graphs = base::graphs_for(pattern, node);
    std::reverse(graphs.begin(), graphs.end());
    return graphs;
  }
};

struct looked_up_in_its_graph_alone : base {
  using base::base;
  std::vector<words> graphs_for(const std::string& pattern, const std::string& node) const override {
    return {base::graphs_for(pattern, node)[0]};
  }
};

struct star_is_any_number : base {
  using base::base;
  bool matches(const words& pattern, const words& path) const override {
    words any = pattern;
    std::replace(any.begin(), any.end(), std::string("*"), std::string("**"));
    return base::matches(any, path);
  }
};

struct no_inputs_are_named : base {
  using base::base;
  bool names_inputs(const words&) const override { return false; }
};

// What was taken counts as taken again in each firing that finds the queue empty.
struct taken_is_heard_again : base {
  using base::base;
  void take(input& in) const override {
    const bool is_empty = in.waiting.empty();
    base::take(in);
    if (!is_empty || !in.taken) return;
    in.all_taken.push_back(*in.taken);
    in.all_taken.back().beat = k;
  }
};

// As if it were heard when it was published.
struct queued_is_heard_when_published : base {
  using base::base;
  const publication* newest(const input& in) const override {
    if (!in.ways[0].is_taken) return base::newest(in);
    input as_it_came = g.calls[in.ways[0].writer].inputs[in.ways[0].port];
    for (way& w : as_it_came.ways) w.delay += in.ways[0].delay;
    return base::newest(as_it_came);
  }
};

// ---- stopped and started ----

struct fires_although_stopped : base {
  using base::base;
  bool rests(int) const override { return false; }
};

// Of a component that is a part itself the flag of its own counts, of one in a part nothing.
struct inner_graphs_do_not_stop : base {
  using base::base;
  bool rests(int node) const override {
    for (const int p : g.nodes[node].parts)
      if (g.parts[p].is_stopped && g.parts[p].path == g.nodes[node].path) return true;
    return false;
  }
};

// A part that starts takes along those in it that were stopped on their own.
struct starts_what_is_inside : base {
  using base::base;
  void set_part(std::size_t p, bool stops) override {
    base::set_part(p, stops);
    if (stops) return;
    for (std::size_t inner = 0; inner < g.parts.size(); ++inner)
      if (g.parts[inner].is_stopped && g.parts[inner].path.starts_with(g.parts[p].path + "."))
        base::set_part(inner, false);
  }
};

struct requests_at_once : base {
  using base::base;
  void ask(const request& r) override { set_part(static_cast<std::size_t>(r.part), !r.starts); }
};

struct first_request_counts : base {
  using base::base;
  void ask(const request& r) override {
    if (g.parts[r.part].asked == 0) base::ask(r);
  }
};

struct requests_are_lost : base {
  using base::base;
  void ask(const request&) override {}
};

struct fresh_after_the_start : base {
  using base::base;
  void start(int node) override {
    std::vector<std::int64_t> fired;
    for (const call& t : g.calls) fired.push_back(t.last_fired);
    base::start(node);
    for (std::size_t i = 0; i < fired.size(); ++i) g.calls[i].last_fired = fired[i];
  }
};

struct dt_counts_the_rest : base {
  using base::base;
  void start(int node) override {
    std::vector<bool> is_new;
    for (const call& t : g.calls) is_new.push_back(t.is_new);
    base::start(node);
    for (std::size_t i = 0; i < is_new.size(); ++i) g.calls[i].is_new = is_new[i];
  }
};

// ---- asked for from outside ----

struct from_outside_a_beat_late : base {
  using base::base;
  bool is_time(std::int64_t beat) const override { return beat + 1 == k; }
};

struct from_outside_nothing : base {
  using base::base;
  bool is_time(std::int64_t) const override { return false; }
};

struct program_sees_the_newest : base {
  using base::base;
  seen_input look(const call& t, const input& in) const override {
    if (t.which != function::look) return base::look(t, in);
    input newest = in;
    newest.is = policy::latest;
    newest.ways[0].delay = 0;
    return base::look(t, newest);
  }
};

struct program_takes_nothing : base {
  using base::base;
  void take_from_outside(input&) const override {}
};

// ---- modes ----

struct switch_a_beat_late : base {
  using base::base;
  std::string waiting_mode;
  void take_mode() override {
    std::swap(waiting_mode, asked_mode);
    base::take_mode();
  }
};

struct first_mode_asked_for : base {
  using base::base;
  void ask_for_mode(const std::string& mode) override {
    if (asked_mode.empty()) base::ask_for_mode(mode);
  }
};

struct components_do_not_switch : base {
  using base::base;
  void ask_for_mode(const std::string&) override {}
};

struct all_begins_anew : base {
  using base::base;
  void call_goes_on(const call& before, call& t) override {
    const call as_new = t;
    base::call_goes_on(before, t);
    t.last_fired = as_new.last_fired;
    t.oldest_seen = as_new.oldest_seen;
    t.is_new = as_new.is_new;
  }
};

struct outputs_begin_anew : base {
  using base::base;
  void call_goes_on(const call& before, call& t) override {
    base::call_goes_on(before, t);
    for (output& out : t.outputs) out.history.clear();
  }
};

// What it was when it went away is what it is when it comes.
template <void (*Change)(const call& when_it_went, call& t)>
struct as_it_went : base {
  using base::base;
  std::map<std::pair<std::string, function>, call> gone;
  void switch_to(const std::string& mode) override {
    std::vector<std::string> had;
    for (const call& t : g.calls) gone[{g.nodes[t.node].path, t.which}] = t;
    for (const node& n : g.nodes) had.push_back(n.path);
    base::switch_to(mode);
    for (call& t : g.calls) {
      const std::string& path = g.nodes[t.node].path;
      if (std::find(had.begin(), had.end(), path) != had.end() || t.which == function::look) continue;
      if (const auto known = gone.find({path, t.which}); known != gone.end()) Change(known->second, t);
    }
  }
};
void its_firings(const call& when_it_went, call& t) {
  t.last_fired = when_it_went.last_fired;
  t.is_new = when_it_went.is_new;
}
void its_samples(const call& when_it_went, call& t) {
  for (std::size_t i = 0; i < t.outputs.size(); ++i) t.outputs[i].history = when_it_went.outputs[i].history;
}

struct what_a_mode_lacks_is_forgotten : base {
  using base::base;
  void switch_to(const std::string& mode) override {
    std::erase_if(habits, [&](const auto& one) { return !find_node(g, one.first); });
    base::switch_to(mode);
  }
};

struct no_queue_outlives_a_switch : base {
  using base::base;
  bool is_same_queue(const graph&, const input&, const input&) const override { return false; }
};

struct each_queue_outlives_a_switch : base {
  using base::base;
  bool is_same_queue(const graph&, const input& a, const input& b) const override {
    return a.is == policy::queue && b.is == policy::queue && a.ways.size() == b.ways.size();
  }
};

struct comes_into_a_new_queue : base {
  using base::base;
  void switch_to(const std::string& mode) override {
    base::switch_to(mode);
    for (call& t : g.calls)
      for (input& in : t.inputs)
        for (way& w : in.ways) w.since = 0;
  }
};

// The beats in which what it looks at arrives, had it always been so: for timed and full_speed, and for
// restless, moderate and port_triggered if all inputs that they look at have the same such clock.
struct by_clock_after_a_switch : base {
  using base::base;
  struct clock {
    std::int64_t period, first;
    bool operator==(const clock&) const = default;
  };
  std::optional<clock> clock_of(const call& t, int depth = 0) const {
    const strategy whole = when(t);
    const strategy& s = whole.is == strategy::stoppable ? whole.parts[0] : whole;
    if (s.is == strategy::timed) return clock{s.n, (s.phase % s.n + s.n) % s.n};
    if (s.is == strategy::full_speed) return clock{1, 0};
    const bool by_names = s.is == strategy::port_triggered;
    if (!by_names && s.is != strategy::restless && s.is != strategy::moderate) return {};
    std::optional<clock> shared;
    for (const input& in : t.inputs) {
      if (!in.wired() || (by_names && std::find(s.names.begin(), s.names.end(), in.name) == s.names.end()))
        continue;
      if (in.is == policy::queue || in.is_heard || depth > 20) return {};
      const call& writer = g.calls[in.ways[0].writer];
      if (writer.outputs[in.ways[0].port].is_maybe || !g.nodes[writer.node].parts.empty()) return {};
      auto its = clock_of(writer, depth + 1);
      if (!its) return {};
      its->first += in.ways[0].delay;
      if (shared && !(*shared == *its)) return {};
      shared = its;
    }
    return shared;
  }
  bool fires_now(call& t) override {
    if (const auto known = clock_of(t)) return k >= known->first && (k - known->first) % known->period == 0;
    return base::fires_now(t);
  }
};

struct parts_start_at_a_switch : base {
  using base::base;
  void part_goes_on(const part& before, part& p) override { p.changes = before.changes; }
};

// ---- what an input sees ----

struct delayed_one_too_long : base {
  using base::base;
  std::int64_t arrival(const way& w, const publication& p) const override {
    return base::arrival(w, p) + (w.delay > 0);
  }
};

struct delayed_one_too_short : base {
  using base::base;
  std::int64_t arrival(const way& w, const publication& p) const override {
    return base::arrival(w, p) - (w.delay > 1);
  }
};

struct latest_is_of_the_beat_before : base {
  using base::base;
  std::int64_t arrival(const way& w, const publication& p) const override {
    return base::arrival(w, p) + (w.delay == 0);
  }
};

struct oldest_instead_of_newest : base {
  using base::base;
  const publication* newest(const input& in) const override {
    return base::newest(in) ? &history(in.ways[0]).front() : nullptr;
  }
};

struct queue_one_longer : base {
  using base::base;
  void push(input& in, const publication& p) override {
    ++in.capacity;
    base::push(in, p);
    --in.capacity;
  }
};

template <when_full From, when_full To>
struct full_queue_mixed_up : base {
  using base::base;
  void push(input& in, const publication& p) override {
    const when_full was = in.full;
    if (was == From) in.full = To;
    base::push(in, p);
    in.full = was;
  }
};

struct last_in_first_out : base {
  using base::base;
  const publication* head(const input& in) const override {
    return in.waiting.empty() ? base::head(in) : &in.waiting.back();
  }
  void take(input& in) const override {
    if (in.is != policy::queue || in.waiting.empty()) return;
    in.taken = in.waiting.back();
    in.waiting.pop_back();
  }
};

struct empty_queue_forgets : base {
  using base::base;
  const publication* head(const input& in) const override {
    return in.waiting.empty() ? nullptr : &in.waiting.front();
  }
};

struct queue_takes_all : base {
  using base::base;
  void take(input& in) const override {
    base::take(in);
    in.waiting.clear();
  }
};

// ---- delayed and merged ----

// Right away, as if the wire had no delay.
struct delayed_enters_when_published : base {
  using base::base;
  bool enters_at_once(const way&) const override { return true; }
  void begin() override {}
};

struct delayed_enters_one_late : base {
  using base::base;
  std::int64_t arrival(const way& w, const publication& p) const override {
    return base::arrival(w, p) + (w.delay > 0 && is_into_queue(w));
  }
  bool is_into_queue(const way& w) const {
    for (const call& t : g.calls)
      for (const input& in : t.inputs)
        if (!in.ways.empty() && &in.ways.front() <= &w && &w <= &in.ways.back())
          return in.is == policy::queue;
    return false;
  }
};

// After what is published in the beat.
struct delayed_enters_after_the_others : base {
  using base::base;
  void enter(input& in, const publication& p) override {
    const bool is_delayed = in.ways[static_cast<std::size_t>(p.way)].delay > 0;
    std::deque<publication> later;
    while (!is_delayed && !in.waiting.empty() && is_late(in, in.waiting.back())) {
      later.push_front(in.waiting.back());
      in.waiting.pop_back();
    }
    base::enter(in, p);
    in.waiting.insert(in.waiting.end(), later.begin(), later.end());
  }
  // It has arrived in this beat over a delayed wire.
  bool is_late(const input& in, const publication& p) const {
    const way& by = in.ways[static_cast<std::size_t>(p.way)];
    return by.delay > 0 && arrival(by, p) == k;
  }
};

struct merged_by_delay : base {
  using base::base;
  bool comes_before(const publication& a, const publication& b) const override {
    return std::pair(-a.number, a.way) < std::pair(-b.number, b.way);
  }
};

struct merged_hears_the_first_wire_only : base {
  using base::base;
  void enter(input& in, const publication& p) override {
    if (p.way == 0) base::enter(in, p);
  }
};

// The way of a sample counts, not the input: here that of the first wire.
struct merged_counts_as_its_first_wire : base {
  using base::base;
  bool counts(const call& t, const input& in, const seen_input& s) const override {
    seen_input first = s;
    first.way = 0;
    if (in.is_merged) first.closed_loop = closes_loop(t, in.ways[0]);
    return base::counts(t, in, first);
  }
};

// ---- strategies that see more ----

struct nothing_waits : base {
  using base::base;
  int waiting(const call& t, const input& in) const override { return fresh(t, in); }
};

struct arrivals_are_freshness : base {
  using base::base;
  int arrivals(const input& in) const override { return base::arrivals(in) > 0; }
};

struct no_state : base {
  using base::base;
  bool user_fires(const strategy& s, const call& t) override {
    kept.clear();
    return base::user_fires(s, t);
  }
};

// Only while the others leave it open.
struct not_always_asked : base {
  using base::base;
  bool fires(const strategy& s, const call& t) override {
    if (s.is != strategy::any_of) return base::fires(s, t);
    for (const strategy& part : s.parts)
      if (fires(part, t)) return true;
    return false;
  }
};

struct state_outlives_the_stop : base {
  using base::base;
  void start(int node) override {
    const auto before = kept;
    base::start(node);
    kept = before;
  }
};

// ---- fresh ----

struct fresh_also_in_the_beat_of_the_last_firing : base {
  using base::base;
  bool fresh(const call& t, const input& in) const override {
    call earlier = t;
    if (t.last_fired != never) --earlier.last_fired;
    return base::fresh(earlier, in);
  }
};

struct fresh_when_published : base {
  using base::base;
  bool fresh(const call& t, const input& in) const override {
    if (in.is != policy::latest || !in.delayed()) return base::fresh(t, in);
    return base::newest(in) && base::newest(in)->beat > t.last_fired;
  }
};

struct initial_is_fresh : base {
  using base::base;
  bool fresh(const call& t, const input& in) const override {
    return base::fresh(t, in) || (in.wired() && t.last_fired == never);
  }
};

struct queue_fresh_after_taking : base {
  using base::base;
  bool fresh(const call& t, const input& in) const override {
    return in.is == policy::queue ? in.waiting.size() > 1 : base::fresh(t, in);
  }
};

// ---- when a component fires ----

template <strategy::kind From, strategy::kind To>
struct mixed_up : base {
  using base::base;
  bool fires(const strategy& s, const call& t) override {
    strategy other = s;
    if (s.is == From) other.is = To;
    return base::fires(other, t);
  }
};

struct no_phase : base {
  using base::base;
  bool fires(const strategy& s, const call& t) override {
    strategy other = s;
    other.phase = s.is == strategy::user ? s.phase : 0;
    return base::fires(other, t);
  }
};

struct default_is_moderate : base {
  using base::base;
  strategy when(const call& t) const override {
    strategy s = base::when(t);
    if (g.nodes[t.node].when.is == strategy::by_default && s.is == strategy::restless)
      s.is = strategy::moderate;
    return s;
  }
};

struct moderate_waits_for_the_unwired : base {
  using base::base;
  bool fires(const strategy& s, const call& t) override {
    if (s.is == strategy::moderate)
      for (const input& in : t.inputs)
        if (!in.wired()) return false;
    return base::fires(s, t);
  }
};

struct timeout_has_run_out_at_the_start : base {
  using base::base;
  bool fires(const strategy& s, const call& t) override {
    return (s.is == strategy::timeout && t.last_fired == never) || base::fires(s, t);
  }
};

struct any_port_triggers : base {
  using base::base;
  bool fires(const strategy& s, const call& t) override {
    strategy other = s;
    if (s.is == strategy::port_triggered) other.is = strategy::restless;
    return base::fires(other, t);
  }
};

struct coordinated_takes_initial_values : base {
  using base::base;
  bool coordinated(const call& t) const override {
    std::optional<std::int64_t> shared;
    for (const input& in : t.inputs) {
      if (!in.wired()) continue;
      const seen_input s = look(t, in);
      if (!s.arrived) continue;
      if (shared && *shared != s.origin) return false;
      shared = s.origin;
    }
    return shared && *shared > t.oldest_seen;
  }
};

struct coordinated_again_and_again : base {
  using base::base;
  bool coordinated(const call& t) const override {
    call forgetful = t;
    forgetful.oldest_seen = never;
    return base::coordinated(forgetful);
  }
};

struct coordinated_is_later_than_the_newest_seen : base {
  using base::base;
  std::int64_t oldest(const call& t, const std::vector<seen_input>& seen_inputs) const override {
    std::int64_t found = never;
    for (std::size_t i = 0; i < seen_inputs.size(); ++i)
      if (t.inputs[i].wired()) found = std::max(found, seen_inputs[i].origin);
    return found;
  }
};

struct coordinated_looks_at_the_first_only : base {
  using base::base;
  bool coordinated(const call& t) const override {
    for (const input& in : t.inputs)
      if (in.wired()) return look(t, in).arrived && look(t, in).origin > t.oldest_seen;
    return false;
  }
};

// ---- time of origin ----

struct origin_is_the_newest : base {
  using base::base;
  std::int64_t origin(const call& t, const std::vector<seen_input>& seen_inputs) const override {
    std::optional<std::int64_t> found;
    for (std::size_t i = 0; i < seen_inputs.size() && t.which != function::sense; ++i)
      if (counts(t, t.inputs[i], seen_inputs[i]))
        found = found ? std::max(*found, seen_inputs[i].origin) : seen_inputs[i].origin;
    return found.value_or(time());
  }
};

struct sense_has_an_origin_like_others : base {
  using base::base;
  std::int64_t origin(const call& t, const std::vector<seen_input>& seen_inputs) const override {
    call other;
    other.node = t.node;
    other.inputs = t.inputs;
    other.which = function::process;
    return base::origin(other, seen_inputs);
  }
};

struct set_origin_is_lost : base {
  using base::base;
  std::int64_t stamp(const recorded_output&, std::int64_t from) const override { return from; }
};

struct loops_count : base {
  using base::base;
  bool counts(const call&, const input& in, const seen_input& s) const override {
    return in.wired() && s.arrived;
  }
};

struct nothing_delayed_counts : base {
  using base::base;
  bool counts(const call&, const input& in, const seen_input& s) const override {
    return in.wired() && s.arrived && way_of(in, s).delay == 0;
  }
};

struct only_direct_loops : base {
  using base::base;
  bool feeds(int from, int to) const override {
    for (const call& t : g.calls)
      for (const input& in : t.inputs)
        for (const way& w : in.ways)
          if (t.node == to && g.calls[w.writer].node == from) return true;
    return false;
  }
};

struct only_loops_without_delay : base {
  using base::base;
  bool feeds(int from, int to) const override {
    interpreter other(g);
    for (call& t : other.g.calls)
      for (input& in : t.inputs)
        if (t.node != from) std::erase_if(in.ways, [](const way& w) { return w.delay > 0; });
    return other.interpreter::feeds(from, to);
  }
};

struct no_loop_through_a_resource_node : base {
  using base::base;
  bool feeds(int from, int to) const override {
    if (g.nodes[from].resource || g.nodes[to].resource) return false;
    interpreter other(g);
    for (call& t : other.g.calls)
      if (t.which != function::process) t.inputs.clear();
    return other.interpreter::feeds(from, to);
  }
};

struct initial_values_count : base {
  using base::base;
  bool counts(const call& t, const input& in, const seen_input& s) const override {
    seen_input as_if = s;
    as_if.arrived = true;
    return base::counts(t, in, as_if);
  }
};

// ---- faults ----

struct on_fault_is_not_called : base {
  using base::base;
  void on_fault() override {}
};

struct goes_on_after_a_fault : base {
  using base::base;
  void on_fault() override {
    base::on_fault();
    faulted = false;
    ++k;
  }
};

// ---- skeletons ----

constexpr char priority[] = "by_priority", freshness[] = "by_freshness", switching[] = "switch",
               blend[] = "blend", blend_of[] = "blend_of", hold[] = "hold", decimate[] = "decimate",
               interpolate[] = "interpolate", splitter[] = "splitter", collector[] = "collector",
               share_out[] = "share_out", gather[] = "gather";

// What one says is changed when it has done what it does.
template <const char* Kind, void (*Change)(firing&)>
struct wrong_skeleton : base {
  using base::base;
  void does(node& n, firing& f) override {
    n.does(f);
    if (n.skeleton == Kind) Change(f);
  }
};

// It says what this input says.
template <int Input>
void says(firing& f) {
  const auto& s = f.inputs[static_cast<std::size_t>(Input)];
  f.outputs[0].value = s.value;
}
void drops_nothing(firing& f) {
  f.outputs[0].published = true;
  f.outputs[0].value = f.inputs[0].value;
}
void the_other_way_round(firing& f) {
  if (f.outputs.size() == 1) std::reverse(f.outputs[0].value.begin(), f.outputs[0].value.end());
  else std::swap(f.outputs.front().value, f.outputs.back().value);
}
void of_all_inputs(firing& f) {
  for (recorded_output& t : f.outputs) t.sets_origin = false;
}

}  // namespace
}  // namespace mutants

const std::vector<mutant> all_mutants{
    {"the last declared of those that are ready comes first", mutants::made<mutants::last_declared_first>},
    {"calls in the order of declaration", mutants::made<mutants::declared_order>},
    {"the first dt is one beat", mutants::made<mutants::first_dt_is_one_beat>},
    {"dt is always one beat", mutants::made<mutants::dt_is_always_one_beat>},
    {"a pattern is looked up from the outside", mutants::made<mutants::looked_up_from_the_outside>},
    {"a pattern is looked up in its graph alone", mutants::made<mutants::looked_up_in_its_graph_alone>},
    {"* stands for any number of names", mutants::made<mutants::star_is_any_number>},
    {"** at the end names no inputs", mutants::made<mutants::no_inputs_are_named>},
    {"what is taken from a queue is heard again and again, delayed",
     mutants::made<mutants::taken_is_heard_again>},
    {"what waits in a queue is heard before it is taken, delayed",
     mutants::made<mutants::queued_is_heard_when_published>},
    {"a component fires although it is stopped", mutants::made<mutants::fires_although_stopped>},
    {"an inner graph does not stop", mutants::made<mutants::inner_graphs_do_not_stop>},
    {"a part starts what is inside", mutants::made<mutants::starts_what_is_inside>},
    {"a request has effect at once", mutants::made<mutants::requests_at_once>},
    {"of two requests the first counts", mutants::made<mutants::first_request_counts>},
    {"requests are lost", mutants::made<mutants::requests_are_lost>},
    {"what came while it was stopped is fresh", mutants::made<mutants::fresh_after_the_start>},
    {"the first dt after a start counts the time before", mutants::made<mutants::dt_counts_the_rest>},
    {"what is asked for from outside has effect a beat late",
     mutants::made<mutants::from_outside_a_beat_late>},
    {"what is asked for from outside is not done", mutants::made<mutants::from_outside_nothing>},
    {"a program sees the newest sample whatever the policy", mutants::made<mutants::program_sees_the_newest>},
    {"a program takes nothing from its queue", mutants::made<mutants::program_takes_nothing>},
    {"modes: a switch that a component asks for has effect a beat late",
     mutants::made<mutants::switch_a_beat_late>},
    {"modes: of two requests the first counts", mutants::made<mutants::first_mode_asked_for>},
    {"modes: components do not switch", mutants::made<mutants::components_do_not_switch>},
    {"modes: what several have begins anew at a switch", mutants::made<mutants::all_begins_anew>},
    {"modes: what was published before a switch is gone", mutants::made<mutants::outputs_begin_anew>},
    {"modes: what comes has fired when it was there before",
     mutants::made<mutants::as_it_went<mutants::its_firings>>},
    {"modes: what it published before it came is read",
     mutants::made<mutants::as_it_went<mutants::its_samples>>},
    {"modes: a component loses its state while it is away",
     mutants::made<mutants::what_a_mode_lacks_is_forgotten>},
    {"modes: each queue begins empty", mutants::made<mutants::no_queue_outlives_a_switch>},
    {"modes: each queue goes on, of other capacity too",
     mutants::made<mutants::each_queue_outlives_a_switch>},
    {"modes: what was published before comes into a new queue",
     mutants::made<mutants::comes_into_a_new_queue>},
    {"modes: after a switch a clock counts, not what is fresh",
     mutants::made<mutants::by_clock_after_a_switch>},
    {"modes: stopped parts start at a switch", mutants::made<mutants::parts_start_at_a_switch>},
    {"delayed<N> arrives one beat late", mutants::made<mutants::delayed_one_too_long>},
    {"delayed<N> arrives one beat early", mutants::made<mutants::delayed_one_too_short>},
    {"latest is that of the beat before", mutants::made<mutants::latest_is_of_the_beat_before>},
    {"the oldest instead of the newest", mutants::made<mutants::oldest_instead_of_newest>},
    {"a queue holds one more", mutants::made<mutants::queue_one_longer>},
    {"drop_oldest drops the newest",
     mutants::made<mutants::full_queue_mixed_up<when_full::drop_oldest, when_full::drop_newest>>},
    {"drop_newest drops the oldest",
     mutants::made<mutants::full_queue_mixed_up<when_full::drop_newest, when_full::drop_oldest>>},
    {"reject drops in silence",
     mutants::made<mutants::full_queue_mixed_up<when_full::reject, when_full::drop_newest>>},
    {"a queue is a stack", mutants::made<mutants::last_in_first_out>},
    {"an empty queue shows the initial value again", mutants::made<mutants::empty_queue_forgets>},
    {"a queue is emptied at each firing", mutants::made<mutants::queue_takes_all>},
    {"a queue takes delayed samples when they are published",
     mutants::made<mutants::delayed_enters_when_published>},
    {"a queue takes delayed samples a beat late", mutants::made<mutants::delayed_enters_one_late>},
    {"merged: delayed samples come after those of the beat",
     mutants::made<mutants::delayed_enters_after_the_others>},
    {"merged: the newest delayed sample comes first", mutants::made<mutants::merged_by_delay>},
    {"merged: only the first wire is heard", mutants::made<mutants::merged_hears_the_first_wire_only>},
    {"merged: all samples count for the origin as those of the first wire",
     mutants::made<mutants::merged_counts_as_its_first_wire>},
    {"one sample at most is said to wait", mutants::made<mutants::nothing_waits>},
    {"one sample at most is said to arrive", mutants::made<mutants::arrivals_are_freshness>},
    {"a strategy forgets its state", mutants::made<mutants::no_state>},
    {"any_of does not ask a strategy with a state when another one fires",
     mutants::made<mutants::not_always_asked>},
    {"a strategy keeps its state although its component was stopped",
     mutants::made<mutants::state_outlives_the_stop>},
    {"fresh also in the beat of the last firing",
     mutants::made<mutants::fresh_also_in_the_beat_of_the_last_firing>},
    {"delayed: fresh counts from publication", mutants::made<mutants::fresh_when_published>},
    {"an initial value is fresh", mutants::made<mutants::initial_is_fresh>},
    {"a queue is fresh if something is left after taking", mutants::made<mutants::queue_fresh_after_taking>},
    {"restless is moderate", mutants::made<mutants::mixed_up<strategy::restless, strategy::moderate>>},
    {"moderate is restless", mutants::made<mutants::mixed_up<strategy::moderate, strategy::restless>>},
    {"any_of is all_of", mutants::made<mutants::mixed_up<strategy::any_of, strategy::all_of>>},
    {"all_of is any_of", mutants::made<mutants::mixed_up<strategy::all_of, strategy::any_of>>},
    {"inactive is full_speed", mutants::made<mutants::mixed_up<strategy::inactive, strategy::full_speed>>},
    {"a user's strategy is not asked",
     mutants::made<mutants::mixed_up<strategy::user, strategy::full_speed>>},
    {"no phase", mutants::made<mutants::no_phase>},
    {"the default with inputs is moderate", mutants::made<mutants::default_is_moderate>},
    {"moderate waits for what is not wired", mutants::made<mutants::moderate_waits_for_the_unwired>},
    {"a timeout has run out at the start", mutants::made<mutants::timeout_has_run_out_at_the_start>},
    {"port_triggered: any port triggers", mutants::made<mutants::any_port_triggers>},
    {"coordinated takes initial values", mutants::made<mutants::coordinated_takes_initial_values>},
    {"coordinated fires again on what it has seen", mutants::made<mutants::coordinated_again_and_again>},
    {"coordinated: later than the newest seen",
     mutants::made<mutants::coordinated_is_later_than_the_newest_seen>},
    {"coordinated looks at the first input only",
     mutants::made<mutants::coordinated_looks_at_the_first_only>},
    {"the origin is the newest", mutants::made<mutants::origin_is_the_newest>},
    {"sense has an origin like others", mutants::made<mutants::sense_has_an_origin_like_others>},
    {"an origin that the component sets is lost", mutants::made<mutants::set_origin_is_lost>},
    {"a loop's input counts for the origin", mutants::made<mutants::loops_count>},
    {"no delayed input counts for the origin", mutants::made<mutants::nothing_delayed_counts>},
    {"only a loop of two is a loop", mutants::made<mutants::only_direct_loops>},
    {"a loop over two delayed wires is none", mutants::made<mutants::only_loops_without_delay>},
    {"a loop through a resource node is none", mutants::made<mutants::no_loop_through_a_resource_node>},
    {"initial values count for the origin", mutants::made<mutants::initial_values_count>},
    {"on_fault is not called", mutants::made<mutants::on_fault_is_not_called>},
    {"goes on after a fault", mutants::made<mutants::goes_on_after_a_fault>},
    {"by_priority: the second is always heard",
     mutants::made<mutants::wrong_skeleton<mutants::priority, mutants::says<1>>>},
    {"by_freshness: the first is always heard",
     mutants::made<mutants::wrong_skeleton<mutants::freshness, mutants::says<0>>>},
    {"by_freshness: its origin is the oldest of all",
     mutants::made<mutants::wrong_skeleton<mutants::freshness, mutants::of_all_inputs>>},
    {"switch: it does not", mutants::made<mutants::wrong_skeleton<mutants::switching, mutants::says<0>>>},
    {"switch: its origin is the oldest of all",
     mutants::made<mutants::wrong_skeleton<mutants::switching, mutants::of_all_inputs>>},
    {"blend of two: the second alone",
     mutants::made<mutants::wrong_skeleton<mutants::blend, mutants::says<1>>>},
    {"blend of several: the last alone",
     mutants::made<mutants::wrong_skeleton<mutants::blend_of, mutants::says<2>>>},
    {"hold: never frozen", mutants::made<mutants::wrong_skeleton<mutants::hold, mutants::says<0>>>},
    {"decimate: nothing is left out",
     mutants::made<mutants::wrong_skeleton<mutants::decimate, mutants::drops_nothing>>},
    {"interpolate: steps", mutants::made<mutants::wrong_skeleton<mutants::interpolate, mutants::says<0>>>},
    {"splitter: the wrong axes",
     mutants::made<mutants::wrong_skeleton<mutants::splitter, mutants::the_other_way_round>>},
    {"collector: the wrong axes",
     mutants::made<mutants::wrong_skeleton<mutants::collector, mutants::the_other_way_round>>},
    {"farm: the workers get each other's parts",
     mutants::made<mutants::wrong_skeleton<mutants::share_out, mutants::the_other_way_round>>},
    {"farm: the results change places",
     mutants::made<mutants::wrong_skeleton<mutants::gather, mutants::the_other_way_round>>},
};

}  // namespace semantics
