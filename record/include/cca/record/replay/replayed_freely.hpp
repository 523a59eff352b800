// A component of a free-running environment in a replay: it computes, as in one loop, until the recording
// says that it ran in a wall-clock run. From then on its results depended on the machine, so it publishes
// what was recorded, in the beats in which that arrived.
#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/record/replay/replayed_results.hpp>

namespace cca::recording::detail {

template <class Component, class Function>
struct plays_freely;
template <class Component, class Result, class... Parameters>
struct plays_freely<Component, cca::detail::list<Result, Parameters...>> : Component {
  using results = irregular_result<Result>;

  results process(Parameters... inputs) {
    if (is_playing) return next;
    return make_irregular(Component::process(inputs...));
  }

  void begin_playing() {
    is_playing = true;
    forget();
  }
  bool plays() const { return is_playing; }
  // As of `replayed`.
  void forget() { next = {}; }
  void put(cca::detail::phase_of_beat, int port, std::int64_t origin, const double* coordinates) {
    if (is_playing) put_result(next, port, origin, coordinates);
  }
  void fail(const char* reason) {
    if (is_playing) fail_result(next, reason);
  }

private:
  results next{};
  bool is_playing = false;
};

// One that publishes nothing rests.
template <class Component, class... Parameters>
struct plays_freely<Component, cca::detail::list<void, Parameters...>> : Component {
  void process(Parameters... inputs) {
    if (!is_playing) Component::process(inputs...);
  }
  void begin_playing() { is_playing = true; }
  bool plays() const { return is_playing; }

private:
  bool is_playing = false;
};

template <class Component>
using replayed_freely = plays_freely<Component, signature_of<decltype(&Component::process)>>;

}  // namespace cca::recording::detail
