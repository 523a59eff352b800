// One axis of a limiter whose rate has limits too: of acceleration and jerk, besides velocity and range.
//
// Each beat is a step: the second rate changes by the third, the rate by the second rate, the number by the
// rate. So these are the differences of the numbers that are published, and the limits hold for them, not for
// a curve between. Every state carries a plan of braking to rest: three stretches of steps in which the
// second rate changes evenly, stays, and changes back. A step is taken only if a plan that stays within all
// limits exists for what follows; else the present plan goes on by a step. So braking is always possible,
// whatever is commanded next, and the number never leaves its range.
//
//   A command that keeps the limits passes as it is. To any other the axis goes as fast as they allow: it
//   takes the greatest second rate after which it can still stop before the command, found by bisection. Of a
//   command that moves on, it takes the speed as well. The last steps meet the command exactly, in three
//   beats. While a command is NaN or infinite, the limiter calls brake() instead.
//
// All numbers are per beat: the rate times dt, the second rate times dt^2, the third times dt^3. Infinite
// limits of the third mean that the second rate may jump. Preconditions: the limits of all rates have 0
// inside, those of the second and the third strictly. Cost: some dozen operations while commands pass, about
// 25 plans of a hundred operations while it goes to one. Used by limiter.hpp. Source: the idea that a state
// is safe if braking from it stays within the limits is that of Kroeger and Wahl, Online Trajectory
// Generation, IEEE Trans. Robotics 26(1), 2010.
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/base/compiler.hpp>
#include <cca/base/math/roots.hpp>

namespace cca::detail {

struct closed_range {
  double lower, upper;
  constexpr bool holds(double x) const { return lower <= x && x <= upper; }
  // Within rounding of the numbers that x was computed from.
  constexpr bool about_holds(double x) const { return (1 + 1e-9) * lower <= x && x <= (1 + 1e-9) * upper; }
  constexpr double nearest(double x) const { return x < lower ? lower : x > upper ? upper : x; }
};

struct motion_limits {
  closed_range range, rate, second, third;
};

class bounded_motion {
public:
  void rest_at(double number) { *this = {}, at_ = goal_ = number; }
  double at() const { return at_; }

  // One beat towards `goal`, which lies within the range.
  double go_to(double goal, const motion_limits& most) {
    const double moved = goal - goal_, former = goal_rate_;
    goal_rate_ = most.rate.about_holds(moved) ? moved : 0;  // a jump has no speed
    const double change = goal_rate_ - former;
    const bool follows = at_ == goal_;
    goal_ = goal;
    // What rounding has left.
    if (rate_ == 0 && second_ == 0 && std::abs(goal - at_) <= 2e-15 * (1 + std::abs(goal))) return at_ = goal;
    if (!meets(goal, most.second.holds(change) ? change : 0, follows, most)) approach(goal, most);
    return at_ = most.range.nearest(at_);
  }
  // One beat of braking.
  double brake(const motion_limits& most) {
    go_on();
    goal_ = at_, goal_rate_ = 0;
    return at_ = most.range.nearest(at_);
  }

private:
  struct state {
    double at, rate, second;
    // After n steps in which the second rate changes by `slope`.
    state after(double n, double slope) const {
      return {at + n * rate + n * (n + 1) / 2 * second + n * (n + 1) * (n + 2) / 6 * slope,
              rate + n * second + n * (n + 1) / 2 * slope, second + n * slope};
    }
  };
  struct braking {
    double slope = 0, back = 0;  // of the second rate, in the first and the third stretch
    int first = 0, hold = 0, third = 0;
  };

  state now() const { return {at_, rate_, second_}; }

  // Takes the command itself, if the limits allow it and will still do so after it.
  bool meets(double goal, double goal_second, bool follows, const motion_limits& most) {
    const double rate = goal - at_, second = rate - rate_, third = second - second_;
    if (!most.rate.about_holds(rate) || !most.second.about_holds(second) || !most.third.about_holds(third))
      return false;
    // Two more steps that bring the rates to those of a goal that moves on evenly.
    const double next = goal_rate_ + goal_second - rate, last = goal_second;
    const bool settles = most.rate.about_holds(rate + next) && most.second.about_holds(next) &&
                         most.third.about_holds(next - second) && most.third.about_holds(last - next);
    return (follows || settles) && accepts({goal, rate, second}, most);
  }

  // As fast as the limits allow, so that the axis can still stop at the goal; where the goal moves, so that
  // it has the goal's speed there.
  void approach(double goal, const motion_limits& most) {
    double aim = goal;
    braking ahead, best_plan;
    state best{};
    if (goal_rate_ != 0 && plan({goal, goal_rate_, 0}, most, ahead))
      aim = most.range.nearest(end_of({goal, goal_rate_, 0}, ahead));
    const double stop = end_of(now(), plan_);
    const bool up = aim > stop;
    const auto takes = [&](double second) {
      const double rate = rate_ + second;
      const state next{at_ + rate, rate, second};
      braking p;
      if (!most.rate.holds(rate) || !plan(next, most, p)) return false;
      const double end = end_of(next, p);
      if (up ? end > aim : end < aim) return false;
      best = next, best_plan = p;
      return true;
    };
    double good = second_ + next_slope();
    double bad = up ? std::min(most.second.upper, second_ + most.third.upper)
                    : std::max(most.second.lower, second_ + most.third.lower);
    bool any = aim != stop && takes(bad);
    if (aim != stop && !any)
      for (int i = 0; i < 24; ++i) {
        const double middle = 0.5 * (good + bad);
        const bool yes = takes(middle);
        any = any || yes;
        (yes ? good : bad) = middle;
      }
    if (!any) return go_on();
    take(best, best_plan);
  }

  bool accepts(const state& next, const motion_limits& most) {
    braking p;
    if (!plan(next, most, p)) return false;
    take(next, p);
    return true;
  }
  void take(const state& next, const braking& p) {
    at_ = next.at, rate_ = next.rate, second_ = next.second, plan_ = p;
  }

  double next_slope() const {
    return plan_.first > 0 ? plan_.slope : plan_.hold > 0 || plan_.third == 0 ? 0 : plan_.back;
  }
  void go_on() {
    if (plan_.first > 0) second_ += plan_.slope, --plan_.first;
    else if (plan_.hold > 0) --plan_.hold;
    else if (plan_.third > 0) second_ += plan_.back, --plan_.third;
    rate_ += second_;
    at_ += rate_;
    if (plan_.first + plan_.hold + plan_.third == 0) rate_ = second_ = 0;
  }

  static double end_of(const state& from, const braking& p) {
    return from.after(p.first, p.slope).after(p.hold, 0).after(p.third, p.back).at;
  }

  // Braking to rest from a state: false if it can't stay within the limits.
  static bool plan(const state& from, const motion_limits& most, braking& p) {
    p = {};
    if (!most.range.holds(from.at)) return false;
    if (from.rate == 0 && from.second == 0) return true;
    const auto steps = [](double n) { return std::max(1.0, math::ceil(n - 1e-9)); };
    const double rest =
        steps(from.second > 0 ? from.second / -most.third.lower : -from.second / most.third.upper);
    // The rate once the second one is 0. Mirrored, so that it is positive.
    const double turns = from.rate + from.second * (rest - 1) / 2 > 0 ? 1 : -1;
    const double rate = turns * from.rate, second = turns * from.second;
    const double strongest = turns > 0 ? -most.second.lower : most.second.upper,
                 other_way = turns > 0 ? most.second.upper : -most.second.lower,
                 in = 1 / (turns > 0 ? -most.third.lower : most.third.upper),
                 out = 1 / (turns > 0 ? most.third.upper : -most.third.lower);
    // How strongly it brakes, and for how many steps, in continuous time; then in whole steps.
    double most_braking = strongest;
    if (in + out > 0)
      most_braking =
          std::min(strongest, math::sqrt(std::max(0.0, 2 * rate + second * second * in) / (in + out)));
    double first = steps((second + most_braking) * in), third = steps(most_braking * out), hold = 0;
    if (most_braking > 0)
      hold = math::floor(std::max(0.0, (rate + 0.5 * (second * second - most_braking * most_braking) * in -
                                        0.5 * most_braking * most_braking * out) /
                                           most_braking));
    for (int tries = 0; tries < 24 && first + hold + third < 1e9; ++tries) {
      const double braking_by = (rate + second * (first - 1) / 2) / (first / 2 + hold + third / 2);
      const double slope = (-braking_by - second) / first, back = braking_by / third;
      constexpr double one = 1 + 1e-9;
      if (braking_by > one * strongest) ++hold;
      else if (-braking_by > one * other_way) return false;
      else if (-slope * in > one || slope * out > one) ++first;
      else if (back * out > one || -back * in > one) ++third;
      else {
        p = {turns * slope, turns * back, static_cast<int>(first), static_cast<int>(hold),
             static_cast<int>(third)};
        return stays_within(from, p, most);
      }
    }
    return false;
  }

  // Of the three stretches only the first can have a turning point of the rate or of the number.
  static bool stays_within(const state& from, const braking& p, const motion_limits& most) {
    const auto in_range = [&](double n) { return most.range.holds(from.after(n, p.slope).at); };
    const auto in_rate = [&](double n) { return most.rate.about_holds(from.after(n, p.slope).rate); };
    if (!most.range.holds(end_of(from, p)) || !in_rate(p.first)) return false;
    const double peak = math::floor(-from.second / p.slope);
    if (peak > 0 && peak < p.first && !in_rate(peak)) return false;
    const double b = from.second + p.slope / 2, inner = b * b - 2 * p.slope * from.rate;
    if (!(inner >= 0)) return true;
    for (const double root : {(-b - math::sqrt(inner)) / p.slope, (-b + math::sqrt(inner)) / p.slope})
      if (root > 0 && root < p.first && !(in_range(math::floor(root)) && in_range(math::ceil(root))))
        return false;
    return true;
  }

  double at_ = 0, rate_ = 0, second_ = 0, goal_ = 0, goal_rate_ = 0;
  braking plan_{};
};

}  // namespace cca::detail
