// Replays a recording: the controller of the same graph senses what was recorded, goes through the same
// life-cycle with the same parameters, and each sample that it publishes is compared with the recorded one,
// bit for bit.
//
//   const auto result = cca::recording::replay<trot>("trot.mcap");
//   std::cout << result << '\n';      // 160000 samples of 20000 beats, bit for bit as recorded
//   assert(result);                   // or: `cpg.phase`, beat 1234: recorded [0.1], replayed [0.2]
//
// What else a program gives to its components before the first beat, as the name of a file, it gives in a
// second argument: replay<trot>("trot.mcap", [](auto& c) { c.template get<"gait">().file = ...; }). It is
// called before the parameters are applied. What a program does to components between two beats by other
// ways than parameters and the life-cycle is not recorded.
//
// Errors: cca::refused if the file is no recording, of another architecture, begins after the first beat, or
// lacks samples of a resource node. A recording that was cut off is replayed as far as it goes. Test:
// tests/runtime/record/replay.cpp; docs/recordings.md.
#pragma once

#include <cstdint>
#include <cstring>
#include <deque>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/record/replay/recorded_beats.hpp>
#include <cca/record/replay/replayed.hpp>
#include <cca/record/replay/result.hpp>
#include <cca/runtime/controller.hpp>

namespace cca::recording {
namespace detail {

template <class Graph>
class replay_run final : cca::detail::beat_tap<replaying<Graph>> {
  using graph = replaying<Graph>;
  static constexpr int output_count = cca::detail::counts_of<Graph>.output_count;
  static constexpr const auto& layout = cca::detail::frame_layout_of<Graph>;

public:
  explicit replay_run(const std::string& file)
      : cca::detail::beat_tap<graph>(2), items(file), called(file), recorded(words(layout.words)) {
    forget_beat();
    c.record_into(this);
  }
  ~replay_run() override { c.record_into(nullptr); }

  controller<graph>& robot() { return c; }

  replay_result go() {
    for (recorded_item item; items.next(item);) {
      is_begun = true;
      while (item.beat > k && result.difference.empty() && !is_finished()) beat();
      if (!result.difference.empty() || is_finished()) return result;
      if (item.sample) take(*item.sample, item.beat);
      else if (item.event) take(*item.event);
      else if (item.lost > 0) {
        result.ended_early = "the recording lost " + std::to_string(item.lost) + " beats, from beat " +
                             std::to_string(item.beat) + " on";
        return result;
      }
    }
    check_ports();
    if (has_samples && items.damage().empty()) beat();  // of the last beat a part may be lost
    if (!items.damage().empty() && result.difference.empty())
      result.ended_early = "the recording is cut off: " + items.damage();
    return result;
  }

private:
  template <class F>
  void each_node(F f) {
    int node = 0;
    c.for_each_component([&]<class C>(std::string_view, C& component) { f(node++, component); });
  }
  static std::size_t words(int n) { return static_cast<std::size_t>(n); }
  static std::size_t at(int n) { return cca::detail::array_size(n); }
  bool is_finished() const { return !result.ended_early.empty(); }

  void forget_beat() {
    for (int o = 0; o < output_count; ++o) recorded[words(1 + o)] = never;
    reason.clear();
    failed_component.clear();
    has_samples = false;
  }

  void take(const recorded_sample& s, std::int64_t beat_of_sample) {
    if (beat_of_sample < k)
      throw refused(called + ": a sample of beat " + std::to_string(beat_of_sample) + " after beat " +
                    std::to_string(k));
    recorded[words(1 + s.output)] = s.origin;
    std::memcpy(&recorded[words(layout.at[at(s.output)])], s.coordinates.data(),
                sizeof(double) * s.coordinates.size());
    has_samples = true;
  }

  void take(const recorded_event& e) {
    if (e.kind == event_kind::fault) {
      reason = e.text;
      failed_component = e.component;
      has_samples = true;
    } else if (e.kind == event_kind::parameters) {
      each_node([&]<class C>(int node, C& component) {
        if constexpr (HasParameters<C>)
          if (node == e.node) set(component, e.parameters);
      });
    } else {
      move_to(e.text);
    }
  }
  template <class C>
  void set(C& component, const std::vector<unsigned char>& message) {
    auto values = component.p;
    cdr_reader from(message);
    from.number<std::int64_t>();
    if (!decode(cca::detail::schema_of<typename C::parameters>, &values, from))
      throw refused(called + ": parameters that the component can't have");
    component.p = values;
  }

  // The step of the life-cycle that leads there.
  void move_to(const std::string& wanted) {
    const state from = c.state();
    if (wanted == "loaded") {
      if (from == state::created || from == state::loaded) c.load();
      else if (from == state::started || from == state::faulted) c.stop();
    } else if (wanted == "started" || wanted == "running") {
      if (from == state::created) c.load();
      if (c.state() == state::loaded) c.start();
      else if (from == state::faulted && wanted == "started") c.resume();
    } else if (wanted == "created" && from == state::loaded) {
      c.save();
    }
  }

  // All resource nodes were recorded, or nothing can be replayed.
  void check_ports() {
    if (is_checked) return;
    is_checked = true;
    for (int o = 0; o < output_count; ++o) {
      const auto& output = cca::detail::plan_of<Graph>.outputs[at(o)];
      const auto& call = cca::detail::plan_of<Graph>.calls[at(output.call)];
      if (call.phase == cca::detail::phase_of_beat::sense && !items.has(o))
        throw refused(called + ": what `" + path_of_port<Graph>(o) +
                      "` sensed was not recorded: record it to replay");
    }
  }

  void beat() {
    check_ports();
    if (c.state() != state::started) {
      if (k == 0 && c.state() == state::created)
        throw refused(called + ": it does not begin before the first beat: start recording before load()");
      ++k;  // another thread's `step` in a state that does not allow it
      return forget_beat();
    }
    feed();
    c.step();
    result.fault =
        c.state() == state::faulted ? "`" + c.fault_path() + "`: " + std::string(c.fault().reason()) : "";
    compare();
    k = c.beat_index();
    forget_beat();
  }

  void feed() {
    each_node([&]<class C>(int node, C& component) {
      if constexpr (requires { component.forget(); }) {
        component.forget();
        for (const auto& call : cca::detail::plan_of<Graph>.calls) {
          if (call.node != node || !call.function) continue;
          for (int p = 0; p < call.function->output_count; ++p) {
            const int o = call.first_output + p;
            if (recorded[words(1 + o)] != never)
              component.put(call.phase, p, recorded[words(1 + o)],
                            reinterpret_cast<const double*>(&recorded[words(layout.at[at(o)])]));
          }
        }
        if (!reason.empty() && failed_component == cca::detail::path_of_node<Graph>(node))
          component.fail(kept_reason());
      }
    });
  }
  // A fault points to its text.
  const char* kept_reason() { return reasons.emplace_back(reason).c_str(); }

  void compare() {
    const std::int64_t* const replayed_frame = this->ring.oldest();
    ++result.beats;
    for (int rank = 0; rank < cca::detail::counts_of<Graph>.order_count; ++rank) {
      const auto& of = cca::detail::plan_of<Graph>.calls[at(cca::detail::plan_of<Graph>.order[at(rank)])];
      for (int p = 0; p < of.function->output_count; ++p) {
        const int o = of.first_output + p;
        if (!items.has(o)) continue;
        const std::int64_t was = recorded[words(1 + o)], is = replayed_frame[1 + o];
        const auto size = static_cast<std::size_t>(layout.size[at(o)]);
        const auto* const then = &recorded[words(layout.at[at(o)])];
        const auto* const now = replayed_frame + layout.at[at(o)];
        if (was == never && is == never) continue;
        if (was == is && std::memcmp(then, now, sizeof(double) * size) == 0) {
          result.samples += of.phase == cca::detail::phase_of_beat::process;  // the others were fed
          continue;
        }
        differ(o, sample_text(was, then, size), sample_text(is, now, size));
        this->ring.take();
        return;
      }
    }
    this->ring.take();
    const bool has_faulted = c.state() == state::faulted;
    const std::string path = c.fault_path();
    if (has_faulted && reason.empty())
      differ_in_fault(path, std::string("no fault"), "the fault `" + std::string(c.fault().reason()) + "`");
    else if (!has_faulted && !reason.empty() && !failed_component.empty())
      differ_in_fault(failed_component, "the fault `" + reason + "`", "no fault");
    else if (has_faulted && (path != failed_component || c.fault().reason() != reason))
      differ_in_fault(failed_component, "the fault `" + reason + "` of `" + failed_component + "`",
                      "the fault `" + std::string(c.fault().reason()) + "` of `" + path + "`");
  }

  static std::string sample_text(std::int64_t origin, const std::int64_t* words_of, std::size_t size) {
    if (origin == never) return "nothing";
    std::ostringstream text;
    text.precision(17);
    text << '[';
    for (std::size_t i = 0; i < size; ++i) {
      double c;
      std::memcpy(&c, words_of + i, sizeof c);
      text << (i ? " " : "") << c;
    }
    text << "] of " << origin << " ns";
    return text.str();
  }
  void differ(int o, const std::string& was, const std::string& is) {
    const auto& output = cca::detail::plan_of<Graph>.outputs[at(o)];
    const auto& call = cca::detail::plan_of<Graph>.calls[at(output.call)];
    result.component = cca::detail::path_of_node<Graph>(call.node);
    result.port = call.function->outputs[output.port].name;
    result.beat = k;
    result.difference = "`" + result.component + "." + result.port + "`, beat " + std::to_string(k) +
                        ": recorded " + was + ", replayed " + is;
  }
  void differ_in_fault(const std::string& path, const std::string& was, const std::string& is) {
    result.component = path;
    result.beat = k;
    result.difference =
        "`" + path + "`, beat " + std::to_string(k) + ": recorded " + was + ", replayed " + is;
  }

  void parameters_changed(const cca::detail::controller_state<graph>&, std::int64_t) noexcept override {}
  void moved(state, std::int64_t) noexcept override {}
  void failed(int, const char*, std::int64_t) noexcept override {}
  void controller_is_gone() noexcept override {}

  recorded_items<Graph> items;
  std::string called;
  controller<graph> c;
  std::vector<std::int64_t> recorded;  // the frame of the beat k
  std::int64_t k = 0;
  std::string reason, failed_component;
  std::deque<std::string> reasons;
  bool has_samples = false, is_checked = false, is_begun = false;
  replay_result result;
};

}  // namespace detail

template <class Graph, class Prepare>
replay_result replay(const std::string& file, Prepare prepare) {
  static_assert(cca::detail::Recordable<Graph>,
                "cca::recording::replay: derive the graph from cca::recordable");
  const auto run = std::make_unique<detail::replay_run<Graph>>(file);
  prepare(run->robot());
  return run->go();
}
template <class Graph>
replay_result replay(const std::string& file) {
  return replay<Graph>(file, [](auto&) {});
}

}  // namespace cca::recording
