// The option `--door` of cca::robot_main: there where <cca/door.hpp> is included and the graph is recordable.
// docs/door.md.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <cca/door/open_door.hpp>
#include <cca/runtime/observers/program_door.hpp>
#include <cca/runtime/observers/run_command.hpp>
#include <cca/main/run_settings.hpp>

namespace cca::detail {

// `Host`: cca::controller or cca::deployed.
template <template <class> class Host, class Graph>
  requires(Recordable<Graph> && !Refused<Host<Graph>>)
struct program_door<Host<Graph>> : door_on<Host<Graph>> {
  using controller = Host<Graph>;

  program_door(controller& c,
               run_control& run,
               recording::recorder<controller>& recorder,
               const run_settings& s,
               std::vector<run_command<controller>> offers,
               const std::string& program,
               std::function<std::vector<environment_figures>(std::int64_t overruns)> figures)
      : door_on<controller>(settings_of(s),
                            c,
                            &run,
                            recorder,
                            std::move(offers),
                            program,
                            s.speed.value_or(0),
                            [this, figures = std::move(figures)] { return figures(this->live.overruns()); }) {
  }

  bool ends_run() const { return this->live.is_ending(); }
  std::string ended_by() const { return this->controls.ended_by(); }

  static door_settings settings_of(const run_settings& s) {
    door_settings all;
    all.port = s.door.value_or(all.port);
    if (!s.door_address.empty()) all.address = s.door_address;
    all.origins = s.door_origins;
    all.token_file = s.door_token;
    all.twin = s.twin;
    all.on_lost = s.on_lost == "stop"   ? when_lost::stop
                  : s.on_lost == "hold" ? when_lost::hold
                                        : when_lost::go_on;
    return all;
  }
};

}  // namespace cca::detail
