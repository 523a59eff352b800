// What a door asks, done on a controller that runs: by cca::live_access and the pause and speed of its run.
//
//   Controller   cca::controller of a graph or a set of modes, or cca::deployed
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/array_size.hpp>
#include <cca/base/refused.hpp>
#include <cca/base/separate/function_ref.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/config.hpp>
#include <cca/door/controls.hpp>
#include <cca/door/offered_commands.hpp>
#include <cca/door/parameter_list.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/graph/layout/nodes_by_path.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/main/end_of_run.hpp>
#include <cca/runtime/observers/run_command.hpp>
#include <cca/record/messages/architecture_text.hpp>
#include <cca/record/recorder.hpp>
#include <cca/runtime/environments/figures.hpp>
#include <cca/runtime/live/live_access.hpp>

namespace cca::detail {

template <class Controller>
class live_controls final : public door_controls {
  using graph = typename graph_of_controller<Controller>::type;
  using what = door_request::what;

public:
  using figures_now = std::function<std::vector<environment_figures>()>;

  // `figures`: of the environments, from any thread; empty: none.
  live_controls(live_access<Controller>& of,
                run_control& run,
                recording::recorder<Controller>& recorder,
                std::vector<run_command<Controller>> offers,
                std::string program,
                double speed_at_start,
                figures_now figures)
      : live(of),
        control(run),
        recorded(recorder),
        commands(std::move(offers)),
        measured(std::move(figures)),
        speed(speed_at_start) {
    told.program = std::move(program);
    told.architecture = recording::detail::architecture_text<graph>();
    for (int n = 0; n < counts_of<graph>.node_count; ++n) told.nodes.push_back(path_of_node<graph>(n));
    for (int p = 0; p < parts_kept<graph>; ++p) told.parts.push_back(path_of_part<graph>(p));
    if constexpr (Modes<graph>)
      for (int m = 0; m < mode_count<graph>; ++m)
        told.modes.emplace_back(live_components::mode_name<Controller>(m));
    told.commands = commands.described();
    add_tests(std::make_integer_sequence<int, counts_of<graph>.node_count>{});
  }

  const door_description& description() const override { return told; }

  // As of the last look; the loop looks again after its next beat.
  door_status status() const override {
    want_a_look();
    door_status now;
    now.state = to_string(live.state());
    now.beat = live.beat_index();
    now.overruns = live.overruns();
    now.period = Controller::period();
    now.is_paused = control.is_paused();
    now.speed = control.has_refused_speed() ? 0 : speed;
    if constexpr (Modes<graph>) now.mode = live.mode();
    if (const fault why = live.fault()) now.fault = why.reason();
    {
      const std::scoped_lock lock(guard);
      if (!now.fault.empty()) now.fault_path = path_of_fault;
      if (live.beat_index() == told_at) now.causes = causes;
    }
    now.recording = recorded.recorded_into();
    now.recording_problem = recording_problem();
    return now;
  }
  std::string recording_problem() const override { return recorded.problem_of_file(); }

  std::vector<door_environment> environments() const override {
    std::vector<door_environment> all;
    if (!measured) return all;
    const auto seconds = [](std::int64_t nanoseconds) { return 1e-9 * static_cast<double>(nanoseconds); };
    for (const environment_figures& one : measured()) {
      door_environment& to = all.emplace_back();
      to.name = one.name;
      to.beats = one.beat.count();
      to.overruns = one.overruns;
      to.lost_periods = one.lost_periods;
      for (const auto& channel : one.channels) to.late += channel.late;
      to.beat_mean = seconds(one.beat.quantile(0.5));
      to.beat_p99 = seconds(one.beat.quantile(0.99));
      to.beat_most = seconds(one.beat.most());
      to.wake_up_mean = seconds(one.wake_up.quantile(0.5));
      to.wake_up_p99 = seconds(one.wake_up.quantile(0.99));
      to.wake_up_most = seconds(one.wake_up.most());
    }
    return all;
  }

  std::optional<std::vector<door_parameter>> parameters() override {
    std::optional<std::vector<door_parameter>> all;
    live.read([&](const auto& known) { all = door_parameters(values_of_components(known)); });
    return all;
  }

  door_outcome begin(const door_request& request) override {
    const at_the_end looked_at{[this] { want_a_look(); }};
    try {
      return begin_checked(request);
    } catch (const std::exception& e) { return {door_outcome::how::refused, e.what()}; }
  }

  door_outcome outcome() override {
    const bool has_looked = !wanted[array_size(the_run)].load(std::memory_order_acquire);
    want_a_look();
    if (begun == about::anew) {
      const std::int64_t k = live.beat_index();
      const auto went = control.anew.how_it_went(k, live.state() == state::faulted);
      using is = begun_anew::answer::kind;
      return went.is == is::nothing   ? door_outcome{door_outcome::how::begun, {}}
             : went.is == is::refused ? door_outcome{door_outcome::how::refused, went.why}
                                      : door_outcome{};
    }
    const bool has_effect = begun == about::command ? commands.is_taken()
                            : begun == about::pause
                                ? control.is_paused() || (has_looked && live.state() != state::running)
                                : live.is_taken();
    if (!has_effect) return {door_outcome::how::begun, {}};
    if (begun == about::command && !commands.failure().empty())
      return {door_outcome::how::refused, commands.failure()};
    if (begun != about::request) return {};
    if (const std::string by = live.refused_by(); !by.empty())
      return {door_outcome::how::refused, "`" + by + "` refuses it for now"};
    return {};
  }

  void note(std::string_view client, std::string_view changed) override {
    recorded.note("cca.door", {{"beat", std::to_string(live.beat_index())},
                               {"client", std::string(client)},
                               {"what", std::string(changed)}});
  }

  // A sentence of what has ended the run through the door; empty: nothing. Any thread.
  std::string ended_by() const {
    const std::scoped_lock lock(guard);
    return cause_of_end;
  }

  // ---- a loop's, between two beats ----

  // Whether the door has asked for something since this loop's last look: so a beat after which nothing is
  // asked costs one number. `looker`: an environment; `the_run`: whoever gives the beat.
  static constexpr int the_run = live_loops<Controller>::count;
  bool is_wanted(int looker) noexcept {
    auto& one = wanted[array_size(looker)];
    if (!one.load(std::memory_order_relaxed)) [[likely]]
      return false;
    return one.exchange(false, std::memory_order_acquire);
  }
  void obey(Controller& c) { commands.obey(c); }
  void end(Controller& c) {
    commands.end(c);
    if (!told.tests.empty())
      c.for_each_component([]<class Component>(std::string_view, Component& component) {
        if constexpr (TestNode<Component>) component.end_test();
      });
  }
  // Where there is no beat: what has stopped it, once for each beat.
  void tell_causes(const Controller& c) {
    if (c.beat_index() == told_of && c.state() == told_in) return;
    told_of = c.beat_index(), told_in = c.state();
    std::vector<std::string> now = causes_of(c);
    const std::scoped_lock lock(guard);
    causes = std::move(now), path_of_fault = c.fault_path(), told_at = told_of;
  }

private:
  template <int... Node>
  void add_tests(std::integer_sequence<int, Node...>) {
    (add_test<typename node_types<graph, Node>::component>(Node), ...);
  }
  template <class Component>
  void add_test([[maybe_unused]] int node) {
    if constexpr (TestNode<Component>) {
      using space = typename Component::space;
      const std::string path = path_of_node<graph>(node);
      const std::size_t scope = path.rfind('.') + 1;
      door_test_input one{.input = path.substr(0, scope) + std::string(Component::tested), .node = path};
      one.unit = space::domain::quantity::unit;
      for (int axis = 0; axis < space::axes::count; ++axis)
        one.axes.emplace_back(space_of<space>.labels[axis]);
      one.most = Component::most;
      told.tests.push_back(std::move(one));
    }
  }
  void want_a_look() const noexcept {
    for (auto& one : wanted) one.store(true, std::memory_order_release);
  }
  static door_outcome begun_if(bool is_begun) {
    return {is_begun ? door_outcome::how::begun : door_outcome::how::busy, {}};
  }

  door_outcome begin_checked(const door_request& request) {
    begun = about::request;
    switch (request.about) {
      case what::set:
        return begun_if(live.change([&](auto set) {
          for (const auto& [path, value] : request.values) set(path, given_value_of_door(value));
        }));
      case what::load:
        return begun_if(live.load(request.text, request.scope));
      case what::save:
        return {live.save(request.text, request.scope) ? door_outcome::how::done : door_outcome::how::busy,
                {}};
      case what::stop_part:
        return begun_if(live.stop(request.text));
      case what::start_part:
        return begun_if(live.start(request.text));
      case what::switch_mode:
        if constexpr (Modes<graph>) return begun_if(live.switch_to(request.text));
        else return {door_outcome::how::refused, "this program has no modes: it is one graph"};
      case what::call:
      case what::release:
        return call(request);
      case what::pause:
        check_gives_beat("pause");
        control.pause();
        begun = about::pause;
        return {door_outcome::how::begun, {}};
      case what::resume:
        return begin_anew(begun_anew::wish::resume);
      case what::start:
        return begin_anew(begun_anew::wish::start);
      default:
        command_run(request);
        return {};
    }
  }
  door_outcome begin_anew(begun_anew::wish wish) {
    if (control.anew.is_wanted()) return {door_outcome::how::busy, {}};
    if (std::string why = control.ask_anew(wish); !why.empty())
      return {door_outcome::how::refused, std::move(why)};
    begun = about::anew;
    return {door_outcome::how::begun, {}};
  }
  void check_gives_beat(const char* asked) const {
    if (!live.gives_beat())
      throw refused(std::string(asked) +
                    ": another process runs the environment that gives the beat: ask the door of that one");
  }
  door_outcome call(const door_request& request) {
    if (!commands.is_taken()) return {door_outcome::how::busy, {}};
    if (std::string why = commands.ask(request, control.is_paused() || control.anew.rests()); !why.empty())
      return {door_outcome::how::refused, why};
    begun = about::command;
    return {door_outcome::how::begun, {}};
  }
  void command_run(const door_request& request) {
    switch (request.about) {
      case what::go_on:
        check_gives_beat("go_on");
        if (control.anew.holds_fault())
          throw refused("go_on: a fault has stopped it: `resume` goes on, `start` begins anew");
        return control.go_on();
      case what::step:
        check_gives_beat("step");
        if (control.anew.holds_fault())
          throw refused("step: a fault has stopped it: `resume` goes on, in a pause by one beat");
        if (!control.is_pause_wanted()) throw refused("step: the run is not paused: pause it first");
        if (!(request.number >= 1 && request.number <= 1e6))
          throw refused("step: expected a number of beats from 1 to 1000000");
        for (double n = 0; n < request.number; ++n) control.step();
        return;
      case what::end_steps:
        return control.end_steps();
      case what::speed:
        check_gives_beat("speed");
        if (!(request.number >= 1e-3 && request.number <= 1e3))
          throw refused("speed: expected a factor from 0.001 to 1000: 0.5 is half as fast as the clock");
        if (speed == 0) throw refused("speed: this is a fast run, which has none");
        control.set_speed(request.number);
        speed = request.number;
        return;
      case what::record:
        return recorded.begin_file(request.text);
      case what::end_recording:
        if (const std::string why = recorded.end_file(); !why.empty())
          throw refused("the recording has ended, and is incomplete: " + why);
        return;
      default: {
        const std::scoped_lock lock(guard);
        if (cause_of_end.empty()) cause_of_end = request.text;  // before the loop can end
        return live.end_run();
      }
    }
  }

  live_access<Controller>& live;
  run_control& control;
  recording::recorder<Controller>& recorded;
  offered_commands<Controller> commands;
  figures_now measured;
  door_description told;
  double speed;  // as it was set here
  mutable std::array<std::atomic<bool>, array_size(the_run + 1)> wanted{};
  enum class about { request, command, pause, anew } begun = about::request;  // what `outcome` tells of
  mutable std::mutex guard{};  // of what the resting loop tells, and of the next
  std::string cause_of_end{};
  std::vector<std::string> causes{};
  std::string path_of_fault{};
  std::int64_t told_at = -1;  // the beat of the causes
  std::int64_t told_of = -1;  // the loop's
  state told_in{};
};

}  // namespace cca::detail
