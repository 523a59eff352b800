// One loop that is recorded: what it tells goes into its own rings, wait-free, and the thread that writes
// takes it from there.
//
//   Loop    a graph, a set of modes, or the part of an environment: the key of its frames
//   Whole   what is recorded: the graph, the set of modes, the deployment
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <cca/record/file/event_ring.hpp>
#include <cca/record/file/recorded_messages.hpp>
#include <cca/record/file/settings.hpp>
#include <cca/runtime/controller.hpp>

namespace cca::recording::detail {

// The beats from `first` to `end` in which a loop writes a frame: an environment sleeps in some.
template <class Loop>
struct beats_of_loop {
  static std::int64_t count(std::int64_t first, std::int64_t end) { return end - first; }
};

// What all loops of a recording share.
template <class Whole>
struct recording_state {
  explicit recording_state(const settings& s) : how(s) {}

  settings how;
  std::optional<recorded_messages<Whole>> messages;  // the writing thread's
  std::vector<std::string> nodes;                    // their paths
  std::vector<std::string> environments{{}};         // of one loop it has no name
  std::vector<std::string> modes, parts;             // the paths of the parts
  std::atomic<std::int64_t> lost{0};                 // beats
  std::atomic<std::uint64_t> told{0};                // events
};

// A loop, as the thread sees it that writes.
class loop_source {
public:
  virtual ~loop_source() = default;
  // Looks for the oldest item. The beat to which it belongs; or, if there is none, one before which no other
  // will come.
  virtual std::int64_t look() = 0;
  virtual bool has_item() const = 0;
  virtual bool is_event() const = 0;
  // Of the item, among those of its beat: events come first, in the order in which they were told.
  virtual std::uint64_t order() const = 0;
  virtual bool is_full() const = 0;  // almost
  // Whether all that was there at the mark has been written, as of the last look.
  virtual void set_mark() = 0;
  virtual bool has_passed_mark() = 0;
  virtual void write_item() = 0;
  virtual void write_lost_up_to(std::int64_t end) = 0;
  virtual std::int64_t lost_events() const = 0;
};

template <class Loop, class Whole>
class recorded_loop final : public loop_source, public cca::detail::beat_tap<Loop> {
  using tap = cca::detail::beat_tap<Loop>;
  static constexpr std::int64_t period = cca::detail::counts_of<Whole>.period;

public:
  recorded_loop(recording_state<Whole>& all,
                const std::vector<const schema*>& types,
                int number,
                std::int64_t k)
      : tap(frames(all.how)), of(all), environment(number), expected(k) {
    std::size_t most = 64;
    for (const schema* type : types) {
      const std::size_t bytes = type ? 16 + most_bytes(*type) : 0;
      told.emplace_back();
      told.back().reserve(bytes);
      most = std::max(most, bytes);
    }
    scratch.resize(most + 512);
    this->reach(k);
  }

  bool has_controller() const { return !is_gone; }

  // ---- in the thread of the loop ----

  void parameters_changed(const cca::detail::controller_state<Loop>& state,
                          std::int64_t k) noexcept override {
    cca::detail::visit_components<Loop>(
        [&]<class C>(int node, const C& component) {
          if constexpr (HasParameters<C>) tell(node, component.p, k);
        },
        state);
  }
  void moved(state to, std::int64_t k) noexcept override {
    cdr_writer message(scratch);
    put({event_kind::state, -1, k}, message.add(k).add(to_string(to)).view());
  }
  void failed(int node, const char* reason, std::int64_t k) noexcept override {
    const std::string_view path =
        node < 0 ? std::string_view() : std::string_view(of.nodes[cca::detail::array_size(node)]);
    cdr_writer message(scratch);
    message.add(k).add(path.substr(0, 200)).add(std::string_view(reason).substr(0, 250));
    put({event_kind::fault, node, k}, message.view());
  }
  void switched(int mode, bool requested, std::int64_t k) noexcept override {
    cdr_writer message(scratch);
    message.add(k).add(std::string_view(of.modes[cca::detail::array_size(mode)]).substr(0, 200));
    put({event_kind::mode, -1, k}, message.add(std::uint8_t{requested}).view());
  }
  void part_changed(int part, bool stops, bool requested, std::int64_t k) noexcept override {
    cdr_writer message(scratch);
    message.add(k).add(std::string_view(of.parts[cca::detail::array_size(part)]).substr(0, 200));
    put({event_kind::part, -1, k}, message.add(std::uint8_t{stops}).add(std::uint8_t{requested}).view());
  }
  void runs_freely(std::int64_t k, bool freely) noexcept override {
    if (!freely && !ran_freely) return;
    ran_freely = freely;
    cdr_writer message(scratch);
    put({event_kind::freely, -1, k}, message.add(k).add(std::uint8_t{freely}).view());
  }
  void late(int from, std::int64_t k) noexcept override {
    cdr_writer message(scratch);
    message.add(k).add(name()).add(
        std::string_view(of.environments[cca::detail::array_size(from)]).substr(0, 200));
    put({event_kind::late, -1, k}, message.view());
  }
  void skipped(std::int64_t k, std::int64_t count, bool by_clock) noexcept override {
    cdr_writer message(scratch);
    message.add(k).add(count).add(name());
    put({event_kind::skipped, by_clock ? 1 : 0, k}, message.view());
  }
  void controller_is_gone() noexcept override { is_gone = true; }
  void has_no_room() noexcept override {
    for (; of.how.waits; std::this_thread::sleep_for(std::chrono::microseconds(100)))
      if (this->ring.commit_last()) return;
    this->ring.drop();
  }

  // ---- in the thread that writes ----

  // Events of beat k come before its frame. When a frame or an event can be read, so can all that was
  // written before it.
  std::int64_t look() override {
    const std::int64_t reached = this->reached();
    frame = this->ring.oldest();
    has_event = events.look(oldest);
    if (has_event && !frame) frame = this->ring.oldest();
    if (has_event && frame && oldest.beat > frame[0]) has_event = false;
    return has_event ? oldest.beat : frame ? frame[0] : reached;
  }
  bool has_item() const override { return has_event || frame; }
  bool is_event() const override { return has_event; }
  std::uint64_t order() const override { return has_event ? oldest.order : after_events; }
  bool is_full() const override { return this->ring.is_almost_full(); }
  void set_mark() override { mark = this->ring.frame(); }
  bool has_passed_mark() override {
    if (!frame || frame == mark) mark = nullptr;
    return !mark;
  }
  void write_item() override {
    if (has_event) {
      events.take(oldest, payload);
      if (oldest.kind == event_kind::skipped) return skip();
      of.messages->write(oldest, payload);
      return;
    }
    write_lost_up_to(frame[0]);
    expected = frame[0] + 1;
    of.messages->write(frame, cca::detail::frame_layout_of<Loop>);
    this->ring.take();
  }
  void write_lost_up_to(std::int64_t end) override {
    if (const std::int64_t beats = beats_of_loop<Loop>::count(expected, end); beats > 0 && end > expected) {
      of.lost.fetch_add(beats, std::memory_order_relaxed);
      of.messages->write_lost(expected, beats, name());
    }
    expected = std::max(expected, end);
  }
  std::int64_t lost_events() const override { return events.lost_events(); }

private:
  static constexpr auto after_events = std::numeric_limits<std::uint64_t>::max();

  bool put(event e, std::span<const unsigned char> message) noexcept {
    e.order = of.told.fetch_add(1, std::memory_order_relaxed);
    return events.put(e, message);
  }
  static std::size_t frames(const settings& s) {
    constexpr double bytes = 8.0 * cca::detail::frame_layout_of<Loop>.words;
    const double wanted = std::max(1024.0, s.buffered_seconds * 1e9 / static_cast<double>(period));
    return static_cast<std::size_t>(std::max(2.0, std::min(wanted, (1 << 26) / bytes)));
  }
  std::string_view name() const {
    return std::string_view(of.environments[cca::detail::array_size(environment)]).substr(0, 200);
  }
  // What the clock left out was not lost here. After a fault it would not have run in one loop either.
  void skip() {
    cdr_reader from(payload);
    const auto first = from.template number<std::int64_t>();
    const auto beats = from.template number<std::int64_t>();
    write_lost_up_to(first);
    expected = std::max(expected, first + beats);
    if (oldest.node == 1 && beats_of_loop<Loop>::count(first, first + beats) > 0)
      of.messages->write(oldest, payload);
  }

  template <class Parameters>
  void tell(int node, const Parameters& p, std::int64_t k) noexcept {
    cdr_writer to(scratch);
    to.add(k);
    encode(cca::detail::schema_of<Parameters>, &p, to);
    const auto now = to.view();
    auto& last = told[cca::detail::array_size(node)];
    constexpr std::size_t head = cdr_head + 8;  // the beat does not count
    if (std::ranges::equal(std::span(last).subspan(std::min(head, last.size())), now.subspan(head))) return;
    if (put({event_kind::parameters, node, k}, now))
      last.assign(now.begin(), now.end());  // within what is reserved
  }

  recording_state<Whole>& of;
  int environment;
  std::vector<std::vector<unsigned char>> told;  // of each node
  std::vector<unsigned char> scratch;
  bool ran_freely = false;
  event_ring events{1 << 20};
  bool is_gone = false;

  std::vector<unsigned char> payload;
  event oldest{};
  const std::int64_t *frame = nullptr, *mark = nullptr;
  bool has_event = false;
  std::int64_t expected;
};

}  // namespace cca::recording::detail
