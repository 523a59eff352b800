// One replay: feeds what was recorded of each beat to the resource nodes, repeats what happened between two
// beats, and compares what the others publish. What a file may be refused for: record/replay.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/record/replay/compared_outputs.hpp>
#include <cca/record/mcap/printable.hpp>
#include <cca/record/replay/recorded_channels.hpp>
#include <cca/record/replay/recorded_parameters.hpp>
#include <cca/record/replay/life_cycle_step.hpp>
#include <cca/record/replay/played_samples.hpp>
#include <cca/record/replay/replayed.hpp>
#include <cca/record/replay/result.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/runtime/environments/exchange/cycle_results.hpp>

namespace cca::recording::detail {

// `Items`: where they come from; recorded_items of a file, twin_items of a robot that runs.
template <class Graph, class Items>
class replay_run final : playing_tap<Graph> {
  using graph = replaying<Graph>;
  static constexpr int output_count = cca::detail::counts_of<Graph>.output_count;
  static constexpr const auto& plan = cca::detail::plan_of<Graph>;
  static constexpr const auto& layout = cca::detail::frame_layout_of<Graph>;

public:
  explicit replay_run(const std::string& file, std::int64_t most_silent = most_silent_beats)
      : playing_tap<Graph>(2), items(file), silence(most_silent), recorded(at(layout.words)) {
    forget_beat();
    c.record_into(this);
    each_node([&]<class C>(int node, C&) { check_names<C>(node); });
  }
  ~replay_run() override { c.record_into(nullptr); }

  controller<graph>& robot() { return c; }
  Items& source() { return items; }

  replay_result go() {
    play_what_came();
    finish();
    if (result.beats > 0) result.not_compared = compared.template complaint<Graph>();
    return result;
  }

  // All that the items have now, but the last beat: there may be more of it.
  const replay_result& play_what_came() {
    for (recorded_item item; !is_finished() && items.next(item);) {
      go_on_to(item.beat);
      if (is_finished()) break;
      if (item.sample) take(*item.sample, item.beat);
      else if (item.event) take(*item.event);
      else if (item.dropped > 0) this->miss(item.dropped_by, item.dropped);
      else if (item.lost > 0)
        result.ended_early = std::string(Items::called_whole) + " lost " + std::to_string(item.lost) +
                             " beats, from beat " + std::to_string(item.beat) + " on";
    }
    return result;
  }

private:
  void finish() {
    if (is_finished()) return;
    if (has_samples && items.damage().empty()) beat();  // of the last beat a part may be lost
    if (!is_finished()) compare_modes();
    if (const std::string missing = items.missing_end(); result.difference.empty() && !missing.empty())
      result.ended_early = missing;
    if (!is_finished() && result.beats == 0) result.ended_early = "the recording has no beat";
  }

  template <class F>
  void each_node(F f) {
    int node = 0;
    c.for_each_component([&]<class C>(std::string_view, C& component) { f(node++, component); });
  }
  static std::size_t at(int n) { return cca::detail::array_size(n); }
  bool is_finished() const { return !result.ended_early.empty() || !result.difference.empty(); }

  // More beats than a day at 1 kHz in which nothing at all was recorded are a damaged number.
  static constexpr std::int64_t most_silent_beats = 100'000'000;

  // The beats before `next`.
  void go_on_to(std::int64_t next) {
    while (k < next && !is_finished()) {
      if (c.state() != state::started) {
        check_begin();
        k = next;  // another thread's `step` in a state that does not allow it
        return forget_beat();
      }
      if (!has_samples && ++silent_beats > silence) {
        result.ended_early = "nothing is recorded of more than " + std::to_string(silence) +
                             " beats, before beat " + std::to_string(next);
        return;
      }
      beat();
    }
  }
  template <class C>
  void check_names(int node) const {
    if (const auto* schema = items.parameter_schema_of(node))
      check_names_of_parameters<Graph, C>(node, *schema, items.name());
  }
  void check_begin() const {
    if (k == 0 && c.state() == state::created)
      throw refused(items.name() +
                    ": it does not begin before the first beat: start recording before load()");
  }

  void forget_beat() {
    for (int o = 0; o < output_count; ++o) recorded[at(layout.origin[at(o)])] = never;
    for (auto& one : this->played) one.forget();
    reason.clear();
    failed_component.clear();
    has_samples = false;
  }

  void take(const recorded_sample& s, std::int64_t beat_of_sample) {
    const auto refuse_sample = [&](const std::string& why) {
      throw refused(items.name() + ": a sample of `" + cca::detail::path_of_output<Graph>(s.output) +
                    "` of beat " + std::to_string(beat_of_sample) + why);
    };
    if (beat_of_sample < k)
      refuse_sample(" comes after samples of beat " + std::to_string(k) +
                    ": another tool has changed the order of messages");
    if (is_playing && this->takes_several(s.output)) this->keep_earlier(s.output, recorded.data());
    else if (recorded[at(layout.origin[at(s.output)])] != never)
      refuse_sample(" is there twice: are two recordings merged in this file?");
    recorded[at(layout.origin[at(s.output)])] = s.origin;
    if (!s.coordinates.empty())  // of a twin, which has hashes alone
      std::memcpy(&recorded[at(layout.at[at(s.output)])], s.coordinates.data(),
                  sizeof(double) * s.coordinates.size());
    hashes[at(s.output)] = s.hash;
    has_samples = true;
  }

  void take(const recorded_event& e) {
    if (e.kind == event_kind::fault) {
      if (const int node = cca::detail::node_at<Graph>(e.component); node >= 0 && is_played(node)) {
        result.fault =
            "`" + e.component + "`: " + printable(e.text);  // it ended the run, and no beat of the others
        return;
      }
      reason = e.text;
      failed_component = e.component;
      has_samples = true;
    } else if (e.kind == event_kind::parameters) {
      told.add(e.node);
      each_node([&]<class C>(int node, C& component) {
        if constexpr (HasParameters<C>)
          if (node == e.node) {  // before load() they may be anything: load() checks them
            check_names<C>(node);
            take_parameters<Graph>(component, node, e.parameters, items.name(), c.state() != state::created);
          }
      });
    } else if (e.kind == event_kind::mode) {
      mode_recorded = e.text;
      if constexpr (Modes<Graph>) {
        if (!e.requested || (c.mode() != e.text && are_modes_asked_beside<Graph>(is_playing)))
          c.switch_to(e.text);
        else compared.add();
      }
    } else if (e.kind == event_kind::part) {
      // The replayed components ask by themselves, but resource nodes are not there.
      if (!e.requested || is_part_asked_beside<graph>(e.text, [this](int n) { return is_played(n); }))
        set_part(e.text, e.stopped);
    } else if (e.kind == event_kind::freely) {
      if (this->is_fast = !e.freely; e.freely) play_from_now();
      else if (is_playing) check_that_all_ran_here();
    } else if (e.kind == event_kind::late) {
      differs_by_clock("the samples of `" + e.component + "` had not come to `" + e.text + "`");
    } else if (e.kind == event_kind::skipped) {
      differs_by_clock("`" + e.text + "` left out beats");
    } else {
      move(e.text);
    }
  }
  // What free-running environments publish depends on the machine from here on.
  void play_from_now() {
    if constexpr (cca::detail::has_free_running<Graph>) {
      is_playing = true;
      each_node([]<class C>(int, C& component) {
        if constexpr (requires { component.begin_playing(); }) component.begin_playing();
      });
      for (int o = 0; o < output_count; ++o)
        if (cca::detail::leaves_freely<Graph>::holds(at(o)) && !items.has(o))
          differs_by_clock(
              "`" + cca::detail::path_of_output<Graph>(o) +
              "` ran freely and was not recorded: record it, in the process of the first environment");
    }
  }
  // In a fast run after a wall-clock run nobody tells what other processes publish.
  void check_that_all_ran_here() {
    if constexpr (cca::detail::has_free_running<Graph>)
      for (int o = 0; o < output_count; ++o)
        if (cca::detail::leaves_freely<Graph>::holds(at(o)) && !items.ran_here(o))
          differs_by_clock("`" + cca::detail::path_of_output<Graph>(o) +
                           "` ran in another process, in a fast run after a wall-clock run");
  }
  // Of a free-running environment that is played.
  bool is_played(int node) const { return is_playing && cca::detail::is_free_node<Graph>(node); }

  void set_part(const std::string& part, bool stops) {
    if (c.state() != state::started && c.state() != state::faulted) return;
    if (stops) c.stop(part);
    else c.start(part);
  }

  // A hook may refuse, for example without the name of a file.
  void move(const std::string& to) {
    try {
      move_to(c, to);
    } catch (const refused& why) {
      const std::string missing = told.missing(c, items);
      throw refused(items.name() + ": in replay the state `" + to + "` is refused: " + printable(why.what()) +
                    (missing.empty() ? "" : " (no parameters are recorded of " + missing + ")"));
    }
  }
  // A loop may compute something else.
  void differs_by_clock(const std::string& why) {
    if (clock_says.empty()) clock_says = "from beat " + std::to_string(k) + " on, where " + why;
  }
  void beat() {
    if (c.state() != state::started) return check_begin(), forget_beat();
    if (!compare_modes()) return;
    if (result.beats == 0) told.check(c, items, items.name());
    feed();
    const int mode = active_mode();
    c.step();
    result.fault =
        c.state() == state::faulted ? "`" + c.fault_path() + "`: " + printable(c.fault().reason()) : "";
    compare(mode);
    k = c.beat_index();
    forget_beat();
  }

  void feed() {
    this->keep_taken(recorded.data(), [this](int node) { return is_played(node); });
    each_node([&]<class C>(int node, C& component) {
      if constexpr (requires { component.forget(); }) {
        feed_frame<Graph>(component, node, recorded.data());
        if (!reason.empty() && failed_component == cca::detail::path_of_node<Graph>(node))
          component.fail(reasons.emplace_back(reason).c_str());
      }
    });
  }

  void compare(int mode) {
    const std::int64_t* const replayed_frame = this->ring.oldest();
    ++result.beats;
    for (const int o : orders[at(mode)]) {
      const auto& call = plan.calls[at(plan.outputs[at(o)].call)];
      if (is_played(call.node)) continue;
      const bool is_computed = call.phase == cca::detail::phase_of_beat::process;
      const bool is_known = items.has(o) && items.ran_here(o);
      if (is_computed) compared.add_output(o, is_known);
      if (!is_known) continue;
      const auto origin = at(layout.origin[at(o)]);
      const std::int64_t was = recorded[origin], is = replayed_frame[origin];
      const auto size = static_cast<std::size_t>(layout.size[at(o)]);
      const auto* const then = &recorded[at(layout.at[at(o)])];
      const auto* const now = replayed_frame + layout.at[at(o)];
      if (was == never && is == never) continue;
      if (items.is_same(o, was, hashes[at(o)], then, is, now, size)) {
        result.samples += is_computed;  // the others were fed
        continue;
      }
      if (was == never && !is_computed) end_at_gap(o);
      else differ(o, items.text_of(o, was, then, size), sample_text(is, now, size));
      this->ring.take();
      return;
    }
    this->ring.take();
    const bool has_faulted = c.state() == state::faulted;
    const std::string path = c.fault_path(), now = has_faulted ? std::string(c.fault().reason()) : "";
    const bool by_component = has_faulted || !failed_component.empty();
    if (by_component && (now != reason || (has_faulted && path != failed_component))) {
      result.component = reason.empty() ? path : failed_component;
      state_difference(result.component, fault_text(reason, failed_component), fault_text(now, path));
    } else if (by_component) compared.add();
  }

  void end_at_gap(int o) {
    result.beat = k;
    result.ended_early = "what `" + cca::detail::path_of_output<Graph>(o) + "` sensed in beat " +
                         std::to_string(k) + " is missing: " + Items::why_missing;
  }
  // Before a beat: the mode that was recorded is active.
  bool compare_modes() {
    if constexpr (Modes<Graph>)
      if (!mode_recorded.empty() && c.mode() != mode_recorded) {
        result.beat = k;
        result.difference = "beat " + std::to_string(k) +
                            both("the mode `" + mode_recorded + "`", "`" + std::string(c.mode()) + "`");
        return false;
      }
    return true;
  }
  int active_mode() const {
    if constexpr (Modes<Graph>) return cca::detail::modes_of<Graph>::value.number_of(c.mode());
    else return 0;
  }
  void differ(int o, const std::string& was, const std::string& is) {
    const auto& call = plan.calls[at(plan.outputs[at(o)].call)];
    result.component = cca::detail::path_of_node<Graph>(call.node);
    result.port = cca::detail::port_of(call, plan.outputs[at(o)]).name;
    state_difference(result.component + "." + result.port, was, is);
  }
  // It counts, unless the clock has already made the environments another program than a loop.
  void state_difference(const std::string& path, const std::string& was, const std::string& is) {
    if (!clock_says.empty()) result.ended_early = "it can't be replayed " + clock_says;
    else result.beat = k, result.difference = "`" + path + "`, beat " + std::to_string(k) + both(was, is);
  }
  static std::string both(const std::string& was, const std::string& is) {
    return std::string(": ") + Items::of_there + " " + was + ", " + Items::of_here + " " + is;
  }

  Items items;
  std::int64_t silence, silent_beats = 0;
  controller<graph> c;
  std::vector<std::int64_t> recorded;  // the frame of the beat k
  std::array<std::uint32_t, cca::detail::array_size(output_count + 1)> hashes{};
  std::int64_t k = 0;
  std::string reason, failed_component, mode_recorded, clock_says;
  const std::vector<std::vector<int>> orders = orders_of_beats<Graph>();
  std::deque<std::string> reasons;  // a fault points to its text
  bool has_samples = false, is_playing = false;
  told_parameters<Graph> told;
  comparison compared;
  replay_result result;
};

}  // namespace cca::recording::detail
