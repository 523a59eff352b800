// The commands, on a bus in memory with drives at the other end.
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>

#include <doctest/doctest.h>

#include <cca/config.hpp>
#include <cca/hardware/oncilla.hpp>

#include "../../../tools/cca_can/commands.hpp"
#include "rig.hpp"

namespace tool_test {
namespace {

constexpr const char* name = "damiao:12.5/45/20:7";
const hw::can_frame leave = hw::mit_special_frame(hw::standard(7), hw::mit_special::leave);
const hw::can_frame enter = hw::mit_special_frame(hw::standard(7), hw::mit_special::enter);

std::size_t count(const std::vector<hw::can_frame>& all, const hw::can_frame& f) {
  return static_cast<std::size_t>(std::count(all.begin(), all.end(), f));
}

// Every half millisecond it looks at the drive: the torque of its law at its position, and the position that
// it is commanded to.
struct jog_rig : rig {
  explicit jog_rig(std::span<const hw::bus_fault> script = {}) : rig({name}, script) {
    each = [this] {
      const auto& q = drives[0]->motor.now;
      const hw::drive_command c = drives[0]->law(clock);
      const double law =
          c.stiffness * (c.position - q.position) + c.damping * (c.velocity - q.velocity) + c.torque;
      strongest = std::max(strongest, std::abs(law));
      fastest = std::max(fastest, std::abs(q.velocity));
      if (c.stiffness > 0.2) farthest = std::max(farthest, std::abs(c.position));
      if (then) then();
    };
  }
  double strongest = 0, fastest = 0, farthest = 0;
  std::function<void()> then{};
  jog_order order{
      .limits = {.low = -0.2, .high = 0.2, .speed = 0.5, .torque = 0.5, .stiffness = 5, .damping = 0.2},
      .goal = 0.15};
  std::unique_ptr<any_drive> drive = drive_named(name);
  ending run() { return jog(bus, "can0", *drive, order, *this, say); }
  double angle() const { return drives[0]->motor.now.position; }
  bool is_off() {
    return drives[0]->law(clock).stiffness == 0 && drives[0]->law(clock).damping == 0 &&
           last_of(leave.id) == leave;
  }
};

}  // namespace

TEST_SUITE("list and watch") {
  TEST_CASE("an MIT drive is found by asking, and no frame moves it") {
    rig r({"mit:ak80-9:3", name});
    CHECK(list(r.bus, {.ask = {"mit"}, .first = 1, .last = 10}, r, r.say) == done);
    CHECK(r.printed("  mit:3  answers 000#03"));
    CHECK(r.printed("  mit:7  answers 000#07"));
    CHECK_FALSE(r.printed("mit:4"));
    for (const hw::can_frame& f : r.seen)
      if (f.id != hw::standard(0)) CHECK(f == hw::mit_special_frame(f.id, hw::mit_special::leave));
    CHECK(r.seen.size() == 12);
  }
  TEST_CASE("without --ask nothing is sent, and drives that report by themselves are found") {
    rig r({name});
    r.each = [&] {
      if (r.clock % (100 * ms) == 0)
        r.far.send(std::array{hw::odrive<5, hw::odrive_mode::position>::heartbeat(8),
                              hw::can_frame{.id = hw::standard(0x709), .length = 1, .data = {0x7F}}});
    };
    CHECK(list(r.bus, {}, r, r.say) == done);
    CHECK(r.printed("  odrive:5  "));
    CHECK(r.printed("enabled"));
    CHECK(r.printed("  cia402:9  heartbeat: pre-operational"));
    CHECK(r.bus.counters().sent == 0);
  }
  TEST_CASE("a number under whose id somebody sends is not asked") {
    rig r({name});
    r.each = [&] {
      if (r.clock % (10 * ms) == 0) r.spy.send(std::array{drive_named(name)->set_point({}, 0).frames[0]});
    };
    CHECK(list(r.bus, {.ask = {"mit"}, .first = 7, .last = 7}, r, r.say) == failed);
    CHECK(r.printed("mit:7  not asked: someone sends under its id, 007#7FFF7FF0000007FF"));
    CHECK(r.bus.counters().sent == 0);
  }
  TEST_CASE("a CANopen drive answers for its type, a moteus for its registers") {
    rig r;
    r.each = [&] {
      std::array<hw::received_frame, 8> frames;
      const std::size_t n = r.far.receive(frames);
      for (std::size_t i = 0; i < n; ++i) {
        if (frames[i].frame.id == hw::standard(0x609))
          r.far.send(std::array{hw::can_frame{
              .id = hw::standard(0x589), .length = 8, .data = {0x43, 0, 0x10, 0, 0x92, 1, 2, 0}}});
        if (frames[i].frame.id == hw::extended(0x8004))
          r.far.send(std::array{hw::moteus<unit_moteus_motor, 4>::reply(0, 1, 0, 0)});
      }
    };
    CHECK(list(r.bus, {.ask = {"cia402", "moteus"}, .first = 1, .last = 9}, r, r.say) == done);
    CHECK(r.printed("  cia402:9  answers 589#4300100092010200"));
    CHECK(r.printed("  moteus:4  answers 400##1"));
  }
  TEST_CASE("a bus that is down, or empty, is reported") {
    const std::array away{
        hw::bus_fault{.what = hw::bus_trouble::link_down, .until = 1'000'000'000'000, .end = 0}};
    rig r({name}, away);
    CHECK(list(r.bus, {.ask = {"mit"}}, r, r.say) == failed);
    CHECK(r.printed("the bus is down"));
    const std::array alone{
        hw::bus_fault{.what = hw::bus_trouble::link_down, .until = 1'000'000'000'000, .end = 1},
        hw::bus_fault{.what = hw::bus_trouble::link_down, .until = 1'000'000'000'000, .end = 2}};
    rig q({name}, alone);
    CHECK(list(q.bus, {.ask = {"mit"}}, q, q.say) == failed);
    CHECK(q.printed("nobody acknowledges"));
  }
  TEST_CASE("watch prints what drives report, and which are silent") {
    rig r({name});
    r.drives[0]->motor.now.position = 0.2502;
    std::vector<std::unique_ptr<any_drive>> drives;
    drives.push_back(drive_named(name));
    CHECK(watch(r.bus, drives, true, 2, r, r.say) == done);
    CHECK(r.printed("damiao:12.5/45/20:7    0.250"));
    CHECK(r.printed("disabled"));
    drives.push_back(drive_named("mit:ak80-9:3"));
    CHECK(watch(r.bus, drives, true, 2, r, r.say) == failed);
    CHECK(r.printed("mit:ak80-9:3  silent"));
    rig quiet({name});
    CHECK(watch(quiet.bus, drives, false, 2, quiet, quiet.say) == failed);
    CHECK(quiet.bus.counters().sent == 0);
  }
}

TEST_SUITE("enable") {
  TEST_CASE("it enables without torque, and disables at the end") {
    jog_rig r;
    CHECK(enable(r.bus, "can0", *r.drive, 2, r, r.say) == done);
    CHECK(r.printed("enabled"));
    CHECK(r.printed("disabled"));
    CHECK(r.strongest < 0.01);
    CHECK(r.is_off());
  }
  TEST_CASE("ctrl-c disables") {
    jog_rig r;
    r.ctrl_c = 500 * ms;
    CHECK(enable(r.bus, "can0", *r.drive, 0, r, r.say) == done);
    CHECK(r.is_off());
    jog_rig early;
    early.ctrl_c = 500 * ms;
    CHECK(enable(early.bus, "can0", *early.drive, 2, early, early.say) == interrupted);
    CHECK(early.is_off());
  }
  TEST_CASE("nothing is sent before somebody confirms") {
    jog_rig r;
    r.say.yes = false;
    CHECK(enable(r.bus, "can0", *r.drive, 2, r, r.say) == not_confirmed);
    CHECK(r.printed("there is no terminal to ask at; --yes confirms beforehand"));
    r.say.someone_is_there = true;
    r.in.str("no\n");
    CHECK(enable(r.bus, "can0", *r.drive, 2, r, r.say) == not_confirmed);
    CHECK(r.run() == not_confirmed);
    CHECK(r.bus.counters().sent == 0);
    r.in.clear();
    r.in.str("yes\n");
    CHECK(enable(r.bus, "can0", *r.drive, 1, r, r.say) == done);
  }
  TEST_CASE("a drive that is not there, or refuses") {
    rig r;
    const auto drive = drive_named(name);
    CHECK(enable(r.bus, "can0", *drive, 2, r, r.say) == failed);
    CHECK(r.printed("it does not answer: is it powered, is this its number, its bus, its bit rate?"));
    CHECK(count(r.seen, enter) == 0);
  }
}

TEST_SUITE("jog") {
  TEST_CASE("moves slowly to the goal, within the limits, and is disabled") {
    jog_rig r;
    CHECK(r.run() == done);
    CHECK(r.angle() == doctest::Approx(0.15).epsilon(0.1));
    CHECK(r.strongest <= 0.5 + 0.03);  // steps of the numbers on the wire
    CHECK(r.fastest < 0.55);
    CHECK(r.farthest <= 0.2);
    CHECK(r.is_off());
    CHECK(r.printed("disabled"));
  }
  TEST_CASE("moves by an angle, and back") {
    jog_rig r;
    r.drives[0]->motor.now.position = 0.1;
    r.order.relative = true;
    r.order.goal = -0.2;
    CHECK(r.run() == done);
    CHECK(r.angle() == doctest::Approx(-0.1).epsilon(0.1));
  }
  TEST_CASE(
      "a joint that is held gets at most half of the torque, does not jump when released, and jog gives up") {
    jog_rig r;
    r.drives[0]->motor.inertia = 1e6;
    CHECK(r.run() == failed);
    CHECK(r.printed("it does not get there: something holds it, or the torque is too small"));
    CHECK(r.strongest <= 0.5 + 0.03);
    CHECK(r.is_off());
    jog_rig freed;
    freed.drives[0]->motor.inertia = 1e6;
    freed.then = [&] {
      if (freed.clock > 1000 * ms) freed.drives[0]->motor.inertia = 0.01;
    };
    CHECK(freed.run() == done);
    CHECK(freed.strongest <=
          0.5 + 0.1);  // the drive's own law acts on a speed that the last frame did not have
    CHECK(freed.farthest <= 0.2);
  }
  TEST_CASE("a start or a goal outside of the range is refused, and nothing is enabled") {
    jog_rig r;
    r.drives[0]->motor.now.position = 0.3;
    CHECK(r.run() == failed);
    CHECK(r.printed("it is at 0.30"));
    CHECK(r.printed("outside of the range: turn it by hand, or give another range"));
    jog_rig far;
    far.order.relative = true;
    far.order.goal = 0.25;
    CHECK(far.run() == failed);
    CHECK(far.printed("rad, is outside of the range"));
    CHECK(count(r.seen, enter) + count(far.seen, enter) == 0);
  }
  TEST_CASE("a drive that is pushed out of its range is disabled") {
    jog_rig r;
    r.drives[0]->load = 3;
    CHECK(r.run() == failed);
    CHECK((r.printed("it left its range") || r.printed("it is faster than twice the speed")));
    CHECK(r.strongest <= 1);  // its damping acts on the speed gained since the last frame
    CHECK(r.is_off());
  }
  TEST_CASE("a fault, silence, a bus that goes away and ctrl-c each end it, and the drive is disabled") {
    jog_rig fault;
    fault.then = [&] {
      if (fault.clock == 200 * ms) fault.drives[0]->fail(0xA);
    };
    CHECK(fault.run() == failed);
    CHECK(fault.printed("it reports a fault: over-current (code 10)"));
    CHECK(fault.last_of(leave.id) == leave);

    jog_rig silent;
    silent.then = [&] { silent.drives[0]->go_silent(silent.clock > 200 * ms); };
    CHECK(silent.run() == failed);
    CHECK(silent.printed("it does not answer any more"));
    CHECK(silent.printed("told to disable, and does not answer"));
    CHECK(silent.is_off());

    const std::array script{
        hw::bus_fault{.what = hw::bus_trouble::link_down, .from = 200 * ms, .until = 230 * ms, .end = 0}};
    jog_rig away(script);
    CHECK(away.run() == failed);
    CHECK(away.printed("the bus is down"));
    CHECK(away.angle() < 0.14);

    jog_rig ctrl_c;
    ctrl_c.ctrl_c = 200 * ms;
    CHECK(ctrl_c.run() == interrupted);
    CHECK(ctrl_c.printed("ended by ctrl-c"));
    CHECK(ctrl_c.is_off());
    CHECK(ctrl_c.angle() < 0.14);
    CHECK(ctrl_c.angle() > 0.01);
  }
  TEST_CASE("no command breaks a limit, whatever the drive reports") {
    const jog_limits l{.low = -0.2, .high = 0.3, .speed = 0.5, .torque = 0.5, .stiffness = 20, .damping = 2};
    std::uint64_t seed = 1;
    const auto some = [&seed](double most) {
      seed = seed * 6364136223846793005u + 1442695040888963407u;
      return most * (static_cast<double>(seed >> 11) * 0x1p-52 - 1);
    };
    jog_target target;
    for (int i = 0; i < 100000; ++i) {
      hw::drive_report at;
      at.position = some(0.6);
      at.velocity = i % 7 == 0 ? hw::drive_report::untold : some(5);
      const double v = i % 7 == 0 ? 0 : at.velocity;
      const hw::drive_command c = next_jog_command(l, some(1), at, 0.005, target);
      REQUIRE(c.position >= l.low);
      REQUIRE(c.position <= l.high);
      REQUIRE(std::abs(c.velocity) <= l.speed);
      REQUIRE(std::abs(c.stiffness * (c.position - at.position) + c.damping * (c.velocity - v)) <=
              l.torque * (1 + 1e-12));
      REQUIRE(target.position == c.position);
    }
  }
}

namespace {

struct board {
  using reading = hw::board_reading;
  static constexpr std::size_t bus = 0;
  static bool decode(const hw::can_frame&, hw::board_reading&) { return false; }
};
template <class Axis, std::uint32_t Number>
struct some_joint : hw::joint<Axis, hw::mit_drive<hw::ak80_9, Number>, hw::mounting{}, hw::joint_servo{}> {};
using joints = hw::joint_list<some_joint<cca::sim::left_front_hip, 1>,
                              some_joint<cca::sim::right_front_hip, 2>,
                              some_joint<cca::sim::left_hind_hip, 3>,
                              some_joint<cca::sim::right_hind_hip, 4>,
                              some_joint<cca::sim::left_front_knee, 5>,
                              some_joint<cca::sim::right_front_knee, 6>,
                              some_joint<cca::sim::left_hind_knee, 7>,
                              some_joint<cca::sim::right_hind_knee, 8>>;
using synchronizer =
    hw::robot_synchronizer<cca::robots::oncilla::as_built, rig::wire_type::end_type, board, joints>;

// A robot as a file of parameters sees it.
struct robot {
  synchronizer s{};
  template <class F>
  void for_each_component(F f) {
    f("robot.synchronizer", s);
  }
};

}  // namespace

TEST_SUITE("calibrate") {
  TEST_CASE("the offset goes into a file that the synchronizer loads - the others stay") {
    const std::string file = "cca_can_offsets.toml";
    std::remove(file.c_str());
    rig r({name});
    r.drives[0]->motor.now.position = 0.25;
    const auto drive = drive_named(name);
    calibrate_order o{.joint = joint_named("left_hind_knee"),
                      .at = 0.5,
                      .mounted = {.gear = 2, .sign = -1, .offset = 0.1},
                      .file = file};
    CHECK(calibrate(r.bus, "can0", *drive, o, r, r.say) == done);
    o.joint = joint_named("left_front_hip");
    o.at = -0.3;
    o.mounted = {};
    CHECK(calibrate(r.bus, "can0", *drive, o, r, r.say) == done);
    robot loaded;
    cca::detail::load_parameters(loaded, file);
    CHECK(loaded.s.p.offset[6] == doctest::Approx(0.5 - (-0.25 / 2 + 0.1)).epsilon(1e-3));
    CHECK(loaded.s.p.offset[0] == doctest::Approx(-0.3 - 0.25).epsilon(1e-3));
    CHECK(loaded.s.p.offset[3] == 0);
    CHECK(r.drives[0]->law(r.clock).stiffness == 0);
    CHECK(count(r.seen, enter) == 0);
    std::remove(file.c_str());
  }
  TEST_CASE(
      "a file with other contents, a joint that moves and an offset beyond 1 rad are refused: nothing is "
      "written") {
    const std::string file = "cca_can_other.toml";
    const std::string foreign = "[robot.synchronizer]\noffset = [0,0,0,0,0,0,0,0]\n[cpg]\nfrequency = 2\n";
    cca::detail::write_file(file, foreign);
    rig r({name});
    const auto drive = drive_named(name);
    calibrate_order o{.joint = 0, .at = 0.5, .file = file};
    CHECK_THROWS_WITH_AS(calibrate(r.bus, "can0", *drive, o, r, r.say),
                         (file + ": has more in it than the offsets of [robot.synchronizer]: write into "
                                 "another file, and copy the offsets from there")
                             .c_str(),
                         cca::refused);
    CHECK(cca::detail::read_file(file) == foreign);
    std::remove(file.c_str());

    r.drives[0]->motor.now.velocity = 0.5;
    CHECK(calibrate(r.bus, "can0", *drive, o, r, r.say) == failed);
    CHECK(r.printed("hold it still; nothing was written"));
    rig far({name});
    o.at = 2;
    CHECK(calibrate(far.bus, "can0", *drive, o, far, far.say) == failed);
    CHECK(far.printed("more than 1 rad; is the sign, the gear or the angle wrong?"));
    rig nobody;
    CHECK(calibrate(nobody.bus, "can0", *drive, o, nobody, nobody.say) == failed);
    far.say.yes = false;
    o.at = 0.5;
    CHECK(calibrate(far.bus, "can0", *drive, o, far, far.say) == not_confirmed);
    CHECK_FALSE(std::filesystem::exists(file));
  }
}

TEST_SUITE("record and replay") {
  TEST_CASE("a recorded log goes out again: the same frames in the same order, at their pace") {
    rig r;
    std::vector<hw::can_frame> frames;
    for (std::uint8_t i = 0; i < 40; ++i)
      frames.push_back(i % 3 == 0 ? hw::fd(hw::extended(1000u + i), std::array<std::uint8_t, 12>{i})
                                  : hw::classic(hw::standard(i), std::array<std::uint8_t, 2>{i, 7}));
    std::size_t next = 0;
    r.each = [&] {
      if (r.clock % (5 * ms) == 0 && next < frames.size()) r.far.send({&frames[next++], 1});
    };
    std::ostringstream file;
    CHECK(record(r.bus, "can7", {.frames = 40}, file, r, r.say) == done);
    CHECK(r.printed("40 frames recorded"));
    CHECK(file.str().starts_with("(1436509052.005"));

    std::istringstream text(file.str());
    const log_file log = read_log(text, "log");
    REQUIRE(log.lines.size() == 40);
    rig again;
    CHECK(replay(again.bus, "can0", log, {}, again, again.say) == done);
    again.wait_until(again.clock + 5 * ms);
    CHECK(again.seen == frames);
    CHECK(again.clock == doctest::Approx(200 * ms).epsilon(0.05));
    rig fast;
    CHECK(replay(fast.bus, "can0", log, {.speed = 0}, fast, fast.say) == done);
    fast.wait_until(fast.clock + 20 * ms);
    CHECK(fast.seen == frames);
    CHECK(fast.clock < 50 * ms);
  }
  TEST_CASE("a log that makes no sense is refused with the line - of two interfaces one must be named") {
    std::istringstream bad("(1.0) can0 123#11\n\n(1.1) can0 123#1\n");
    CHECK_THROWS_WITH_AS(
        read_log(bad, "my.log"),
        "my.log:3: a byte has two hexadecimal digits, and one of them is missing, in `(1.1) can0 123#1`",
        cca::refused);
    std::istringstream two("(1.0) can0 123#11\n(1.1) can1 124#\n(1.2) can0 20000004#0008000000006000\n");
    const log_file log = read_log(two, "two");
    CHECK(log.errors == 1);
    std::istringstream with_loss(
        "(1.0) can0 123#R8_9\nDROPCOUNT: dropped 3 CAN frames on 'can0' socket (total drops 3)\n"
        "(1.1) can0 124#\n");
    const log_file lossy = read_log(with_loss, "lossy");
    CHECK(lossy.lines.size() == 2);
    CHECK(lossy.missing == 3);
    std::istringstream with_xl("(1.0) can0 45123#81:00:12345678#" + std::string(4096, 'A') +
                               "\n(1.1) can0 124#");
    const log_file mixed = read_log(with_xl, "mixed");
    CHECK(mixed.lines.size() == 1);
    CHECK(mixed.xl == 1);
    rig sender;
    CHECK(replay(sender.bus, "can0", mixed, {}, sender, sender.say) == done);
    CHECK(sender.printed("1 frames of CAN XL not sent"));
    std::istringstream endless("(1.0) can0 124#\n" + std::string(10'000, '\0'));
    CHECK_THROWS_WITH_AS(read_log(endless, "endless"),
                         doctest::Contains("endless:2: a line of more than 8191 bytes"), cca::refused);
    rig r;
    CHECK_THROWS_WITH_AS(replay(r.bus, "can0", log, {}, r, r.say),
                         "the log has several interfaces, can0, can1: choose one by --from", usage_error);
    CHECK_THROWS_WITH_AS(replay(r.bus, "can0", log, {.only = "can2"}, r, r.say),
                         "the log has no frame of can2, but of can0, can1", cca::refused);
    CHECK(replay(r.bus, "can0", log, {.only = "can1"}, r, r.say) == done);
    r.wait_until(r.clock + ms);
    REQUIRE(r.seen.size() == 1);
    CHECK(r.seen[0].id == hw::standard(0x124));
    CHECK(r.printed("1 error frames not sent"));
  }
  TEST_CASE("replay asks first, stops at ctrl-c, and reports a queue that stays full or a bus that is away") {
    std::ostringstream text;
    for (int i = 0; i < 100; ++i)
      text << text_of(log_line{.time = i * 100 * ms, .bus = "can0", .frame = {.id = hw::standard(1)}})
           << '\n';
    std::istringstream in(text.str());
    const log_file log = read_log(in, "log");
    rig r;
    r.ctrl_c = 1050 * ms;
    CHECK(replay(r.bus, "can0", log, {}, r, r.say) == interrupted);
    r.wait_until(r.clock + ms);
    CHECK(r.seen.size() == 11);
    rig unasked;
    unasked.say.yes = false;
    CHECK(replay(unasked.bus, "can0", log, {}, unasked, unasked.say) == not_confirmed);
    CHECK(unasked.bus.counters().sent == 0);
    const std::array alone{
        hw::bus_fault{.what = hw::bus_trouble::link_down, .until = 1'000'000'000'000, .end = 1},
        hw::bus_fault{.what = hw::bus_trouble::link_down, .until = 1'000'000'000'000, .end = 2}};
    rig nobody({}, alone);
    CHECK(replay(nobody.bus, "can0", log, {.speed = 0}, nobody, nobody.say) == failed);
    CHECK(nobody.printed("the queue stays full: does anybody acknowledge?"));
    const std::array gone{
        hw::bus_fault{.what = hw::bus_trouble::bus_off, .until = 1'000'000'000'000, .end = 0}};
    rig off({}, gone);
    CHECK(replay(off.bus, "can0", log, {}, off, off.say) == failed);
    CHECK(off.printed("the bus is bus-off"));
  }
}

TEST_SUITE("the whole line") {
  TEST_CASE("words become a command - wrong words give an exit code and a message") {
    rig r({name});
    const auto open = [&](const std::string&, bool) { return r.bus; };
    const auto ends = [&](std::vector<std::string> line) {
      r.out.str(""), r.error.str("");
      return run_and_tell(line, open, r, r.say);
    };
    CHECK(ends({"jog", "can0", name, "--range", "-0.2,0.2", "--speed", "0.5", "--torque", "0.5", "--to",
                "0.1", "--hold", "0"}) == done);
    CHECK(r.drives[0]->motor.now.position == doctest::Approx(0.1).epsilon(0.2));
    CHECK(ends({"enable", "can0", name, "--seconds", "0.5"}) == done);
    CHECK(ends({}) == done);
    CHECK(r.printed("cca-can: CAN buses and the drives on them, by hand"));
    CHECK(ends({"jg", "can0"}) == misunderstood);
    CHECK(r.error.str() == "cca-can: there is no command `jg`, did you mean `jog`? See `cca-can help`\n");
    CHECK(ends({"jog", "can0", name, "--speed", "0.5", "--torque", "0.5", "--to", "0.1"}) == misunderstood);
    CHECK(r.error.str() ==
          "cca-can: --range is missing: the angles that the drive may be at, in rad, as -0.2,0.2\n");
    CHECK(ends({"jog", "can0", name, "--range", "0.2", "--speed", "0.5", "--torque", "0.5", "--to", "0.1"}) ==
          misunderstood);
    CHECK(ends({"jog", "can0", name, "--range", "-0.2,0.2", "--torque", "0.5", "--to", "0.1"}) ==
          misunderstood);
    CHECK(r.error.str() == "cca-can: --speed is missing: rad/s, as 0.5\n");
    CHECK(ends({"jog", "can0", name, "--range", "-0.2,0.2", "--speed", "0.5", "--torque", "0.5", "--to",
                "0.3"}) == misunderstood);
    CHECK(ends({"jog", "can0", name, "--range", "-0.2,0.2", "--speed", "0.5", "--torque", "0.5", "--to",
                "0.1", "--by", "0.1"}) == misunderstood);
    CHECK(ends({"jog", "can0", "odrive:3", "--range", "-0.2,0.2", "--speed", "0.5", "--torque", "0.5", "--to",
                "0.1"}) == failed);
    CHECK(r.printed("odrive:3 on can0: it does not answer"));
    CHECK(ends({"replay", "can0", "no/such.log"}) == refused);
    CHECK(r.printed("no/such.log: cannot be read: No such file or directory"));
    CHECK(ends({"calibrate", "can0", name, "--joint", "hip", "--file", "f", "--at", "0"}) == misunderstood);
    CHECK(r.printed("--joint hip: expected one of left_front_hip, right_front_hip,"));
    CHECK(ends({"list", "can0", "--ask", "odrive"}) == misunderstood);
    CHECK(ends({"list", "can0", "--ids", "5-3"}) == misunderstood);
    CHECK(ends({"list", "can0", "--ask", "mit", "--ids", "6-8"}) == done);
    CHECK(ends({"watch", "can0", name, "--ask", "--seconds", "1", "--loud"}) == misunderstood);
    CHECK(ends({"pretend", "can0", "servo:3"}) == misunderstood);
    r.say.yes = false;
    CHECK(ends({"pretend", "can0", "odrive:3", "--seconds", "0.1"}) == not_confirmed);
    CHECK(r.printed("On can0 this answers instead of drives"));
    CHECK(ends({"pretend", "vcan0", "odrive:3", "--seconds", "0.1"}) == done);
    CHECK(ends({"pretend", "vcan0", "odrive:3", "--seconds", "0.1", "--silent-at", "0", "--silent-for",
                "0.05", "--fault-at", "0.01", "--code", "64", "--load", "-1"}) == done);
    CHECK(ends({"pretend", "vcan0", "odrive:3", "--fault-at", "0.01"}) == misunderstood);
    CHECK(r.printed("--code is missing: the firmware's number of a fault"));
    CHECK(ends({"pretend", "can0", "odrive:3", "moteus:20/0.8:2", "--seconds", "0.1", "--yes"}) == done);
  }
}

TEST_SUITE("in memory") {
  TEST_CASE("every command can be tried without CAN") {
    rig r;
    const auto open = [&](const std::string&, bool) { return r.bus; };
    const auto ends = [&](std::vector<std::string> line) {
      r.out.str(""), r.error.str("");
      return run_and_tell(line, open, r, r.say);
    };
    CHECK(ends({"list", "memory", "--ask", "mit", "--pretend", name, "--pretend", "mit:ak80-9:3"}) == done);
    CHECK(r.printed("mit:7  answers 000#07"));
    CHECK(r.printed("mit:3  answers 000#03"));
    CHECK(ends({"jog", "memory", name, "--range=-0.2,0.2", "--speed", "0.5", "--torque", "0.5", "--to",
                "0.1"}) == done);
    CHECK(r.printed("disabled"));
    CHECK(ends({"watch", "memory", "odrive:3", "--seconds", "1"}) == done);
    CHECK(ends({"enable", "memory", "moteus:20/0.8:4", "--seconds", "0.2"}) == done);
    CHECK(ends({"record", "memory", "--pretend", "odrive:3", "--seconds", "0.3"}) == done);
    CHECK(r.printed("#"));
    CHECK(r.seen.empty());  // nothing went to the other bus
    CHECK(ends({"pretend", "memory", "odrive:3"}) == misunderstood);
    CHECK(ends({"list", "can0", "--pretend", "odrive:3"}) == misunderstood);
    CHECK(r.printed("--pretend plays drives in memory only"));
  }
  TEST_CASE("--help, -h and --version") {
    rig r;
    const auto open = [&](const std::string&, bool) { return r.bus; };
    CHECK(run_and_tell({"-h"}, open, r, r.say) == done);
    CHECK(r.printed("cca-can: CAN buses and the drives on them, by hand"));
    CHECK(run_and_tell({"--version"}, open, r, r.say) == done);
    CHECK(r.printed("cca-can 0."));
    CHECK(run_and_tell({"jog", "--help"}, open, r, r.say) == done);
  }
}

TEST_SUITE("pretend") {
  TEST_CASE("drives are silent, faulty and loaded on demand") {
    rig r;
    std::vector<std::unique_ptr<any_virtual>> drives;
    drives.push_back(virtual_named("odrive:3"));
    std::size_t at_half = 0, at_one = 0, at_three_halves = 0;
    r.each = [&] {
      if (r.clock <= 500 * ms) at_half = r.seen.size();
      if (r.clock <= 1000 * ms) at_one = r.seen.size();
      if (r.clock <= 1500 * ms) at_three_halves = r.seen.size();
    };
    CHECK(pretend(r.far, drives,
                  {.seconds = 2,
                   .silent_at = 0.502,
                   .fault_at = 1.5,
                   .silent_for = 0.498,
                   .code = 0x4000,
                   .load = 0.25},
                  r) == done);
    CHECK(at_half > 4);
    CHECK(at_one <= at_half + 2);  // answers that were under way
    CHECK(at_three_halves > at_one + 4);
    CHECK(r.seen.size() > at_three_halves + 4);  // with a fault it goes on reporting
    const hw::can_frame heartbeat = r.last_of(hw::standard(3 << 5 | 0x01));
    CHECK((heartbeat.data[0] | heartbeat.data[1] << 8) == 0x4000);
    CHECK(drives[0]->load == 0.25);
  }
}

TEST_SUITE("interfaces") {
  TEST_CASE("what the kernel says about an interface") {
    std::vector<std::byte> message(sizeof(ifinfomsg));
    ifinfomsg head{};
    head.ifi_type = ARPHRD_CAN;
    head.ifi_flags = IFF_UP;
    std::memcpy(message.data(), &head, sizeof head);
    const auto attribute = [](int type, const void* data, std::size_t size) {
      rtattr a{static_cast<unsigned short>(RTA_LENGTH(size)), static_cast<unsigned short>(type)};
      std::vector<std::byte> bytes(RTA_SPACE(size));
      std::memcpy(bytes.data(), &a, sizeof a);
      std::memcpy(bytes.data() + RTA_LENGTH(0), data, size);
      return bytes;
    };
    const auto add = [](std::vector<std::byte>& to, const std::vector<std::byte>& what) {
      to.insert(to.end(), what.begin(), what.end());
    };
    can_bittiming timing{};
    timing.bitrate = 500000;
    const std::uint32_t state = 2;
    rtnl_link_stats64 counted{};
    counted.rx_packets = 12, counted.tx_packets = 34;
    std::vector<std::byte> controller, kind;
    add(controller, attribute(IFLA_CAN_BITTIMING, &timing, sizeof timing));
    add(controller, attribute(IFLA_CAN_STATE, &state, sizeof state));
    add(kind, attribute(IFLA_INFO_KIND, "can", 4));
    add(kind, attribute(IFLA_INFO_DATA, controller.data(), controller.size()));
    add(message, attribute(IFLA_IFNAME, "can3", 5));
    add(message, attribute(IFLA_STATS64, &counted, sizeof counted));
    add(message, attribute(IFLA_LINKINFO, kind.data(), kind.size()));
    bus_info b;
    REQUIRE(cca_can::detail::read_interface(message, b));
    CHECK(text_of(b) == "can3  passive  500000 bit/s  received 12, sent 34, errors 0, dropped 0");
    for (std::size_t n = 0; n < message.size(); ++n) {  // cut off anywhere: nothing is read past its end
      const std::vector<std::byte> part(message.begin(), message.begin() + static_cast<std::ptrdiff_t>(n));
      bus_info cut;
      cca_can::detail::read_interface(part, cut);
    }
    head.ifi_type = ARPHRD_ETHER;
    std::memcpy(message.data(), &head, sizeof head);
    CHECK_FALSE(cca_can::detail::read_interface(message, b));
  }
}

}  // namespace tool_test
