// The part of an environment's loop that serves free-running ones, in a wall-clock run. `Loop` is the loop.
//
//   cycles_of        of a free-running environment: cycles without pause instead of beats
//   admission_of     of the first environment: what they publish enters its beats
//
// Other loops have nothing of it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include <cca/base/separate/function_ref.hpp>
#include <cca/runtime/environments/loop/free_arrivals.hpp>
#include <cca/runtime/environments/links/links_of_environment.hpp>
#include <cca/runtime/pace.hpp>
#include <cca/runtime/observers/tell_recorder.hpp>

namespace cca::detail {

// How often the other process is asked whether it still lives, although this environment never waits for it,
// ns.
inline constexpr std::int64_t most_trust = 10'000'000;

template <class Loop, class D, int E, bool IsFree = is_free_running<D, E>>
class cycles_of {
public:
  // What its samples are numbered by: beats, or the cycles of a free-running environment.
  std::int64_t index() const { return loop().k; }
  // What happens now comes before this beat.
  std::int64_t next_beat() const { return loop().k; }

protected:
  std::int64_t beat_that_begins() const { return loop().k; }
  void begin_cycle(std::int64_t) noexcept {}
  void skip_indices(std::int64_t) noexcept {}

private:
  const Loop& loop() const { return static_cast<const Loop&>(*this); }
};

template <class Loop, class D, int E>
class cycles_of<Loop, D, E, true> {
public:
  std::int64_t index() const { return loop().state.index; }
  std::int64_t next_beat() const {
    return is_on_a_clock() ? std::max(loop().k, loop().begun() + 1) : loop().k;
  }

protected:
  // A cycle begins in the newest beat.
  std::int64_t beat_that_begins() { return loop().state.is_exact ? loop().k : loop().begun(); }
  void begin_cycle(std::int64_t beat) noexcept { loop().state.begin_cycle(beat); }
  void skip_indices(std::int64_t next) noexcept {
    if (next <= loop().k) return;
    loop().state.index += next - loop().k;
    loop().state.beat = next - 1;
  }

  // From the first beat of the run on, until its last one is done.
  template <class AfterCycle>
  void run_freely(std::int64_t end, AfterCycle after_cycle, function_ref<void()> meanwhile) {
    if (loop().k == end || !loop().wait_for_beat(loop().k, after_cycle, meanwhile)) return;
    auto& shared = loop().shared();
    const auto is_over = [&] {
      return !loop().goes_on() || shared.position(0) >= exchange<D>::position_of(end);
    };
    std::int64_t asked_at = 0;
    while (!is_over()) {
      // A pause of the first environment is one of all. It may go on without a further beat only at the end.
      // While all parts are stopped nothing can happen before the next beat.
      if (const std::int64_t next = loop().begun() + 1;
          next < end &&
          (shared.environments[0].is_paused.load(std::memory_order_acquire) || is_stopped_wholly()))
        if (!loop().wait_for_beat(next, after_cycle, meanwhile)) return;
      run_cycle();
      if (loop().active_at - asked_at > most_trust) {
        asked_at = loop().active_at;
        loop().state.look_for(0, loop().position(), is_over);
      }
      if (!after_cycle()) loop().stop();
    }
  }
  // After a run, before beat `next`. Cycles are no beats, so none was left out.
  void end_cycles(std::int64_t next) {
    auto& state = loop().state;
    if (state.index > 0) loop().in_mode([&]<class Part>() { repeat_outputs<Part>(state, state.index - 1); });
    if (next > loop().k) loop().tell_skipped(loop().k, next - loop().k, false);
    loop().k = loop().done = next;
    loop().tell_reached();
  }

private:
  void run_cycle() noexcept {
    auto& own = loop().own();
    loop().active_at = monotonic_clock::now();
    own.slowest.begin(loop().begun(), loop().active_at);
    loop().run_beat();
    const std::int64_t needed = monotonic_clock::now() - loop().active_at;
    own.duration.add(needed);
    own.slowest.end(loop().state.beat, needed);
    loop().state.ring();
    loop().tell_reached();
  }
  // A mode may have no component of it.
  bool is_stopped_wholly() const {
    bool rests = false;
    loop().in_mode([&]<class Part>() {
      if constexpr (parts_kept<Part> > 0 || DeploymentOfModes<D>) {
        rests = true;
        for (const component_node& node : plan_of<Part>.nodes)
          rests = rests && (!node.item || node.place != E || is_resting<Part>(node.part));
      }
    });
    return rests;
  }
  template <class Part>
  bool is_resting([[maybe_unused]] int part) const {
    if constexpr (parts_kept<Part> > 0) return part >= 0 && loop().state.parts[array_size(part)].rests;
    else return false;
  }
  bool is_on_a_clock() const { return loop().state.shared && !loop().state.is_exact; }
  Loop& loop() { return static_cast<Loop&>(*this); }
  const Loop& loop() const { return static_cast<const Loop&>(*this); }
};

template <class Loop, class D, int E, bool Admits = E == 0 && has_free_running<D>>
class admission_of {
protected:
  void begin_admission() noexcept {}
  static bool admit() noexcept { return true; }
  static void note_mode(int, int, std::int64_t) noexcept {}
  void tell_arrivals(std::int64_t*) noexcept {}
  void look_for_free(std::int64_t) noexcept {}
};

template <class Loop, class D, int E>
class admission_of<Loop, D, E, true> {
public:
  // For `arrivals`.
  template <int Output, class Result>
  bool arrives([[maybe_unused]] const Result& result) const noexcept {
    if constexpr (DeploymentOfModes<D>)
      return has_mode(modes_of_output(Output), loop().mode()) && result.began_in >= came_in[Output];
    else return true;
  }

protected:
  // Of a run.
  void begin_admission() noexcept {
    if (loop().state.is_exact) arrivals.forget(loop().shared());
  }
  // Of a beat. False: contact was lost before.
  bool admit() noexcept {
    if constexpr (DeploymentOfModes<D>)
      if (!loop().learn_mode_before_beat()) return false;
    arrivals.admit(loop().shared(), loop().k, *this);
    return true;
  }
  // What a component has published before it came is not read, as in one loop.
  void note_mode(int last, int to, std::int64_t beat) noexcept {
    for (int o = 0; o < counts_of<D>.output_count; ++o) {
      const mode_set modes = modes_of_output(o);
      if (has_mode(modes, to) && !has_mode(modes, last)) came_in[array_size(o)] = beat;
    }
  }
  // In the frame of this beat, of which they are.
  void tell_arrivals(std::int64_t* frame) noexcept {
    if (!loop().state.tap.get()) return;
    tell_gathered(frame);
    if (loop().state.is_exact) return;
    arrivals.for_each([frame]<int Output>(const auto& coordinates, std::int64_t origin) {
      tell_recorder<loop_key<D, E>>(frame, Output, coordinates, origin);
    });
  }
  // Between two beats, before the last. Nobody waits for a free-running environment, and it is never late: so
  // it is asked whether its process is there.
  void look_for_free(std::int64_t end) noexcept {
    if (loop().k >= end || loop().active_at - asked_at <= most_trust) return;
    asked_at = loop().active_at;
    for (int x = 0; x < environment_count<D>; ++x)
      if (environments_of<D>::all[array_size(x)].is_free_running)
        loop().state.look_for(x, loop().position(), [this] { return !loop().goes_on(); });
  }

private:
  Loop& loop() { return static_cast<Loop&>(*this); }
  const Loop& loop() const { return static_cast<const Loop&>(*this); }

  static mode_set modes_of_output(int o) {
    const auto& out = plan_of<D>.outputs[array_size(o)];
    return out.is_taken ? out.members : plan_of<D>.nodes[array_size(node_of_output<D>(o))].members;
  }
  // Those before the newest of each output that queues take.
  void tell_gathered(std::int64_t* frame) noexcept {
    static constexpr const auto& layout = frame_layout_of<loop_key<D, E>>;
    for (const int at : layout.earlier)
      if (at > 0) frame[at] = frame[at + 1] = 0;
    if (loop().state.is_exact) return;
    arrivals.for_each_gathered([&]<int Output>(const auto& all, std::uint64_t first, std::uint64_t missing) {
      std::int64_t* const to = frame + layout.earlier[array_size(Output)];
      std::int64_t* next = to + 2;
      to[1] = static_cast<std::int64_t>(missing);
      all.for_each_from(first, [&](const auto& one) {
        if (one.number + 1 == all.end()) return;  // it is told as any other
        ++to[0];
        *next++ = one.origin;
        std::memcpy(next, one.coordinates.data(), sizeof one.coordinates);
        next += one.coordinates.size();
      });
    });
  }

  free_arrivals<D> arrivals{};
  std::int64_t asked_at = 0;
  // Of a set of modes: the beat in which the component of an output came.
  std::array<std::int64_t, DeploymentOfModes<D> ? array_size(counts_of<D>.output_count + 1) : 1> came_in{};
};

}  // namespace cca::detail
