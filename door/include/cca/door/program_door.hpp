// The option `--door` of cca::robot_main: there where <cca/door.hpp> is included and the graph is recordable.
// docs/door.md.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <cca/door/open_door.hpp>
#include <cca/main/program_door.hpp>
#include <cca/main/run_command.hpp>
#include <cca/main/run_settings.hpp>
#include <cca/runtime/live/live_access.hpp>

namespace cca::detail {

// `Host`: cca::controller or cca::deployed.
template <template <class> class Host, class Graph>
  requires(Recordable<Graph> && !Refused<Host<Graph>>)
struct program_door<Host<Graph>> {
  using controller = Host<Graph>;

  program_door(controller& c,
               run_control& run,
               recording::recorder<controller>& recorder,
               const run_settings& s,
               std::vector<run_command<controller>> offers,
               const std::string& program,
               std::function<std::vector<environment_figures>(std::int64_t overruns)> figures)
      : live(c),
        on(settings_of(s), live, run, recorder, std::move(offers), program, s.speed.value_or(0),
           [this, figures = std::move(figures)] { return figures(live.overruns()); }) {}

  // ---- the loop's, between two beats; false: the run is to end ----

  bool look(controller& c) {
    on.controls.obey(c);
    if constexpr (requires { live(c); }) return live(c);
    else return live.goes_on(c);
  }
  template <int Environment>
  void after_beat(controller& c)
    requires requires(live_access<controller>& of) { of.template after_beat<Environment>(c); }
  {
    live.template after_beat<Environment>(c);
  }
  // Before the first beat.
  bool look_at_rest(controller& c) {
    if constexpr (!requires { live(c); })
      c.for_each_tap([&]<int Environment>(auto&) { live.template after_beat<Environment>(c); });
    return look(c);
  }
  void run_ended(controller& c) {
    if constexpr (requires { live.after_last_beat(c); }) live.after_last_beat(c);
    on.controls.end(c);
    live.run_ended(c);
  }

  bool ends_run() const { return live.is_ending(); }

  static door_settings settings_of(const run_settings& s) {
    door_settings all;
    all.port = s.door.value_or(all.port);
    if (!s.door_address.empty()) all.address = s.door_address;
    all.token_file = s.door_token;
    all.on_lost = s.on_lost == "stop" ? when_lost::stop : s.on_lost == "hold" ? when_lost::hold : when_lost::go_on;
    return all;
  }

  live_access<controller> live;
  door_on<controller> on;
};

}  // namespace cca::detail
