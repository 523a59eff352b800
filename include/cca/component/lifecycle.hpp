// The life-cycle of an architecture: its states, and the legal transitions as one table.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <cca/base/compiler.hpp>

namespace cca {

enum class state : std::uint8_t { created, loaded, started, running, faulted };

constexpr std::string_view to_string(state s) {
  constexpr std::array<std::string_view, 5> names{"created", "loaded", "started", "running", "faulted"};
  return names[static_cast<std::size_t>(s)];
}

namespace detail {

enum class transition : std::uint8_t { load, save, start, stop, run, pause, fail, resume };

struct transition_info {
  transition what;
  state from, to;
};

// The user calls load, save, start, stop, run and resume. The controller makes pause (the run is over) and
// fail (a component returned a fault).
inline constexpr std::array transitions{
    transition_info{transition::load, state::created, state::loaded},
    transition_info{transition::load, state::loaded, state::loaded},  // again, with other parameters
    transition_info{transition::save, state::loaded, state::created},
    transition_info{transition::start, state::loaded, state::started},
    transition_info{transition::stop, state::started, state::loaded},
    transition_info{transition::stop, state::faulted, state::loaded},
    transition_info{transition::run, state::started, state::running},
    transition_info{transition::pause, state::running, state::started},
    transition_info{transition::fail, state::started, state::faulted},  // in step()
    transition_info{transition::fail, state::running, state::faulted},
    transition_info{transition::resume, state::faulted, state::started},
};

// The same table as one set of states per transition, since `step()` checks it in every beat.
inline constexpr auto legal_from = [] {
  std::array<unsigned, 8> sets{};
  for (const auto& t : transitions)
    sets[static_cast<std::size_t>(t.what)] |= 1u << static_cast<unsigned>(t.from);
  return sets;
}();

constexpr bool is_legal(transition what, state from) {
  return (legal_from[static_cast<std::size_t>(what)] >> static_cast<unsigned>(from) & 1u) != 0;
}

constexpr state after(transition what, state from) {
  for (const auto& t : transitions)
    if (t.what == what && t.from == from) return t.to;
  return from;
}

// What to do instead of an illegal transition.
constexpr std::string_view remedy(transition what, state from) {
  if (from == state::faulted) return "a component has faulted: look at fault(), then resume() or stop()";
  switch (what) {
    case transition::load:
      return "stop() it first";
    case transition::save:
      return from == state::created ? "load() it first" : "stop() it first";
    case transition::start:
      return from == state::created ? "load() it first" : "it has been started already";
    case transition::resume:
      return "nothing has faulted";
    default:
      return from == state::created  ? "load() and start() it first"
             : from == state::loaded ? "start() it first"
                                     : "it is running";
  }
}

}  // namespace detail
}  // namespace cca
