// The Combination of Skills on two machines: the robot, here the simulated one, on the one, and its reflexes
// and its mind on the other. docs/two_machines.md
//
//   deployed_two_machines --machine robot --own 192.168.1.10 --other 192.168.1.11
//   deployed_two_machines --machine mind  --own 192.168.1.11 --other 192.168.1.10
//
// In a fast run the robot's side compares all samples with those of one loop. With --pace it keeps a
// clock: then it stops when it has heard nothing for too long, and goes on when it reads a line.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/dds.hpp>
#include <cca/main/command_line.hpp>
#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>

#include "../combination_of_skills/command_line.hpp"
#include "architecture.hpp"
#include "settings.hpp"

namespace {

using deployed::record;

// [deployment]
struct on_two_machines
    : cca::deployment<
          deployed::architecture,
          cca::environment<
              "robot",
              cca::nodes<"robot", "camera", "limits", "abduction_limits", "stiffness_limits", "recorder">>,
          cca::environment<"mind", cca::other_nodes>,
          cca::tolerate<20>> {};  // late beats in a row; then the robot stops
// [deployment end]

constexpr std::int64_t warm_up = 100;  // beats

struct options {
  deployed::settings run{.most_beats = 1000};
  std::string machine = "robot", own, other;
  std::uint64_t domain = 7;
  bool loses = false;
  std::optional<double> pace;

  bool is_robot() const { return machine == "robot"; }

  void offer(cca::command_line& line) {
    static constexpr std::array<std::string_view, 2> machines{"robot", "mind"};
    line.one_of(
        "--machine M", [this](std::size_t i) { machine = machines[i]; }, machines,
        "robot or mind (robot): which of the two this is");
    line.text("--own ADDRESS", own, "of this machine; without it both are this machine");
    line.text("--other ADDRESS", other, "of the other one");
    line.whole_number("--dds DOMAIN", domain, 0, 230, "the domain of DDS, the same on both (7)");
    line.flag("--loses", loses, "the network loses a message in a hundred or more");
    line.whole_number("--beats N", run.most_beats, 1, "the same on both (1000)");
    line.number("--pace S", pace, 0.001, 1,
                "of the robot's machine: keeps a clock, 1 is the wall clock's\n(a fast run)");
    line.text("--shape FILE", run.shape, "the learned shape of the trot (trot.shape)");
  }
  cca::dds::network network() const {
    const auto one = own.empty() ? cca::dds::network() : cca::dds::network::between(own, {other});
    return loses ? one.that_loses() : one;
  }
};

void tell_refusals(const cca::dds::domain& net) {
  for (const auto& one : net.refusals())
    std::printf("refused from %s: %s (%lld times)\n", one.who.c_str(), one.why.c_str(),
                static_cast<long long>(one.count));
}

int compare_with_one_loop(const options& o, cca::deployed<on_two_machines>& d) {
  const record here = std::move(d.get<"recorder">().seen);
  cca::controller<on_two_machines> loop;
  deployed::settings s = o.run;
  s.most_beats = d.beat_index();
  deployed::set_up(loop, s, {"simulation", "reflexes"});
  loop.run(cca::for_some_beats{s.most_beats});
  const auto found = loop.get<"recorder">().seen.compare(here, s.most_beats);
  std::printf("%lld beats, %lld samples compared, %lld different\n", static_cast<long long>(s.most_beats),
              static_cast<long long>(found.compared), static_cast<long long>(found.different));
  if (found.first)
    std::printf("the first: %s in beat %lld\n", std::string(found.first->output).c_str(),
                static_cast<long long>(found.first->beat));
  return found.compared > 0 && found.different == 0 ? 0 : 1;
}

// When things happen, on a clock that all processes of a machine share.
double now() { return 1e-9 * static_cast<double>(cca::detail::monotonic_clock::now()); }

// In a wall-clock run. Each lost contact stops the robot; a line of the standard input tells it to go on.
int run_on_clock(const options& o, cca::deployed<on_two_machines>& d, const cca::interruption& interrupted) {
  // [go on]
  while (d.beat_index() < o.run.most_beats && !interrupted) {
    d.run(cca::for_some_beats{o.run.most_beats - d.beat_index()}, cca::at_speed(*o.pace), interrupted);
    if (d.state() != cca::state::faulted) continue;
    std::printf("stopped at %.3f s: %s, in beat %lld, %lld were late\n",
                1e-9 * static_cast<double>(d.get<"robot.simulator">().stopped_at), d.fault().reason(),
                static_cast<long long>(d.beat_index()), static_cast<long long>(d.late()));
    std::fflush(stdout);
    std::string line;
    if (!std::getline(std::cin, line)) break;  // nobody is there
    d.resume();
    std::printf("at %.3f s: goes on\n", now());
    std::fflush(stdout);
  }
  // [go on end]
  std::printf("%lld beats, %lld late, %lld overruns\n", static_cast<long long>(d.beat_index()),
              static_cast<long long>(d.late()), static_cast<long long>(d.overruns()));
  return d.beat_index() >= o.run.most_beats ? 0 : 1;
}

int run_robot(const options& o, cca::deployed<on_two_machines>& d, const cca::interruption& interrupted) {
  // A fast run: it touches all memory, so that the first beats by the clock are as short as others.
  d.run(cca::for_some_beats{std::min(warm_up, o.run.most_beats)}, {}, interrupted);
  std::printf("at %.3f s: both run, %lld beats are done\n", now(), static_cast<long long>(d.beat_index()));
  std::fflush(stdout);
  if (o.pace) return run_on_clock(o, d, interrupted);
  d.run(cca::for_some_beats{o.run.most_beats - d.beat_index()}, {}, interrupted);
  if (d.fault()) return std::printf("%s\n", d.fault().reason()), 1;
  return compare_with_one_loop(o, d);
}

// The mind's side follows: after a fault it waits until the robot goes on.
int run_mind(const options& o, cca::deployed<on_two_machines>& d, const cca::interruption& interrupted) {
  while (d.beat_index() < o.run.most_beats && !interrupted) {
    try {
      d.run(cca::for_some_beats{o.run.most_beats - d.beat_index()}, {}, interrupted);
    } catch (const cca::refused& why) {  // nobody came for 10 s
      std::printf("%s\n", why.what());
      return 1;
    }
    if (d.state() == cca::state::faulted) d.resume();
    if (d.state() == cca::state::loaded) break;  // the robot has stopped
  }
  std::printf("%lld beats, %lld late\n", static_cast<long long>(d.beat_index()),
              static_cast<long long>(d.late()));
  return d.beat_index() >= o.run.most_beats ? 0 : 1;
}

int run(const options& o) {
  const cca::interruption interrupted;
  const cca::dds::domain net(static_cast<std::uint32_t>(o.domain), "cca_two_machines", o.network());
  cca::deployed<on_two_machines> d(cca::only(std::vector{o.machine}), net);
  deployed::set_up(d, o.run, {o.is_robot() ? "simulation" : "reflexes"});
  const int code = o.is_robot() ? run_robot(o, d, interrupted) : run_mind(o, d, interrupted);
  if (d.state() == cca::state::started || d.state() == cca::state::faulted) d.stop();
  tell_refusals(net);
  return interrupted ? interrupted.exit_code() : code;
}

}  // namespace

int main(int count, char** words) {
  options o;
  cca::command_line line("the Combination of Skills on two machines, over DDS");
  o.offer(line);
  return cca::run_program(count, words, line, [&] {
    if (o.own.empty() != o.other.empty())
      throw cca::command_line_error("--own and --other: give both, or none");
    return run(o);
  });
}
