// Records a controller into an MCAP file, from now on until it is destroyed or closed.
//
//   cca::controller<trot> c;                       // struct trot : cca::graph<...>, cca::recordable {};
//   cca::recording::recorder recording(c, "trot.mcap");
//   c.load(); c.start(); c.run(...);
//
// A thread of its own compresses and writes. The beat copies what is published into a ring: no allocation, no
// lock, no wait, no system call. To be replayed, a recording must begin before the first beat.
//
// Errors: std::system_error if the file can't be opened, cca::refused for a scope without ports. If writing
// fails later, for example on a full disk, the loop goes on, and `problem()` says what happened. Cost of a
// beat: docs/recordings.md. Tests: tests/runtime/record/.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <cca/record/event_ring.hpp>
#include <cca/record/recording_file.hpp>
#include <cca/record/settings.hpp>
#include <cca/runtime/controller.hpp>

namespace cca::recording {

template <class Controller>
class recorder {
  static_assert(
      sizeof(Controller) == 0,
      "cca::recording::recorder: it records the cca::controller of one graph, not a deployment or a set "
      "of modes");
};

template <class Graph>
class recorder<controller<Graph>> final : cca::detail::beat_tap<Graph> {
  static_assert(cca::detail::Recordable<Graph>,
                "cca::recording::recorder: derive the graph from cca::recordable, too: "
                "struct trot : cca::graph<...>, cca::recordable {};");
  using tap = cca::detail::beat_tap<Graph>;
  static constexpr std::int64_t period = cca::detail::counts_of<Graph>.period;

public:
  recorder(controller<Graph>& c, const std::string& name, const settings& s = {})
      : tap(frames(s)), how(s), file(name, s, prepare(c)) {
    if (c.recorded_into()) throw refused("cca::record: this controller is being recorded already");
    file.expect(c.beat_index());
    writer = std::thread([this] { write_all(); });
    of = &c;
    c.record_into(this);
    moved(c.state(), c.beat_index());
  }
  ~recorder() override { close(); }

  // What the program wants to say about this run, as a seed: metadata of this name.
  void note(const std::string& name, const std::map<std::string, std::string>& entries) {
    const std::scoped_lock lock(guard);
    notes.emplace_back(name, entries);
  }
  void note(const std::string& name, const std::string& value) { note(name, {{"value", value}}); }

  // Ends the recording. Not while a beat runs.
  void close() {
    if (!writer.joinable()) return;
    if (of) {
      end = of->beat_index();
      of->record_into(nullptr);
      of = nullptr;
    }
    is_closing.store(true, std::memory_order_release);
    wake.notify_one();
    writer.join();
  }

  // Beats and events that did not fit.
  std::int64_t lost_beats() const noexcept { return lost.load(std::memory_order_relaxed); }
  std::int64_t lost_events() const noexcept { return events.lost_events(); }
  // Why nothing more is written; empty: all is well.
  std::string problem() const {
    const std::scoped_lock lock(guard);
    return what_failed;
  }

private:
  static std::size_t frames(const settings& s) {
    constexpr double bytes = 8.0 * cca::detail::frame_layout_of<Graph>.words;
    const double wanted = std::max(1024.0, s.buffered_seconds * 1e9 / static_cast<double>(period));
    return static_cast<std::size_t>(std::max(2.0, std::min(wanted, (1 << 26) / bytes)));
  }

  // Memory for the parameters as they were last told.
  const std::vector<const detail::schema*>& prepare(controller<Graph>& c) {
    std::size_t most = 64;
    c.for_each_component([&]<class C>(std::string_view, const C&) {
      const detail::schema* type = nullptr;
      if constexpr (HasParameters<C>) type = &cca::detail::schema_of<typename C::parameters>;
      const std::size_t bytes = type ? 16 + detail::most_bytes(*type) : 0;
      types.push_back(type);
      told.emplace_back();
      told.back().reserve(bytes);
      most = std::max(most, bytes);
    });
    scratch.resize(most + 512);
    return types;
  }

  // ---- in the thread of the loop ----

  void parameters_changed(const cca::detail::controller_state<Graph>& state,
                          std::int64_t k) noexcept override {
    cca::detail::visit_components<Graph>(
        [&]<class C>(int node, const C& component) {
          if constexpr (HasParameters<C>) tell(node, component.p, k);
        },
        state);
  }
  template <class Parameters>
  void tell(int node, const Parameters& p, std::int64_t k) noexcept {
    detail::cdr_writer to(scratch);
    to.add(k);
    detail::encode(cca::detail::schema_of<Parameters>, &p, to);
    const auto now = to.view();
    auto& last = told[cca::detail::array_size(node)];
    constexpr std::size_t head = detail::cdr_head + 8;  // the beat does not count
    if (std::ranges::equal(std::span(last).subspan(std::min(head, last.size())), now.subspan(head))) return;
    if (events.put({detail::event_kind::parameters, node, k}, now))
      last.assign(now.begin(), now.end());  // within what is reserved
  }
  void moved(state to, std::int64_t k) noexcept override {
    detail::cdr_writer message(scratch);
    events.put({detail::event_kind::state, -1, k}, message.add(k).add(to_string(to)).view());
  }
  void failed(int node, const char* reason, std::int64_t k) noexcept override {
    const std::string_view path =
        node < 0 ? std::string_view() : std::string_view(paths[cca::detail::array_size(node)]);
    detail::cdr_writer message(scratch);
    message.add(k).add(path.substr(0, 200)).add(std::string_view(reason).substr(0, 250));
    events.put({detail::event_kind::fault, node, node < 0 ? k : k + 1}, message.view());
  }
  void controller_is_gone() noexcept override { of = nullptr; }
  void wait_for_room() noexcept override {
    while (how.waits && !this->ring.find_room() && !is_broken.load(std::memory_order_acquire))
      std::this_thread::sleep_for(std::chrono::microseconds(100));
  }

  // ---- in the thread that writes ----

  void write_all() {
    using clock = std::chrono::steady_clock;
    auto flushed = clock::now();
    const auto most = std::chrono::duration<double>(how.flush_seconds);
    for (;;) {
      const bool is_last = is_closing.load(std::memory_order_acquire);
      guarded([&] {
        write_notes();
        while (write_one()) {
          if (clock::now() - flushed > most) file.flush(), flushed = clock::now();
        }
        if (clock::now() - flushed > most) file.flush(), flushed = clock::now();
      });
      if (is_last) break;
      std::unique_lock lock(guard);
      wake.wait_for(lock, std::chrono::milliseconds(2), [&] { return is_closing.load(); });
    }
    guarded([&] {
      if (end >= 0) count_lost(end), file.write_lost_up_to(end);
      if (const auto events_lost = lost_events(); events_lost > 0)
        file.note("cca.lost_events", {{"count", std::to_string(events_lost)}});
      file.note("cca.end", {{"lost_beats", std::to_string(lost_beats())}});
      file.close();
    });
  }
  // An event comes before the beat of its number. It is looked for first: the beats before it are in the ring
  // by then.
  bool write_one() {
    detail::event e;
    const bool has_event = events.look(e);
    const std::int64_t* const frame = this->ring.oldest();
    if (has_event && (!frame || e.beat <= frame[0])) {
      events.take(e, payload);
      if (!is_broken.load(std::memory_order_relaxed)) file.write(e, payload);
      return true;
    }
    if (!frame) return false;
    count_lost(frame[0]);
    next_beat = frame[0] + 1;
    if (!is_broken.load(std::memory_order_relaxed)) file.write(frame);
    this->ring.take();
    return true;
  }
  void count_lost(std::int64_t k) {
    if (next_beat >= 0 && k > next_beat) lost.fetch_add(k - next_beat, std::memory_order_relaxed);
    next_beat = k;
  }
  void write_notes() {
    std::vector<std::pair<std::string, detail::text_map>> taken;
    {
      const std::scoped_lock lock(guard);
      taken.swap(notes);
    }
    for (const auto& [name, entries] : taken) file.note(name, entries);
  }
  // What fails ends the file, not the loop.
  template <class F>
  void guarded(F f) {
    try {
      if (!is_broken.load(std::memory_order_relaxed)) f();
      else
        while (write_one()) {}
    } catch (const std::exception& e) {
      const std::scoped_lock lock(guard);
      what_failed = e.what();
      is_broken.store(true, std::memory_order_release);
    }
  }

  settings how;
  std::vector<const detail::schema*> types;      // of the parameters of each node, or null
  std::vector<std::vector<unsigned char>> told;  // of each node
  std::vector<unsigned char> scratch, payload;
  std::vector<std::string> paths = [] {
    std::vector<std::string> all;
    for (int n = 0; n < cca::detail::counts_of<Graph>.node_count; ++n)
      all.push_back(cca::detail::path_of_node<Graph>(n));
    return all;
  }();
  detail::event_ring events{1 << 20};
  detail::recording_file<Graph> file;
  controller<Graph>* of = nullptr;
  std::int64_t end = -1, next_beat = -1;
  std::atomic<std::int64_t> lost{0};
  std::atomic<bool> is_closing{false}, is_broken{false};
  mutable std::mutex guard;  // of notes and what_failed: never the loop's
  std::condition_variable wake;
  std::vector<std::pair<std::string, detail::text_map>> notes;
  std::string what_failed;
  std::thread writer;
};

template <class Controller>
recorder(Controller&, const std::string&, const settings& = {}) -> recorder<Controller>;

}  // namespace cca::recording
