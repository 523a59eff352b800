// The guards in front of the drives, one at a time: what passes, what they change and how, and what they
// record. The numbers belong to two joints made for this test; the expected results are computed here, not
// taken from the guards.
#include <array>
#include <cstdint>
#include <limits>
#include <thread>
#include <type_traits>
#include <utility>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/hardware/safety/bounds.hpp>
#include <cca/hardware/safety/emergency_stop.hpp>
#include <cca/hardware/safety/guards.hpp>
#include <cca/hardware/mit.hpp>

namespace {

namespace hw = cca::hardware;
using hw::safety_rule;

struct turning : cca::dimension<"turning"> {
  static constexpr auto limits =
      cca::limits{cca::angle{-1, 2}, cca::velocity{-3, 4}, cca::torque{-5, 6}, cca::torque_rate{-100, 100}};
};
struct pulled : cca::dimension<"pulled"> {  // by a cable, against a spring
  static constexpr auto limits = cca::limits{cca::angle{0.5, 1.5}, cca::velocity{-3, 3}, cca::torque{0, 7}};
};
constexpr hw::joint_servo servo{.stiffness = 20, .damping = 0.5, .safe_damping = 1, .most_stiff = 50};
struct turning_joint : hw::joint<turning, hw::mit_drive<hw::ak60_6, 1>, hw::mounting{}, servo> {};
struct pulled_joint : hw::joint<pulled, hw::mit_drive<hw::ak60_6, 2>, hw::mounting{}, servo> {};
using joints = hw::joint_list<turning_joint, pulled_joint>;

using state_space = hw::joint_states<joints>;
// Before and after the emergency stop.
using wishes = std::array<hw::wanted_point, 2>;
using both = std::array<hw::set_point, 2>;
template <class Point>
using space_of = std::
    conditional_t<std::is_same_v<Point, hw::wanted_point>, hw::wanted_points<joints>, hw::set_points<joints>>;
using measured = std::array<hw::joint_state, 2>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
constexpr std::int64_t millisecond = 1'000'000;
constexpr auto running = hw::motion_phase::running;

constexpr hw::joint_state at(double angle, double velocity = 0, hw::motion_phase phase = running) {
  return {angle, velocity, 0, safety_rule::none, phase};
}
constexpr measured in_the_middle{at(0), at(1)};
constexpr both none{hw::set_point{}, hw::set_point{{.position = 1}}};
constexpr wishes no_wish{hw::wanted_point{}, hw::wanted_point{{.position = 1}}};

template <class Point>
cca::in<"wanted", space_of<Point>> as_wanted(const std::array<Point, 2>& all, std::int64_t origin = 0) {
  typename space_of<Point>::vector_type v;
  for (std::size_t i = 0; i < all.size(); ++i) all[i].put(v, i);
  return {v, origin, true};
}
cca::in<"joints", state_space> as_joints(const measured& all) {
  state_space::vector_type v;
  for (std::size_t i = 0; i < all.size(); ++i) all[i].put(v, i);
  return {v, 0, true};
}
template <class Out>
auto points_of(const Out& safe) {
  using point = std::conditional_t<std::is_same_v<typename Out::space, space_of<hw::set_point>>,
                                   hw::set_point, hw::wanted_point>;
  return std::array{point::of(safe.vector(), 0), point::of(safe.vector(), 1)};
}

template <class Guard, class Point>
auto pass(Guard& g, const std::array<Point, 2>& all, const measured& where, std::int64_t beat = 0) {
  return points_of(g.act(as_wanted(all), as_joints(where), cca::beat(beat, millisecond, 1)));
}
template <class Guard, class Point>
auto pass(Guard& g, const std::array<Point, 2>& all, std::int64_t beat = 0, std::int64_t origin = 0) {
  return points_of(g.act(as_wanted(all, origin), cca::beat(beat, millisecond, 1)));
}

// So that a test may write {a, b}.
template <class Guard>
both pass(Guard& g, const both& all, const measured& where, std::int64_t beat = 0) {
  return pass<Guard, hw::set_point>(g, all, where, beat);
}

template <class Point>
bool same(const Point& a, const Point& b) {
  return a.position == b.position && a.velocity == b.velocity && a.torque == b.torque &&
         a.stiffness == b.stiffness && a.damping == b.damping && a.mark == b.mark;
}
double torque_made(const hw::set_point& s, const hw::joint_state& q) {
  return s.stiffness * (s.position - q.angle) + s.damping * (s.velocity - q.velocity) + s.torque;
}

// What the limits make of one set point of a joint, and what they record.
struct limited {
  hw::set_point safe;
  hw::safety_record record;
};
template <std::size_t Joint = 0>
limited limit(const hw::set_point& s, const hw::joint_state& q, std::int64_t beat = 0) {
  hw::limit_guard<joints> g;
  both all = none;
  measured where = in_the_middle;
  all[Joint] = s, where[Joint] = q;
  const both safe = pass(g, all, where, beat);
  CHECK_MESSAGE(same(safe[1 - Joint], none[1 - Joint]), "the other joint stays as it is");
  return {safe[Joint], g.record()};
}

void records(const hw::safety_record& r, safety_rule rule, int joint, std::int64_t beat, std::int64_t count) {
  CHECK(r.first.rule == rule);
  CHECK(r.first.joint == joint);
  CHECK(r.first.beat == beat);
  CHECK(r.count == count);
}
void records_nothing(const hw::safety_record& r) { records(r, safety_rule::none, -1, -1, 0); }

// One number of a set point, all others 0, at, inside and beyond its limits.
void holds(double hw::set_point::* number, double lower, double upper, safety_rule rule) {
  const double inside = (lower + upper) / 2;
  const auto becomes = [&](double wanted, double expected) {
    CAPTURE(wanted);
    hw::set_point s;
    s.*number = wanted;
    const limited l = limit(s, at(no_number), 7);
    hw::set_point should;
    should.*number = expected;
    CHECK(same(l.safe, should));
    if (wanted == expected) records_nothing(l.record);
    else records(l.record, rule, 0, 7, 1);
  };
  for (const double x : {lower, inside, upper}) becomes(x, x);
  for (const double over : {1e-9, 1.0, 1e12}) becomes(lower - over, lower), becomes(upper + over, upper);
  for (const double x : {no_number, inf, -inf}) becomes(x, 0);
}

}  // namespace

TEST_SUITE("guards") {
  TEST_CASE("limits: each number at, inside and beyond its limits") {
    holds(&hw::set_point::position, -1, 2, safety_rule::range);
    holds(&hw::set_point::velocity, -3, 4, safety_rule::range);
    holds(&hw::set_point::stiffness, 0, 50, safety_rule::range);
    holds(&hw::set_point::damping, 0, 5, safety_rule::range);
    holds(&hw::set_point::torque, -5, 6, safety_rule::torque);
    // For a joint that never reaches 0, a number that is not finite becomes the nearest end.
    for (const double x : {no_number, inf, -inf})
      CHECK(limit<1>({{.position = x}}, at(1)).safe.position == 0.5);
  }

  TEST_CASE("limits: the torque that the drive will make stays within its limits: the whole law is scaled") {
    const auto makes = [](const hw::set_point& s, const hw::joint_state& q, double expected) {
      const limited l = limit(s, q, 3);
      const double wanted = torque_made(s, q);
      CAPTURE(wanted);
      CHECK(torque_made(l.safe, q) == doctest::Approx(expected));
      CHECK(l.safe.position == s.position);
      CHECK(l.safe.velocity == s.velocity);
      if (wanted == expected) {
        CHECK(same(l.safe, s));
        records_nothing(l.record);
      } else {
        const double part = expected / wanted;
        CHECK(l.safe.stiffness == doctest::Approx(part * s.stiffness));
        CHECK(l.safe.damping == doctest::Approx(part * s.damping));
        CHECK(l.safe.torque == doctest::Approx(part * s.torque));
        records(l.record, safety_rule::torque, 0, 3, 1);
      }
    };
    makes({{.position = 0.5, .stiffness = 8}}, at(0), 4);
    makes({{.position = 0.75, .stiffness = 8}}, at(0), 6);
    makes({{.position = 1.5, .stiffness = 8}}, at(0), 6);
    makes({{.position = -0.625, .stiffness = 8}}, at(0), -5);
    makes({{.position = -0.75, .stiffness = 8}}, at(0), -5);
    makes({{.velocity = 2, .damping = 2.5}}, at(0, -0.5), 6);  // 6.25
    makes({{.velocity = -2, .damping = 2.5}}, at(0, 0.5), -5);
    makes({{.position = 0.25, .velocity = 1, .torque = 2, .stiffness = 8, .damping = 2}}, at(0), 6);
    makes({{.position = 0.25, .velocity = 1, .torque = 3, .stiffness = 8, .damping = 2}}, at(0), 6);
    makes({{.position = 2, .torque = -3, .stiffness = 4}}, at(0),
          5);  // together they are within the limits, one alone would not be
    // The law counts where the joint is and how fast it moves, not only the command.
    makes({{.position = 1.5, .stiffness = 8}}, at(1), 4);
    makes({{.position = 0, .velocity = 2, .damping = 4}}, at(0, 1), 4);
  }

  TEST_CASE("limits: at and beyond a stop only torque that leads back - before them either way") {
    const auto stop = [](double angle, double torque, bool may) {
      CAPTURE(angle);
      CAPTURE(torque);
      // The ways in which a set point makes a torque.
      const std::array<std::pair<hw::set_point, hw::joint_state>, 3> ways{{
          {{{.torque = torque}}, at(angle)},
          {{{.position = torque > 0 ? 2.0 : -1.0, .torque = torque, .stiffness = 0.001}}, at(angle)},
          {{{.damping = 1}}, at(angle, -torque)},
      }};
      for (const auto& [s, q] : ways) {
        const limited l = limit(s, q, 9);
        if (may) {
          CHECK(same(l.safe, s));
          records_nothing(l.record);
        } else {
          CHECK(l.safe.stiffness == 0);
          CHECK(l.safe.damping == 0);
          CHECK(l.safe.torque == 0);
          records(l.record, safety_rule::stop, 0, 9, 1);
        }
      }
    };
    for (const double angle : {2.0, 2.0 + 1e-9, 2.5}) {
      stop(angle, 1, false);
      stop(angle, -1, true);
    }
    for (const double angle : {-1.0, -1.0 - 1e-9, -1.5}) {
      stop(angle, -1, false);
      stop(angle, 1, true);
    }
    for (const double angle : {2.0 - 1e-9, 0.0, -1.0 + 1e-9}) {
      stop(angle, 1, true);
      stop(angle, -1, true);
    }
    // Beyond it, at most the largest torque that leads back.
    CHECK(limit({{.position = 2, .stiffness = 50}}, at(2.5)).safe.stiffness ==
          doctest::Approx(10));  // -25 becomes -5
    CHECK(limit({{.position = -1, .stiffness = 50}}, at(-1.5)).safe.stiffness ==
          doctest::Approx(12));  // 25 becomes 6
  }

  TEST_CASE("limits: faster than its limit a joint gets only torque that brakes") {
    const auto gets = [](double velocity, double torque, double expected) {
      CAPTURE(velocity);
      CAPTURE(torque);
      const limited l = limit({{.torque = torque}}, at(0, velocity), 5);
      CHECK(l.safe.torque == expected);
      if (torque == expected) records_nothing(l.record);
      else records(l.record, safety_rule::torque, 0, 5, 1);
    };
    for (const double torque : {1.0, -1.0}) gets(4, torque, torque), gets(-3, torque, torque);
    for (const double velocity : {4 + 1e-9, 9.0}) gets(velocity, 1, 0), gets(velocity, -1, -1);
    for (const double velocity : {-3 - 1e-9, -9.0}) gets(velocity, -1, 0), gets(velocity, 1, 1);
    CHECK(limit({{.damping = 0.5}}, at(0, 9)).safe.damping == 0.5);
  }

  TEST_CASE(
      "limits: a joint that can only be pulled gets nothing where a push is wanted, and nothing is "
      "recorded") {
    const auto gets = [](double torque, const hw::joint_state& q, double expected) {
      const limited l =
          limit<1>({{.position = q.angle, .velocity = 1, .torque = torque, .damping = 0}}, q, 6);
      CHECK(l.safe.torque == expected);
      return l.record;
    };
    records_nothing(gets(7, at(1), 7));
    records(gets(7.5, at(1), 7), safety_rule::torque, 1, 6, 1);
    const hw::set_point pushing{{.position = 0.5, .stiffness = 10}};
    const limited l = limit<1>(pushing, at(1));
    CHECK(l.safe.stiffness == 0);
    records_nothing(l.record);
    records(gets(1, at(1.5), 0), safety_rule::stop, 1, 6, 1);
    records_nothing(gets(1, at(0.5), 1));                   // away from its lower end
    CHECK(limit<1>(pushing, at(1.5)).safe.stiffness == 0);  // its spring leads it back
  }

  TEST_CASE("limits: without a measured angle the law can't be judged, but the numbers can") {
    const hw::set_point strong{{.position = 2, .velocity = 4, .torque = 6, .stiffness = 50, .damping = 5}};
    const limited l = limit(strong, at(no_number));
    CHECK(same(l.safe, strong));
    records_nothing(l.record);
  }

  TEST_CASE("limits: the first change is kept until the next start") {
    hw::limit_guard<joints> g;
    pass(g, none, in_the_middle, 16);
    records_nothing(g.record());
    pass(g, {none[0], {{.position = 9}}}, in_the_middle, 17);
    records(g.record(), safety_rule::range, 1, 17, 1);
    pass(g, {hw::set_point{{.position = 9, .torque = 9}}, none[1]}, in_the_middle, 18);
    records(g.record(), safety_rule::range, 1, 17, 3);
    g.on_start();
    records_nothing(g.record());
    pass(g, {hw::set_point{{.torque = 9}}, none[1]}, in_the_middle, 2);
    records(g.record(), safety_rule::torque, 0, 2, 1);
  }

  TEST_CASE(
      "rate: a start goes slowly from where the joint is until it has reached the command - then as fast as "
      "the "
      "axis may") {
    hw::rate_guard<joints> g;
    const auto to = [&](double position, std::int64_t beat, hw::motion_phase phase = running) {
      return pass(g, {hw::set_point{{.position = position}}, none[1]}, {at(0.25, 0, phase), at(1, 0, phase)},
                  beat)[0];
    };
    hw::set_point s = to(1, 0, hw::motion_phase::begins);
    CHECK(s.position == 0.25 + 2 * 1e-3);  // approach: 2 rad/s
    CHECK(s.velocity == 2);
    s = to(-1, 1);
    CHECK(s.position == doctest::Approx(0.25));
    CHECK(s.velocity == -2);
    s = to(0.2505, 2);
    CHECK(s.position == 0.2505);
    CHECK_FALSE(g.approaching());
    records_nothing(g.record());   // a slow start is no violation
    s = to(0.2505 + 4 * 1e-3, 3);  // as fast as the axis may
    CHECK(s.position == 0.2505 + 4 * 1e-3);
    CHECK(s.velocity == 0);  // unchanged
    records_nothing(g.record());
    s = to(1, 4);
    CHECK(s.position == doctest::Approx(0.2585));
    CHECK(s.velocity == 4);
    records(g.record(), safety_rule::rate, 0, 4, 1);
    s = to(-1, 5);
    CHECK(s.position == doctest::Approx(0.2555));
    CHECK(s.velocity == -3);
    s = to(0.2555 - 1e-3, 6);
    CHECK(s.position == 0.2555 - 1e-3);
    records(g.record(), safety_rule::rate, 0, 4, 2);
    g.on_start();
    records_nothing(g.record());
    CHECK(g.approaching());
  }

  TEST_CASE("rate: a start is never faster than the axis, whatever `approach` says") {
    hw::rate_guard<joints> g;
    g.p.approach = 50;
    const measured where{at(0, 0, hw::motion_phase::begins), at(1, 0, hw::motion_phase::begins)};
    CHECK(pass(g, {hw::set_point{{.position = 1}}, none[1]}, where)[0].position == 4 * 1e-3);
    CHECK(pass(g, {hw::set_point{{.position = -1}}, none[1]}, where)[0].position == -3 * 1e-3);
  }

  TEST_CASE("rate: after a pause of the loop a position moves by one beat's way at most") {
    hw::rate_guard<joints> g;
    const auto safe =
        g.act(as_wanted(both{hw::set_point{{.position = 1}}, none[1]}),
              as_joints({at(0, 0, hw::motion_phase::begins), at(1)}), cca::beat(90, millisecond, 50));
    CHECK(points_of(safe)[0].position == 2 * 1e-3);
  }

  TEST_CASE(
      "rate: the torque of a set point follows `torque_rate`, from 0 at a start - without it, the whole "
      "range "
      "in "
      "10 ms") {
    hw::rate_guard<joints> g;
    const auto to = [&](double first, double second, std::int64_t beat, hw::motion_phase phase = running) {
      const both all{hw::set_point{{.torque = first}}, hw::set_point{{.position = 1, .torque = second}}};
      return pass(g, all, {at(0, 0, phase), at(1, 0, phase)}, beat);
    };
    both safe = to(0.1, 0.7, 0, hw::motion_phase::begins);
    CHECK(safe[0].torque == 0.1);  // 100 N m/s
    CHECK(safe[1].torque == 0.7);  // 7 N m in 10 ms
    records_nothing(g.record());
    safe = to(0.1, 5, 1);
    CHECK(safe[1].torque == doctest::Approx(1.4));
    records(g.record(), safety_rule::rate, 1, 1, 1);
    safe = to(5, -5, 2);
    CHECK(safe[0].torque == doctest::Approx(0.2));
    CHECK(safe[1].torque == doctest::Approx(0.7));
    safe = to(-5, 0.7, 3);
    CHECK(safe[0].torque == doctest::Approx(0.1));
    records(g.record(), safety_rule::rate, 1, 1, 4);
    safe = to(5, 0.7, 4, hw::motion_phase::begins);
    CHECK(safe[0].torque == doctest::Approx(0.1));
  }

  TEST_CASE(
      "rate: in other modes than `run` a set point passes unchanged, and the next run begins where the joint "
      "then is") {
    hw::rate_guard<joints> g;
    const auto to = [&](const hw::set_point& s, const hw::joint_state& q) {
      return pass(g, {s, none[1]}, {q, at(1)})[0];
    };
    const hw::set_point held{{.position = 1, .torque = 3, .stiffness = 5}, hw::motion_mode::soft};
    CHECK(same(to(held, at(-0.5)), held));
    const hw::set_point early{{.position = 1, .torque = 3}};
    CHECK(same(to(early, at(-0.5, 0, hw::motion_phase::enabling)), early));
    CHECK(to(early, at(0.75)).position == -0.5 + 2 * 1e-3);
    CHECK(same(to(held, at(7)), held));
    CHECK(to({{.position = 0}}, at(0)).position == 2 - 2 * 1e-3);  // begins within the range
    records(g.record(), safety_rule::rate, 0, 0, 1);               // by the torque
  }

  TEST_CASE(
      "finite: for NaN or infinity in any number the last finite set point goes on, without velocity and "
      "torque, and is marked") {
    const wishes good{hw::wanted_point{{0.1, 0.2, 0.3, 4, 0.5}}, hw::wanted_point{{1.1, 1.2, 1.3, 14, 1.5}}};
    for (const std::size_t joint : {0u, 1u})
      for (double hw::wanted_point::* number :
           {static_cast<double hw::wanted_point::*>(&hw::wanted_point::position),
            static_cast<double hw::wanted_point::*>(&hw::wanted_point::velocity),
            static_cast<double hw::wanted_point::*>(&hw::wanted_point::torque),
            static_cast<double hw::wanted_point::*>(&hw::wanted_point::stiffness),
            static_cast<double hw::wanted_point::*>(&hw::wanted_point::damping)})
        for (const double x : {no_number, inf, -inf}) {
          hw::finite_guard<joints> g;
          const wishes before = pass(g, good, 40);
          CHECK(same(before[0], good[0]));
          CHECK(same(before[1], good[1]));
          records_nothing(g.record());
          wishes bad{hw::wanted_point{{9, 9, 9, 9, 9}}, hw::wanted_point{{9, 9, 9, 9, 9}}};
          const hw::wanted_point other = bad[1 - joint];
          bad[joint].*number = x;
          const wishes safe = pass(g, bad, 41);
          CHECK(same(safe[1 - joint], other));
          hw::wanted_point expected = good[joint];
          expected.velocity = expected.torque = 0;
          expected.mark = safety_rule::not_finite;
          CHECK(same(safe[joint], expected));
          records(g.record(), safety_rule::not_finite, static_cast<int>(joint), 41, 1);
          bad[0].damping = no_number;
          pass(g, bad, 42);
          CHECK(g.record().first.joint == static_cast<int>(joint));
          CHECK(g.record().first.beat == 41);
          g.on_start();
          records_nothing(g.record());
          const wishes first = pass(g, bad, 0);  // there was none before: no stiffness, no torque
          CHECK(first[0].stiffness == 0);
          CHECK(first[0].damping == 0);
        }
  }

  TEST_CASE("stale: by the age of the data, for all joints, and no number changes") {
    hw::stale_guard<joints> g;  // 50 ms
    const wishes good{hw::wanted_point{{0.1, 0.2, 0.3, 4, 0.5}}, hw::wanted_point{{1.1, 1.2, 1.3, 14, 1.5}}};
    const auto is_stale = [&](std::int64_t beat, std::int64_t origin) {
      const wishes safe = pass(g, good, beat, origin);
      bool all = true;
      for (std::size_t i = 0; i < 2; ++i) {
        hw::wanted_point s = safe[i];
        all = all && s.broken() == safety_rule::stale;
        CHECK((s.broken() == safety_rule::stale || s.broken() == safety_rule::none));
        s.mark = safety_rule::none;
        CHECK(same(s, good[i]));
      }
      return all;
    };
    CHECK_FALSE(is_stale(100, 100 * millisecond));
    CHECK_FALSE(is_stale(150, 100 * millisecond));
    CHECK_FALSE(is_stale(1000, cca::never));  // nothing has come yet, so there is no age
    records_nothing(g.record());
    CHECK(is_stale(150, 100 * millisecond - 1));
    records(g.record(), safety_rule::stale, -1, 150, 1);
    CHECK(is_stale(151, 100 * millisecond));
    records(g.record(), safety_rule::stale, -1, 150, 2);
    g.on_start();
    records_nothing(g.record());
    g.p.greatest_age = 0.01;
    CHECK_FALSE(is_stale(110, 100 * millisecond));
    CHECK(is_stale(111, 100 * millisecond));

    wishes marked = good;
    marked[1].trip(safety_rule::not_finite);
    const wishes safe = pass(g, marked, 111, 100 * millisecond);
    CHECK(safe[0].broken() == safety_rule::stale);
    CHECK(safe[1].broken() == safety_rule::not_finite);  // the first rule that it broke
  }

  TEST_CASE("stale: an origin in the future counts as its arrival") {
    hw::stale_guard<joints> g;  // 50 ms
    const auto is_stale = [&](std::int64_t beat, std::int64_t origin) {
      return pass(g, no_wish, beat, origin)[0].broken() == safety_rule::stale;
    };
    const std::int64_t ahead = 5000 * millisecond;
    for (std::int64_t k = 10; k <= 60; ++k) CHECK_FALSE(is_stale(k, ahead));
    CHECK(is_stale(61, ahead));  // frozen
    CHECK(is_stale(4000, ahead));
    for (std::int64_t k = 4001; k < 4200; ++k) CHECK_FALSE(is_stale(k, ahead + k));  // a clock that is ahead
    g.on_start();
    CHECK_FALSE(is_stale(4500, ahead));
  }

  TEST_CASE("emergency stop: any thread may press it, and a start does not release it") {
    hw::emergency_stop<joints> stop;
    const measured begin{at(0, 0, hw::motion_phase::begins), at(1, 0, hw::motion_phase::begins)};
    std::thread hand([&] {
      for (int i = 0; i < 1000; ++i) stop.press(), stop.stop_softly(), stop.release();
      stop.press();
    });
    for (int k = 0; k < 1000; ++k) pass(stop, no_wish, begin, k);
    hand.join();
    stop.on_start();
    pass(stop, no_wish, begin, 1000);
    CHECK(stop.mode() == hw::motion_mode::damped);
    CHECK(stop.first_cause().rule == safety_rule::pressed);
    stop.release();
    pass(stop, no_wish, begin, 1001);
    CHECK(stop.mode() == hw::motion_mode::run);
  }

  TEST_CASE("emergency stop: the mode that each rule leads to, and whether it names a joint") {
    const auto trip = [](safety_rule rule, bool of_the_joint) {
      hw::emergency_stop<joints> stop;
      measured begin{at(0, 0, hw::motion_phase::begins), at(1, 0, hw::motion_phase::begins)};
      CHECK(pass(stop, no_wish, begin, 3)[0].mode() == hw::motion_mode::run);
      measured where = in_the_middle;
      wishes all = no_wish;
      if (of_the_joint) where[1].trip = rule;
      else all[1].trip(rule);
      const both safe = pass(stop, all, where, 12);
      CHECK(safe[0].mode() == stop.mode());
      CHECK(safe[1].mode() == stop.mode());
      where[0].trip = safety_rule::drive_fault;  // later, so not the first cause
      pass(stop, no_wish, where, 13);
      CHECK(stop.mode() == hw::motion_mode::damped);
      CHECK(stop.first_cause().rule == rule);
      CHECK(stop.first_cause().beat == 12);
      return std::pair(safe[0].mode(), stop.first_cause().joint);
    };
    using hw::motion_mode;
    for (const safety_rule rule : {safety_rule::silent, safety_rule::drive_fault, safety_rule::implausible})
      CHECK(trip(rule, true) == std::pair(motion_mode::damped, 1));
    CHECK(trip(safety_rule::not_finite, false) == std::pair(motion_mode::soft, 1));
    CHECK(trip(safety_rule::stale, false) == std::pair(motion_mode::soft, -1));
    CHECK(trip(safety_rule::stalled, true) == std::pair(motion_mode::soft, -1));
    CHECK(trip(safety_rule::sensor_board, true) == std::pair(motion_mode::damped, -1));
    CHECK(trip(safety_rule::link, true) == std::pair(motion_mode::damped, -1));
  }
}
