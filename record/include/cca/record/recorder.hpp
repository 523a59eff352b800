// Records a controller into an MCAP file, from now on until it is destroyed or closed.
//
//   cca::controller<trot> c;                       // struct trot : cca::graph<...>, cca::recordable {};
//   cca::recording::recorder recording(c, "trot.mcap");
//   c.load(); c.start(); c.run(...);
//
// It is made from the controller of a graph or of a set of modes, or from a cca::deployed: then one file has
// all environments of this process, in the order of the beats. A thread of its own compresses and writes. A
// beat copies what is published into a ring of its own loop: no allocation, no lock, no wait, no system call.
// To be replayed, a recording must begin before the first beat.
//
// Until close() it is written to trot.mcap.part, and an older trot.mcap stays. A program that crashes leaves
// the part, which can be read and replayed up to its last second (base/system/output_file.hpp).
//
// Without a file it gives its messages to the sinks that are added: a door (docs/door.md). A file may begin
// and end meanwhile.
//
// Errors: std::system_error if the file can't be opened, cca::refused for a scope without ports and if
// another program writes the file. If writing fails later, for example on a full disk, the loop goes on, and
// `problem()` says what happened and where the rest is. Threads: all
// of it for one thread, while no beat runs; note() and the counts for any. A cca::deployed must not be moved
// meanwhile. Cost of a beat: docs/recordings.md. Tests: tests/runtime/record/.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/graph/marks/unmarked.hpp>
#include <cca/base/refused.hpp>
#include <cca/record/loops/recorded_loop.hpp>
#include <cca/record/loops/recorded_loops.hpp>
#include <cca/record/file/file_sink.hpp>
#include <cca/record/file/message_outlets.hpp>
#include <cca/record/file/message_sink.hpp>
#include <cca/record/file/recorded_messages.hpp>
#include <cca/record/file/settings.hpp>
#include <cca/runtime/refusal.hpp>

namespace cca::recording {

template <class Controller>
class recorder {
  using recorded = detail::recorded_loops<Controller>;
  using whole = typename recorded::whole;
  static_assert(
      cca::detail::holds_or_tells<cca::detail::Recordable<whole>,
                                  cca::detail::unmarked<whole, cca::detail::observer::recorder>>::value);

public:
  recorder(Controller& c, const std::string& name, const settings& s = {})
      : file_name(refuse_if_recorded(c, name)), all(s), of(&c) {
    if (!s.opens_later && !file_name.empty()) file.emplace(file_name, s);
    all.messages.emplace(outlets, s, describe(c));
    if (file) outlets.add(*file);
    for (int n = 0; n < cca::detail::counts_of<whole>.node_count; ++n)
      all.nodes.push_back(cca::detail::path_of_node<whole>(n));
    all.environments = recorded::names_of_environments();
    all.modes = recorded::names_of_modes();
    for (int p = 0; p < cca::detail::parts_kept<whole>; ++p)
      all.parts.push_back(cca::detail::path_of_part<whole>(p));
    recorded::for_each(c, [&]<int Loop>() {
      auto& one = std::get<Loop>(loops);
      using loop = typename std::remove_cvref_t<decltype(one)>::element_type;
      one = std::make_unique<loop>(all, types, Loop, c.beat_index());
      sources.push_back(one.get());
    });
    if (!s.opens_later) begin();
    recorded::attach(c, loops);
    c.recorded_into()->moved(c.state(), c.beat_index());
    c.for_each_stopped_part([&](int p) { c.recorded_into()->part_changed(p, true, false, c.beat_index()); });
  }
  explicit recorder(Controller& c, const settings& s = {}) : recorder(c, std::string(), s) {}
  ~recorder() { close(); }
  recorder(const recorder&) = delete;
  recorder& operator=(const recorder&) = delete;

  // With settings::opens_later, before the first beat: until then what happens is kept in memory.
  void open() {
    if (writer.joinable() || is_closed) return;
    if (!file_name.empty()) begin_file(file_name);
    begin();
  }

  // Who else gets what is recorded. A sink that comes late gets the last message of the channels that are
  // kept. From any thread.
  void add(message_sink& one) { outlets.add(one); }
  void remove(message_sink& one) { outlets.remove(one); }

  // A file from now on, and its end. From any thread. Refused: a second file, and to end none. A file that
  // begins after the first beat can be looked at, not replayed. It ends after a whole beat of all loops, if
  // they reach one within a second; end_file() returns why it is incomplete, empty: it is whole.
  void begin_file(const std::string& name) {
    const std::scoped_lock lock(guard_of_file);
    if (file) throw refused("cca::record: " + name + " is refused: " + file_name + " is being recorded");
    file.emplace(name, all.how);
    file_name = name;
    outlets.add(*file);
  }
  std::string end_file() {
    std::unique_lock lock(guard_of_file);
    if (!file) throw refused("cca::record: nothing is being recorded into a file");
    ends_file.store(true, std::memory_order_release);  // the thread that writes knows where a beat ends
    if (writer.joinable()) file_ended.wait_for(lock, std::chrono::seconds(1), [this] { return !file; });
    if (file) end_file_in_order();
    return why_incomplete;
  }
  // Empty: none.
  std::string recorded_into() const {
    const std::scoped_lock lock(guard_of_file);
    return file ? file_name : std::string();
  }
  // Why nothing more comes into that file; empty: all is well, or there is none.
  std::string problem_of_file() const {
    const std::scoped_lock lock(guard_of_file);
    return file ? file->problem() : std::string();
  }

  // What the program wants to say about this run, as a seed: metadata of this name.
  void note(const std::string& name, const std::map<std::string, std::string>& entries) {
    const std::scoped_lock lock(guard);
    notes.emplace_back(name, entries);
  }
  void note(const std::string& name, const std::string& value) { note(name, {{"value", value}}); }

  // Ends the recording. Not while a beat runs.
  void close() {
    if (std::exchange(is_closed, true)) return;
    if (has_controller()) {
      end = of->beat_index();
      recorded::detach(*of);
    }
    if (!writer.joinable()) return;  // it was never opened
    is_closing.store(true, std::memory_order_release);
    wake.notify_one();
    writer.join();
  }
  // Ends it too, and leaves no file: an older one of this name stays.
  void discard() {
    is_discarded = true;
    close();
  }

  // Beats and events that did not fit.
  std::int64_t lost_beats() const noexcept { return all.lost.load(std::memory_order_relaxed); }
  std::int64_t lost_events() const noexcept {
    std::int64_t lost = 0;
    for (const auto* one : sources) lost += one->lost_events();
    return lost;
  }
  // Why a file, this one or an earlier one, is incomplete; empty: all is well.
  std::string problem() const {
    const std::scoped_lock lock(guard_of_file);
    return file && !file->problem().empty() ? file->problem() : what_failed;
  }

private:
  static std::string refuse_if_recorded(const Controller& c, const std::string& file) {
    if (c.recorded_into()) throw refused("cca::record: this controller is being recorded already");
    return file;
  }
  typename detail::recorded_messages<whole>::contents describe(Controller& c) {
    typename detail::recorded_messages<whole>::contents what;
    c.for_each_component([&]<class C>(std::string_view, const C&) {
      if constexpr (HasParameters<C>) types.push_back(&cca::detail::schema_of<typename C::parameters>);
      else types.push_back(nullptr);
    });
    what.parameters = types;
    what.nodes = recorded::nodes_here(c);
    for (int o = 0; o < cca::detail::counts_of<whole>.output_count; ++o)
      what.outputs.push_back(what.nodes[cca::detail::array_size(cca::detail::node_of_output<whole>(o))]);
    recorded::add_outputs_of_others(c, what.outputs);
    recorded::describe(c, what.environments, what.modes);
    return what;
  }
  // It may be destroyed, or have got the value of another one.
  bool has_controller() const {
    return std::apply([](const auto&... one) { return ((!one || one->has_controller()) && ...); }, loops);
  }

  void begin() {
    writer = std::thread([this] { write_all(); });
  }

  // ---- in the thread that writes ----

  void write_all() {
    using clock = std::chrono::steady_clock;
    auto flushed = clock::now();
    const auto most = std::chrono::duration<double>(all.how.flush_seconds);
    const auto flush = [&] {
      if (clock::now() - flushed > most) outlets.flush(), flushed = clock::now();
    };
    for (;;) {
      const bool is_last = is_closing.load(std::memory_order_acquire);
      write_notes();
      while (write_one(is_last)) flush();
      outlets.hand_over();
      flush();
      if (is_last) break;
      std::unique_lock lock(guard);
      wake.wait_for(lock, all.how.looks_every, [&] { return is_closing.load(); });
    }
    const std::scoped_lock lock(guard_of_file);
    if (is_discarded) {
      if (file) file->discard();
      return;
    }
    for (auto* one : sources)
      if (end >= 0) one->write_lost_up_to(end);
    if (file) end_file_in_order();
  }
  void end_file_in_order() {
    outlets.remove(*file);
    if (const auto events_lost = lost_events(); events_lost > 0)
      file->metadata("cca.lost_events", {{"count", std::to_string(events_lost)}});
    file->metadata("cca.end", {{"lost_beats", std::to_string(lost_beats())}});
    file->close();
    why_incomplete = file->problem();
    if (what_failed.empty()) what_failed = why_incomplete;
    file.reset();
    ends_file.store(false, std::memory_order_relaxed);
    is_marked.store(false, std::memory_order_relaxed);
    file_ended.notify_all();
  }
  // `reached`: no sample of an earlier beat will come. What was there when the end was asked for is written.
  void end_file_after_beat(std::int64_t reached) {
    if (!ends_file.load(std::memory_order_acquire)) return;
    if (!is_marked.exchange(true, std::memory_order_relaxed))
      for (auto* one : sources) one->set_mark();
    bool is_past = reached > last_beat;
    for (auto* one : sources) is_past = one->has_passed_mark() && is_past;
    if (!is_past) return;
    const std::scoped_lock lock(guard_of_file);
    if (file && ends_file.load(std::memory_order_relaxed)) end_file_in_order();
  }
  // The oldest item of all loops. A loop that is behind is waited for, unless the ring of another one gets
  // full meanwhile. False: there is none yet.
  bool write_one(bool is_last) {
    detail::loop_source* oldest = nullptr;
    std::pair<std::int64_t, std::uint64_t> first;  // its beat, and where it comes in it
    std::int64_t earliest = std::numeric_limits<std::int64_t>::max();
    bool is_urgent = is_last;
    const auto look_at = [&](detail::loop_source* one) {
      const std::int64_t beat = one->look();
      earliest = std::min(earliest, beat);
      is_urgent = is_urgent || one->is_full();
      const std::pair next(beat, one->order());
      if (one->has_item() && (!oldest || next < first)) oldest = one, first = next;
    };
    for (auto* one : sources) look_at(one);
    end_file_after_beat(earliest);
    if (!oldest || (first.first > earliest && !is_urgent)) return false;
    // load() tells each loop of its parameters and then the first one of the state. Who saw the state before
    // the parameters sees them now.
    if (oldest->is_event())
      for (auto* one : sources)
        if (one != oldest) look_at(one);
    if (!oldest->is_event()) last_beat = first.first;
    oldest->write_item();
    return true;
  }
  void write_notes() {
    std::vector<std::pair<std::string, detail::text_map>> taken;
    {
      const std::scoped_lock lock(guard);
      taken.swap(notes);
    }
    for (const auto& [name, entries] : taken) all.messages->note(name, entries);
  }
  std::vector<const detail::schema*> types;  // of the parameters of each node, or null
  std::string file_name;
  detail::message_outlets outlets;
  std::optional<detail::file_sink> file;
  detail::recording_state<whole> all;
  typename recorded::loops loops;
  std::vector<detail::loop_source*> sources;
  Controller* of;
  std::int64_t end = -1, last_beat = -1;  // last_beat: of which a sample was written
  bool is_closed = false, is_discarded = false;
  std::atomic<bool> is_closing{false}, ends_file{false}, is_marked{false};
  mutable std::mutex guard, guard_of_file;  // of notes; of file, its name and problems: never the loops'
  std::condition_variable wake, file_ended;
  std::vector<std::pair<std::string, detail::text_map>> notes;
  std::string what_failed, why_incomplete;  // the first file that failed; the last file that has ended
  std::thread writer;
};

// Of a controller that breaks a rule: the message is the controller's.
template <cca::detail::Refused Controller>
class recorder<Controller> {
public:
  recorder(Controller&, const std::string&, const settings& = {}) {}
  explicit recorder(Controller&, const settings& = {}) {}
  ~recorder() {}
  recorder(const recorder&) = delete;
  recorder& operator=(const recorder&) = delete;
  void open() {}
  void add(message_sink&) {}
  void remove(message_sink&) {}
  void begin_file(const std::string&) {}
  std::string end_file() { return {}; }
  std::string recorded_into() const { return {}; }
  std::string problem_of_file() const { return {}; }
  void note(const std::string&, const std::map<std::string, std::string>&) {}
  void note(const std::string&, const std::string&) {}
  void close() {}
  void discard() {}
  std::int64_t lost_beats() const noexcept { return 0; }
  std::int64_t lost_events() const noexcept { return 0; }
  std::string problem() const { return {}; }
};

template <class Controller>
recorder(Controller&, const std::string&, const settings& = {}) -> recorder<Controller>;
template <class Controller>
recorder(Controller&, const settings& = {}) -> recorder<Controller>;

}  // namespace cca::recording
