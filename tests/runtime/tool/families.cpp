// Every family of drives, played at the other end of a bus in memory: listed, watched, enabled, jogged,
// calibrated.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include <doctest/doctest.h>

#include <cca/base/file.hpp>

#include "../../../tools/cca_can/commands.hpp"
#include "rig.hpp"

namespace tool_test {
namespace {

struct family {
  const char* name;
  const char* listed;    // what `list` says
  bool damps_by_itself;  // between two commands
  double torque = 0.5;   // N m, of jog
};
// The largest torque of `cia402` (6072h) is 0.8 N m.
constexpr std::array families{
    family{"mit:ak80-9:3", "  mit:3  answers 000#03", true},
    family{"damiao:12.5/45/20:7", "  mit:7  answers 000#07", true},
    family{"mit-original:12.5/45/18:3", "  mit:3  answers 000#03", true},
    family{"odrive:3", "  odrive:3  ", false},
    family{"odrive-0.5:70", "  odrive:70  ", false},
    family{"moteus:20/0.8:4", "  moteus:4  answers 400##", true},
    family{"robstride:rs01:5", "  robstride:5  answers 020005FD#", true},
    family{"cia402-torque:4096/0.8:9", "  cia402:9  answers 589#4300100092010200", false},
    family{"cia402:4096/0.8:9", "  cia402:9  answers 589#4300100092010200", true, 0.9}};

family family_named(std::string_view name) {
  const auto at = std::ranges::find(families, name, [](const family& f) { return std::string_view(f.name); });
  REQUIRE(at != families.end());
  return *at;
}

double law_of(any_virtual& v, std::int64_t now) {
  const hw::drive_command c = v.law(now);
  const auto& q = v.motor.now;
  return c.stiffness * (c.position - q.position) + c.damping * (c.velocity - q.velocity) + c.torque;
}

struct family_rig : rig {
  explicit family_rig(const family& f) : rig({f.name}), drive(drive_named(f.name, true, true)) {
    order.limits.torque = f.torque;
    each = [this] {
      strongest =
          std::max(strongest, std::abs(std::clamp(law_of(*drives[0], clock), -drives[0]->motor.most_torque,
                                                  drives[0]->motor.most_torque)));
      fastest = std::max(fastest, std::abs(drives[0]->motor.now.velocity));
      if (then) then();
    };
  }
  bool is_off() { return law_of(*drives[0], clock) == 0; }
  double angle() const { return drives[0]->motor.now.position; }
  ending jogs() { return jog(bus, "can0", *drive, order, *this, say); }

  std::unique_ptr<any_drive> drive;
  jog_order order{
      .limits = {.low = -0.2, .high = 0.2, .speed = 0.5, .torque = 0.5, .stiffness = 5, .damping = 0.2},
      .goal = 0.15};
  double strongest = 0, fastest = 0;
  std::function<void()> then{};
};

}  // namespace

TEST_SUITE("every family") {
  TEST_CASE("is found, and watched") {
    for (const family& f : families) {
      CAPTURE(f.name);
      rig r({f.name});
      list(r.bus, {.ask = {"mit", "moteus", "robstride", "cia402"}, .first = 1, .last = 9, .listen = 0.5}, r,
           r.say);
      CHECK_MESSAGE(r.printed(f.listed), r.out.str());
      rig w({f.name});
      w.drives[0]->motor.now.position = 0.2502;
      std::vector<std::unique_ptr<any_drive>> drives;
      drives.push_back(drive_named(f.name));
      CHECK(watch(w.bus, drives, true, 2, w, w.say) == done);
      CHECK_MESSAGE(w.printed("0.25"), w.out.str());
      CHECK(law_of(*w.drives[0], w.clock) == 0);
    }
  }
  TEST_CASE("is enabled at its position, and disabled at the end and at ctrl-c") {
    for (const family& f : families) {
      CAPTURE(f.name);
      family_rig r(f);
      r.drives[0]->motor.now.position = 0.1;
      const auto named = drive_named(f.name);
      CHECK_MESSAGE(enable(r.bus, "can0", *named, 1, r, r.say) == done, r.error.str());
      // On the wire of an MIT drive no torque is half a step off zero: 2 mN m, against no friction, for a
      // second.
      CHECK(std::abs(r.angle() - 0.1) < (named->takes_gains() ? 0.2 : 0.002));
      CHECK(r.printed("disabled"));
      CHECK(r.is_off());
      family_rig c(f);
      c.ctrl_c = 700 * ms;
      const auto again = drive_named(f.name);
      enable(c.bus, "can0", *again, 0, c, c.say);
      CHECK(c.is_off());
    }
  }
  TEST_CASE("is jogged within its limits, and disabled") {
    for (const family& f : families) {
      CAPTURE(f.name);
      family_rig r(f);
      CHECK_MESSAGE(r.jogs() == done, r.error.str());
      CHECK(r.angle() == doctest::Approx(0.15).epsilon(0.15));
      CHECK(r.strongest <= f.torque + 0.03);
      CHECK(r.strongest > 0.01);
      CHECK(r.fastest < 0.7);
      CHECK(r.is_off());
    }
  }
  TEST_CASE(
      "when pushed, it makes no more torque than allowed at its last report - in torque mode never more") {
    for (const family& f : families) {
      CAPTURE(f.name);
      family_rig r(f);
      r.drives[0]->load = 3;
      CHECK(r.jogs() == failed);
      CHECK((r.printed("it left its range") || r.printed("it is faster than twice the speed")));
      CHECK(r.strongest <= (f.damps_by_itself ? 2 * f.torque : f.torque + 1e-3));
      CHECK(r.is_off());
    }
  }
  TEST_CASE("held, it gets half of the torque and is then disabled - a fault and silence end jog") {
    for (const family& f : families) {
      CAPTURE(f.name);
      family_rig held(f);
      held.drives[0]->motor.inertia = 1e6;
      CHECK(held.jogs() == failed);
      CHECK_MESSAGE(held.printed("it does not get there"), held.error.str());
      CHECK(held.strongest <= f.torque + 0.03);
      CHECK(held.is_off());
      family_rig silent(f);
      silent.then = [&] { silent.drives[0]->go_silent(silent.clock > 400 * ms); };
      CHECK(silent.jogs() == failed);
      CHECK_MESSAGE(silent.printed("it does not answer any more"), silent.error.str());
      CHECK(silent.is_off());
      family_rig ctrl_c(f);
      ctrl_c.ctrl_c = 400 * ms;
      CHECK(ctrl_c.jogs() == interrupted);
      CHECK(ctrl_c.is_off());
    }
  }
  TEST_CASE("is calibrated without torque") {
    const std::string file = "cca_can_family.toml";
    for (const family& f : families) {
      CAPTURE(f.name);
      std::remove(file.c_str());
      family_rig r(f);
      r.drives[0]->motor.now.position = 0.25;
      const auto named = drive_named(f.name);
      const calibrate_order o{.joint = joint_named("left_hind_knee"), .at = 0.5, .file = file};
      CHECK_MESSAGE(calibrate(r.bus, "can0", *named, o, r, r.say) == done, r.error.str());
      const auto read = read_offset_file(cca::detail::read_file(file), o.node);
      REQUIRE(read);
      CHECK((*read)[6] == doctest::Approx(0.25).epsilon(0.01));
      CHECK(r.strongest == 0);
    }
    std::remove(file.c_str());
  }
  TEST_CASE("a CANopen drive in another mode, or with a larger torque setting, is not enabled") {
    const family torque = family_named("cia402-torque:4096/0.8:9"),
                 position = family_named("cia402:4096/0.8:9");
    rig other({position.name});
    const auto as_torque_drive = drive_named(torque.name);
    jog_order o{
        .limits = {.low = -0.2, .high = 0.2, .speed = 0.5, .torque = 0.5, .stiffness = 5, .damping = 0.2},
        .goal = 0.15};
    CHECK(jog(other.bus, "can0", *as_torque_drive, o, other, other.say) == failed);
    CHECK(other.printed("it is configured for mode 8 (6061h), and its name says 10"));
    CHECK(enable(other.bus, "can0", *as_torque_drive, 1, other, other.say) == failed);
    rig strong({position.name});
    const auto as_position_drive = drive_named(position.name);
    CHECK(jog(strong.bus, "can0", *as_position_drive, o, strong, strong.say) == failed);
    CHECK_MESSAGE(strong.printed("may use 0.800000 N m (6072h): set that to at most 625 thousandths"),
                  strong.error.str());
    CHECK(law_of(*strong.drives[0], strong.clock) == 0);
    rig mute({torque.name});
    mute.each = [&] { mute.drives[0]->go_silent(mute.clock > 20 * ms); };
    CHECK(jog(mute.bus, "can0", *as_torque_drive, o, mute, mute.say) == failed);
  }
}

}  // namespace tool_test
