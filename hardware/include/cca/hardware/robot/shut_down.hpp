// Stops the robot of a controller in order: the one line at the end of a program, after its last run, a fault
// or a signal.
//
//   const auto report = cca::hardware::shut_down(controller);   // in a wall-clock run
//   std::puts(report.text().c_str());
//
// It calls stop() where that is still to do, and then step() once a period: the drives damp, then they are
// disabled, and each frame is repeated until each drive has confirmed or the time is over: 1 s and 0.5 s
// (stop_sequence.hpp). The report names the joints whose drives confirmed, and those whose drives did not:
// switch their supply off.
//
//   Controller   of a graph with the synchronizer of a robot on drives, at any path
//   Pace         begin() and wait(ns), as in cca/runtime/pace.hpp. A program that plays the drives itself, in
//                virtual time, lets them run in wait()
//
// It throws nothing, and allocates the report. Example: tests/runtime/drive_chain/start_and_stop.cpp.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <cca/component/lifecycle.hpp>
#include <cca/runtime/pace.hpp>
#include <cca/runtime/signals/stop_progress.hpp>

namespace cca::hardware {

struct shut_down_report {
  std::vector<std::string> confirmed{};    // the joints whose drives said that they are off
  std::vector<std::string> unconfirmed{};  // those whose drives did not
  std::int64_t beats = 0;                  // that it took

  bool complete() const { return unconfirmed.empty(); }
  std::string text() const {
    const std::string off = confirmed.empty() ? "" : "; confirmed by: " + listed(confirmed);
    if (complete()) return "all drives are off" + off;
    return "not confirmed to be off: " + listed(unconfirmed) + "; switch the supply of the drives off" + off;
  }

private:
  static std::string listed(const std::vector<std::string>& joints) {
    std::string names;
    for (const std::string& name : joints) names += (names.empty() ? "" : ", ") + name;
    return names;
  }
};

namespace detail {

template <class Component> concept StopsDrives = requires(const Component& c) {
  { c.stopping() } -> std::same_as<bool>;
  { c.unconfirmed(Component::count) } -> std::same_as<bool>;
};

// f(synchronizer) for each in the controller.
template <class Controller, class F>
void for_each_synchronizer(const Controller& controller, F f) {
  controller.for_each_component([&]<class C>(std::string_view, const C& component) {
    if constexpr (StopsDrives<C>) f(component);
  });
}

}  // namespace detail

template <class Controller, class Pace = cca::at_speed>
shut_down_report shut_down(Controller& controller, Pace pace = cca::at_wall_clock()) {
  if (controller.state() == cca::state::started || controller.state() == cca::state::faulted)
    controller.stop();
  const auto is_stopping = [&] {
    bool any = false;
    detail::for_each_synchronizer(controller, [&](const auto& s) { any = any || s.stopping(); });
    return any;
  };
  shut_down_report report;
  pace.begin();
  while (is_stopping()) {
    pace.wait(report.beats * Controller::period());
    controller.step();
    cca::stopping_goes_on();
    ++report.beats;
  }
  detail::for_each_synchronizer(controller, [&]<class S>(const S& s) {
    for (std::size_t i = 0; i < S::count; ++i)
      (s.unconfirmed(i) ? report.unconfirmed : report.confirmed).emplace_back(S::name_of(i));
  });
  return report;
}

}  // namespace cca::hardware
