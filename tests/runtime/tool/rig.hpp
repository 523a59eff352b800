// The tool on a bus in memory, with played drives at the other end, in virtual time.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <cca/hardware/memory_bus.hpp>

#include "../../../tools/cca_can/drives/drive_name.hpp"
#include "../../../tools/cca_can/console.hpp"
#include "../../../tools/cca_can/pace.hpp"
#include "../../../tools/cca_can/commands/pretend.hpp"

namespace tool_test {

using namespace cca_can;

struct rig : pace {
  using wire_type = hw::memory_bus<3, 32>;
  explicit rig(const std::vector<std::string>& names = {}, std::span<const hw::bus_fault> script = {})
      : wire({.rates = {1'000'000}, .script = script}) {
    for (const std::string& name : names) drives.push_back(virtual_named(name));
  }
  rig(const rig&) = delete;
  rig& operator=(const rig&) = delete;

  wire_type wire;
  wire_type::end_type bus = wire.end(0), far = wire.end(1), spy = wire.end(2);
  std::vector<std::unique_ptr<any_virtual>> drives{};
  std::function<void()> each = [] {};  // called every half millisecond
  std::vector<hw::can_frame> seen{};   // all that was on the wire
  std::int64_t clock = 0, ctrl_c = -1;

  std::ostringstream out{}, error{};
  std::istringstream in{};
  console say{out, error, in, true, false};

  std::int64_t now() const override { return clock; }
  std::int64_t calendar() const override { return clock + 1'436'509'052'000'000'000; }
  bool end_wanted() const override { return ctrl_c >= 0 && clock >= ctrl_c; }
  void wait_until(std::int64_t when) override {
    while (clock < when) {
      clock = std::min(when, clock + ms / 2);
      wire.advance(clock);
      if (!drives.empty()) play(far, drives, clock);
      each();
      std::array<hw::received_frame, 64> frames;
      const std::size_t n = spy.receive(frames);
      for (std::size_t i = 0; i < n; ++i) seen.push_back(frames[i].frame);
    }
  }

  // The last frame under this id.
  hw::can_frame last_of(hw::can_id id) const {
    const auto at =
        std::find_if(seen.rbegin(), seen.rend(), [&](const hw::can_frame& f) { return f.id == id; });
    return at == seen.rend() ? hw::can_frame{} : *at;
  }
  bool printed(const char* text) const { return (out.str() + error.str()).find(text) != std::string::npos; }
};

}  // namespace tool_test
