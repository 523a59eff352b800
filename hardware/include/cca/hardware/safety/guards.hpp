// The first guards of the chain: they check set points before the others look at where these lead.
//
//   act   in "wanted" wanted_points, out "safe" wanted_points. Each guard marks the joints whose set point
//         breaks its rule (`trip`); the emergency stop after them acts on that
//   finite_guard   NaN or infinity: repeats the last finite set point, marked not_finite
//   stale_guard    data older than the parameter `greatest_age`: marked stale. The age is the time since the
//                  origin, or since data of this origin came first, whichever is longer
//
// Cost: some comparisons a joint. Example: tests/runtime/drive_chain/safety.cpp; docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>
#include <cca/component/parameters.hpp>
#include <cca/base/reflect.hpp>
#include <cca/hardware/drives/set_points.hpp>

namespace cca::hardware {

template <class Joints>
class finite_guard {
public:
  auto act(in<"wanted", wanted_points<Joints>> wanted, beat now) -> out<"safe", wanted_points<Joints>> {
    auto v = wanted.vector();
    for (std::size_t i = 0; i < Joints::count; ++i) {
      wanted_point s = wanted_point::of(v, i);
      if (s.finite()) {
        last[i] = s;
        continue;
      }
      noted.note(safety_rule::not_finite, static_cast<int>(i), now.index());
      static_cast<drive_command&>(s) = last[i];
      s.velocity = s.torque = 0;
      s.trip(safety_rule::not_finite);
      s.put(v, i);
    }
    return v;
  }
  void on_start() { *this = {}; }
  const safety_record& record() const { return noted; }

private:
  std::array<drive_command, Joints::count> last{};
  safety_record noted{};
};

template <class Joints>
class stale_guard {
public:
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::quantity<cca::duration, 0, 3600>, greatest_age));
  };
  parameters p{0.05};

  auto act(in<"wanted", wanted_points<Joints>> wanted, beat now) -> out<"safe", wanted_points<Joints>> {
    auto v = wanted.vector();
    if (wanted.origin() != newest) newest = wanted.origin(), arrived = now.time();
    const std::int64_t from = std::min(newest, arrived);  // an origin in the future counts as its arrival
    const bool stale = newest != never && static_cast<double>(now.time() - from) > 1e9 * p.greatest_age;
    for (std::size_t i = 0; stale && i < Joints::count; ++i) {
      wanted_point s = wanted_point::of(v, i);
      s.trip(safety_rule::stale);
      s.put(v, i);
    }
    if (stale) noted.note(safety_rule::stale, -1, now.index());
    return v;
  }
  void on_start() { noted = {}, newest = never; }
  const safety_record& record() const { return noted; }

private:
  std::int64_t newest = never, arrived = 0;  // the guard before this one repeats data; its origin stays
  safety_record noted{};
};

}  // namespace cca::hardware
