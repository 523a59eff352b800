// The thread that takes the events of all loops of this process, writes them, and counts for the summary.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <cca/runtime/observers/trace_link.hpp>
#include <cca/trace/trace_file.hpp>
#include <cca/trace/trace_names.hpp>
#include <cca/trace/trace_summary.hpp>

namespace cca::detail {

class trace_writer {
public:
  trace_writer(const std::string& file, const std::string& program) : to(file) {
    to.write_name("process_name", 0, program);
  }
  ~trace_writer() { close(); }
  trace_writer(const trace_writer&) = delete;
  trace_writer& operator=(const trace_writer&) = delete;

  // Before begin().
  void add(trace_pointer& loop, trace_names names, const trace_track::room& room) {
    auto& one = loops.emplace_back(std::move(names), room, loop);
    to.write_name("thread_name", number_of(one), one.names.track);
    loop.set(&one.track);
  }
  void begin() {
    writer = std::thread([this] { write_all(); });
  }
  // Ends the trace. Not while a beat runs.
  void close() {
    if (!writer.joinable()) return;
    for (auto& one : loops)
      if (one.track.has_controller()) one.from->set(nullptr);
    is_closing.store(true, std::memory_order_release);
    wake.notify_one();
    writer.join();
  }

  // Ends it too, and leaves no file.
  void discard() {
    is_discarded = true;
    close();
  }

  // After close().
  trace_summary summary() const {
    trace_summary all;
    for (const auto& one : loops) {
      all.environments.push_back(one.seen);
      all.environments.back().lost_beats = one.track.lost_beats();
      all.environments.back().lost_marks = one.track.lost_marks();
    }
    return all;
  }
  std::int64_t lost_beats() const {
    std::int64_t all = 0;
    for (const auto& one : loops) all += one.track.lost_beats();
    return all;
  }
  std::string problem() const {
    const std::scoped_lock lock(guard);
    return what_failed;
  }

private:
  struct traced_loop {
    traced_loop(trace_names n, const trace_track::room& room, trace_pointer& of)
        : names(std::move(n)), track(room), from(&of) {
      seen.name = names.track;
      row_of_call.reserve(names.calls.size());
      for (const auto& one : names.calls) row_of_call.push_back(one.path.empty() ? 0 : row_of(one));
    }
    // Modes share rows.
    std::size_t row_of(const trace_names::call& wanted) {
      for (std::size_t row = 0; row < seen.components.size(); ++row)
        if (seen.components[row].path == wanted.path && seen.components[row].phase == wanted.phase)
          return row;
      seen.components.push_back({wanted.path, wanted.phase, {}});
      return seen.components.size() - 1;
    }

    trace_names names;
    trace_track track;
    trace_pointer* from;
    std::vector<std::size_t> row_of_call;
    std::vector<trace_event> of_beat;  // the beat itself is told last
    trace_summary::environment seen;
  };
  int number_of(const traced_loop& wanted) const {
    int number = 1;
    for (const auto& one : loops) {
      if (&one == &wanted) break;
      ++number;
    }
    return number;
  }

  void write_all() {
    using steady = std::chrono::steady_clock;
    auto flushed = steady::now();
    for (;;) {
      const bool is_last = is_closing.load(std::memory_order_acquire);
      guarded([&] {
        int number = 1;
        for (auto& one : loops) {
          one.track.take([&](const trace_event& e) { take(one, number, e); });
          ++number;
        }
        if (steady::now() - flushed > std::chrono::milliseconds(200)) to.flush(), flushed = steady::now();
      });
      if (is_last) break;
      std::unique_lock lock(guard);
      wake.wait_for(lock, std::chrono::milliseconds(2), [&] { return is_closing.load(); });
    }
    guarded([&] {
      int number = 1;
      for (auto& one : loops) {
        if (const std::int64_t lost = one.track.untold_beats(); lost > 0)
          write_lost(number, monotonic_clock::now(), monotonic_clock::now(), lost);
        ++number;
      }
      if (is_discarded) to.discard();
      else to.close();
    });
  }
  // What fails ends the file, not the loop.
  template <class F>
  void guarded(F f) {
    try {
      if (!is_broken) f();
    } catch (const std::exception& e) {
      is_broken = true;
      for (auto& one : loops) one.track.abandon();
      const std::scoped_lock lock(guard);
      what_failed = e.what();
    }
  }

  void take(traced_loop& from, int number, const trace_event& e) {
    switch (e.kind) {
      case trace_kind::firing:
        from.seen.components[from.row_of_call[array_size(e.what)]].firings.add(e.end - e.begin);
        return from.of_beat.push_back(e);
      case trace_kind::wait:
        from.seen.waits.add(e.end - e.begin);
        return from.of_beat.push_back(e);
      case trace_kind::beat:
        from.seen.beats.add(e.end - e.begin);
        return write_beat(from, number, e);
      default:
        return write_mark(from, number, e);
    }
  }

  // A beat stands before what it consists of: readers nest what begins together in this order.
  void write_beat(traced_loop& from, int number, const trace_event& beat) {
    arguments.clear();
    to.write_span("beat", "beat", number, beat.begin, beat.end,
                  arguments.add_member("beat", beat.value).view());
    for (const trace_event& e : from.of_beat) {
      if (e.kind == trace_kind::wait) {
        to.write_span("wait", "wait", number, e.begin, e.end);
      } else {
        const auto& call = from.names.calls[array_size(e.what)];
        to.write_span(call.path, call.phase, number, e.begin, e.end);
      }
    }
    from.of_beat.clear();
  }

  void write_mark(traced_loop& from, int number, const trace_event& e) {
    arguments.clear();
    switch (e.kind) {
      case trace_kind::lost:
        return write_lost(number, e.begin, e.end, e.value);
      case trace_kind::overrun:
        ++from.seen.overruns;
        arguments.add_member("periods without a beat", e.value);
        return to.write_moment("overrun", "overrun", number, e.begin, arguments.view());
      case trace_kind::late:
        ++from.seen.late;
        arguments.add_member("from", from.names.environments[array_size(e.what)]);
        return to.write_moment("late sample", "late", number, e.begin, arguments.view());
      case trace_kind::fault:
        arguments.add_member("component",
                             e.what < 0 ? std::string_view() : from.names.components[array_size(e.what)]);
        (arguments << ',').add_member("reason", std::string_view(e.reason));
        return to.write_moment("fault", "fault", number, e.begin, arguments.view());
      case trace_kind::mode:
        arguments.add_member("mode", from.names.modes[array_size(e.what)]);
        return to.write_moment("mode", "mode", number, e.begin, arguments.view());
      default:
        return to.write_moment(to_string(static_cast<state>(e.what)), "state", number, e.begin);
    }
  }
  void write_lost(int number, std::int64_t begin, std::int64_t end, std::int64_t count) {
    arguments.clear();
    to.write_span("lost beats", "lost", number, begin, end, arguments.add_member("beats", count).view());
  }

  trace_file to;
  std::deque<traced_loop> loops;
  json_text arguments;
  std::atomic<bool> is_closing{false};
  bool is_broken = false, is_discarded = false;
  mutable std::mutex guard;  // never the loop's
  std::condition_variable wake;
  std::string what_failed;
  std::thread writer;
};

}  // namespace cca::detail
