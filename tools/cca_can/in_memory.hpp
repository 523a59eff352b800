// A bus in memory with played drives at its other end: every command can be tried on a machine without CAN.
//
//   cca-can jog memory damiao:12.5/45/20:3 --by 0.1 --range=-0.2,0.2 --speed 0.5 --torque 0.5 --yes
//       --pretend damiao:12.5/45/20:3
//
// It lives as long as the command, in the machine's time. Without --pretend the drives that the command names
// are played.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <cca/hardware/memory_bus.hpp>

#include "drives/drive_name.hpp"
#include "pace.hpp"
#include "commands/pretend.hpp"

namespace cca_can {

inline constexpr const char* bus_in_memory = "memory";

// The time of the machine; while a command waits, the bus and the drives go on.
class memory_pace : public pace {
public:
  memory_pace(pace& machine, const std::vector<std::string>& names) : time(machine) {
    wire.advance(time.now());
    for (const std::string& name : names) drives.push_back(virtual_named(name));
  }
  using wire_type = hw::memory_bus<2, 64>;
  wire_type::end_type open() { return wire.end(0); }

  std::int64_t now() const override { return time.now(); }
  std::int64_t calendar() const override { return time.calendar(); }
  bool end_wanted() const override { return time.end_wanted(); }
  void wait_until(std::int64_t when) override {
    do {
      time.wait_until(std::min(when, time.now() + ms / 2));
      wire.advance(time.now());
      play(far, drives, time.now());
    } while (time.now() < when);
  }

private:
  pace& time;
  wire_type wire{{.rates = {1'000'000, 5'000'000}}};
  wire_type::end_type far = wire.end(1);
  std::vector<std::unique_ptr<any_virtual>> drives{};
};

}  // namespace cca_can
