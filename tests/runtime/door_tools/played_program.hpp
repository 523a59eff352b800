// A program behind a real door, that only plays: some environments, any number of outputs at their rates, a
// part that rests, a fault on demand.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/record/messages/cdr.hpp>

#include "../door/opened.hpp"

namespace door_tools_test {

using cca::detail::door_controls;

class played_controls final : public door_controls {
public:
  explicit played_controls(int outputs) : text(fake.description()) {
    text.program = "oncilla_trot";
    text.nodes = {"gait", "robot", "arm.reach", "sink"};
    for (int i = 0; i < outputs; ++i) text.nodes.push_back("mind.part_" + std::to_string(i));
  }

  door_test::fake_controls fake{};
  std::string fault{}, fault_path{}, state = "running";
  std::vector<std::string> stopped_parts{};
  int environment_count = 2;

  const cca::detail::door_description& description() const override { return text; }
  cca::detail::door_status status() const override {
    auto now = fake.status();
    now.state = now.state == "running" ? state : now.state;
    now.mode = now.mode.empty() ? "walk" : now.mode;
    now.overruns = 3;
    now.fault = fault, now.fault_path = fault_path;
    now.stopped_parts = stopped_parts;
    return now;
  }
  std::vector<cca::detail::door_environment> environments() const override {
    std::vector<cca::detail::door_environment> all{
        {"robot", 123456, 3, 1, 0, 12.1e-6, 25e-6, 101e-6, 4e-6, 12e-6, 81e-6},
        {"mind", 12345, 0, 0, 17, 0.8e-3, 1.9e-3, 12.5e-3, 55e-6, 91e-6, 400e-6}};
    for (int i = 2; i < environment_count; ++i)
      all.push_back({.name = "worker_" + std::to_string(i), .beats = i});
    all.resize(static_cast<std::size_t>(environment_count));
    return all;
  }
  std::optional<std::vector<cca::detail::door_parameter>> parameters() override { return fake.parameters(); }
  cca::detail::door_outcome begin(const cca::detail::door_request& one) override { return fake.begin(one); }
  cca::detail::door_outcome outcome() override { return fake.outcome(); }
  void note(std::string_view client, std::string_view what) override { fake.note(client, what); }

private:
  cca::detail::door_description text;
};

class played_program {
public:
  explicit played_program(int outputs = 3, cca::door_settings with = {})
      : controls(outputs), door(door_test::quiet(std::move(with)), controls) {
    add("/gait/angles", "float64 hip  # rad, -0.9 to 0.9\nfloat64 knee  # rad\n");
    add("/robot/angles", "float64 hip  # rad\nfloat64 knee  # rad\n");
    for (int i = 0; i < outputs; ++i) add("/mind/part_" + std::to_string(i) + "/status", "float64 done\n");
    door.sink().channel({.id = ++last,
                         .topic = "/cca/state",
                         .type = "cca/msg/state",
                         .schema = "int64 beat\nstring state\n",
                         .is_kept = true});
  }

  played_controls controls;
  cca::detail::door_server door;

  std::string address() const { return std::to_string(door.port()); }

  // One beat of 1 ms: `gait` and `robot` each time, the n-th other one each n + 1 beats.
  void beat() {
    const std::int64_t now = ++k * 1'000'000;
    for (std::uint16_t id = 1; id < last; ++id) {
      if (id > 2 && k % (id - 1) != 0) continue;
      unsigned char bytes[64];
      cca::recording::detail::cdr_writer to(bytes);
      to.add(k).add(now).add(std::sin(0.002 * static_cast<double>(k)));
      if (id <= 2) to.add(0.5);
      door.sink().message(id, static_cast<std::uint64_t>(now), static_cast<std::uint64_t>(now), to.view());
    }
    door.sink().hand_over();
  }

private:
  std::uint16_t last = 0;
  std::int64_t k = 0;

  void add(const std::string& topic, const std::string& fields) {
    door.sink().channel({.id = ++last,
                         .topic = topic,
                         .type = "cca/msg/one",
                         .schema = "int64 beat\nint64 origin  # ns\n" + fields});
  }
};

}  // namespace door_tools_test
