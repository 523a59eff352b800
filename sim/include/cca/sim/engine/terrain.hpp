// The ground as a value: level, a slope or steps, and its friction. It has no end.
//
// The robot starts around x = 0 on level ground at z = 0; slopes and steps begin at `start`. The ground is
// the same for every y. It is a row of strips from left to right, which are computed where they are asked
// for: its memory does not depend on how far the robot goes.
//
// Errors: std::invalid_argument for a number that no ground has, so a terrain is always one that a world can
// have, and a part meets a bounded number of strips in a beat.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <cca/base/math.hpp>
#include <cca/sim/engine/refused_number.hpp>

namespace cca::sim {

// A plane between two edges: at `edge_x` it has the height `edge_z`, and it rises by the angle `pitch`. The
// first strip of a terrain begins at minus infinity, the last one ends at infinity.
struct ground_strip {
  double begin, end;  // x, m
  double edge_x, edge_z, pitch;

  double height(double x) const { return edge_z + (x - edge_x) * math::tan(pitch); }
};

// The numbers of a terrain, without its name: a plain value.
struct ground_profile {
  double start = std::numeric_limits<double>::infinity();  // x, m: level ground before it
  double pitch = 0, rise = 0;                              // rad, m
  double run = std::numeric_limits<double>::infinity();    // m, of a step
  std::int64_t count = 0;                                  // of strips after the first

  double height(double x) const { return strip(index_at(x)).height(x); }
  // One level strip, at z = 0.
  bool is_level() const { return count == 0; }

  // Calls f(strip) for every strip that has ground between the two places, from left to right.
  template <class F>
  void strips_between(double low, double high, F f) const {
    if (!(std::isfinite(low) && std::isfinite(high))) return;
    for (std::int64_t i = index_at(low), last = index_at(high); i <= last; ++i) f(strip(i));
  }
  // Calls f(i, before, after) where the strip i ends and the next one begins, between the two places.
  template <class F>
  void edges_between(double low, double high, F f) const {
    if (!(std::isfinite(low) && std::isfinite(high))) return;
    for (std::int64_t i = index_at(low), last = index_at(high); i < last; ++i) f(i, strip(i), strip(i + 1));
  }

private:
  // Strip 0 is the level ground before `start`, strip i the i-th step, or the slope.
  std::int64_t index_at(double x) const {
    if (!(x >= start)) return 0;
    return static_cast<std::int64_t>(
        std::min(static_cast<double>(count), 1 + math::floor((x - start) / run)));
  }

  ground_strip strip(std::int64_t i) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (i == 0) return {-infinity, count > 0 ? start : infinity, 0, 0, 0};
    const auto n = static_cast<double>(i);
    const double begin = i == 1 ? start : start + (n - 1) * run;
    return {begin, i == count ? infinity : start + n * run, begin, n * rise, pitch};
  }
};

class terrain {
public:
  static constexpr std::int64_t endless = std::int64_t{1} << 52;  // every smaller number of steps is exact

  static constexpr double least_run = 0.01;  // m, CHOSEN: smaller than a foot

  static terrain flat() { return terrain("flat", infinity, 0, 0, infinity, 0); }

  static terrain slope(double pitch, double start = 1.5) {
    need(std::abs(pitch) < quarter_turn, "the pitch of the slope", pitch, "rad", "between -pi/2 and pi/2");
    need(std::isfinite(start), "the start of the slope", start, "m", "a finite number");
    return terrain("slope", start, pitch, 0, infinity, 1);
  }

  // Steps up by `rise` (down, if it is negative) every `run` metres, `count` of them.
  static terrain steps(double rise = 0.006,
                       double run = 0.6,
                       std::int64_t count = endless,
                       double start = 1.5) {
    need(std::isfinite(rise), "the rise of the steps", rise, "m", "a finite number");
    need(std::isfinite(run) && run >= least_run, "the run of the steps", run, "m", "at least 0.01 m");
    need(std::isfinite(start), "the start of the steps", start, "m", "a finite number");
    return terrain("steps", start, 0, rise, run, std::clamp<std::int64_t>(count, 0, endless));
  }

  // By name, as a command line gives it: `flat`, `slope` or `slope:DEGREES`, `steps` or `steps:MILLIMETRES`.
  static terrain named(std::string_view text) {
    const auto colon = text.find(':');
    const std::string_view name = text.substr(0, colon);
    const std::string number(colon == text.npos ? "" : text.substr(colon + 1));
    std::size_t read = 0;
    double value = 0;
    try {
      if (colon != text.npos) value = std::stod(number, &read);
    } catch (const std::exception&) { read = number.size() + 1; }
    if (read == number.size() && std::isfinite(value)) {
      if (name == "flat" && colon == text.npos) return flat();
      if (name == "slope" && std::abs(value) <= 30)
        return slope((colon == text.npos ? 3.0 : value) * 0.017453292519943295);
      if (name == "steps" && std::abs(value) <= 100) return steps(colon == text.npos ? 0.006 : value / 1000);
    }
    throw std::invalid_argument(
        "terrain '" + std::string(text) +
        "': expected flat, slope[:degrees, at most 30] or steps[:millimetres, at most 100]");
  }

  const std::string& name() const { return name_; }

  double friction() const { return friction_; }
  terrain with_friction(double mu) const {
    need(std::isfinite(mu) && mu >= 0, "the friction of the ground", mu, "", "a number of at least 0");
    terrain t = *this;
    t.friction_ = mu;
    return t;
  }

  double height(double x) const { return profile_.height(x); }
  const ground_profile& profile() const { return profile_; }

  // Calls f(strip) for every strip that has ground between the two places, from left to right.
  template <class F>
  void strips_between(double low, double high, F f) const {
    profile_.strips_between(low, high, f);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity(),
                          quarter_turn = std::numbers::pi / 2;

  terrain(std::string name, double start, double pitch, double rise, double run, std::int64_t count)
      : name_(std::move(name)), profile_{start, pitch, rise, run, count} {}

  std::string name_;
  ground_profile profile_;
  double friction_ = 0.75;
};

}  // namespace cca::sim
