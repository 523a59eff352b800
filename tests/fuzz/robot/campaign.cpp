// A random campaign for the whole robot: random frames, faults of drives, board and buses (frames lost, late
// or twice, refused by the send queue, bus off, link down), beats that don't happen, commands, parameters,
// stops and starts from any pose; one robot on Damiao drives, one with all families. Each frame that the
// controller sends is judged (judge.hpp).
//
//   cca_fuzz_robot --seconds 60 --seed 1
//
// It prints how many beats and frames it judged, and ends with 1 at the first frame that should not have been
// sent, with the seed of the life in which it was.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <cca/main/command_line.hpp>
#include <cca/main/run_program.hpp>

#include "../../../examples/hardware_in_the_loop/robot.hpp"
#include "../../laws/families_oncilla.hpp"
#include "../../laws/robot_lab.hpp"
#include "judge.hpp"

namespace {

namespace hw = cca::hardware;
namespace oncilla = cca::robots::oncilla;

// Whatever a controller may want: any number, and a fault.
struct whim {
  auto process() -> std::tuple<cca::out<"angles", oncilla::leg_angles>,
                               cca::out<"abduction", oncilla::abduction_angles>,
                               cca::fault> {
    return {angles, abduction, broken ? cca::fault("a whim") : cca::fault()};
  }
  oncilla::leg_angles::vector_type angles = oncilla::leg_angles::vector_type::Zero();
  oncilla::abduction_angles::vector_type abduction = oncilla::abduction_angles::vector_type::Zero();
  bool broken = false;
};

// No limiter before the robot: its own guards are judged.
template <class Robot>
struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"whim", whim>,
                                 cca::node<"limits", cca::unlimited<oncilla::leg_angles>>,
                                 cca::node<"spread", cca::unlimited<oncilla::abduction_angles>>,
                                 cca::node<"robot", Robot>,
                                 cca::wire<"whim.angles", "limits.command">,
                                 cca::wire<"whim.abduction", "spread.command">,
                                 cca::wire<"limits.safe", "robot.command">,
                                 cca::wire<"spread.safe", "robot.abduction">> {};

using damiao = hil::oncilla<laws::lab_end>;
using all_families = families::robot<laws::lab_end>;
struct on_damiao : architecture<damiao> {};
struct on_all_families : architecture<all_families> {};
using damiao_lab = laws::robot_lab<damiao, on_damiao, hil::virtual_damiao>;
using families_lab = laws::robot_lab<all_families, on_all_families>;

// The ids of the frames from and to these drives, and to and from the board.
template <class Board, class... J>
std::vector<hw::can_filter> ids_of(hw::joint_list<J...>) {
  std::vector<hw::can_filter> all;
  const auto add = [&](const auto& some) { all.insert(all.end(), some.begin(), some.end()); };
  (add(J::drive::requests), ...), (add(J::drive::replies), ...);
  add(Board::requests), add(Board::replies);
  return all;
}

struct totals {
  std::uint64_t lives = 0, beats = 0, frames = 0, motions = 0, from_outside = 0, bus_faults = 0, refused = 0;
};

template <class Lab>
class life {
public:
  explicit life(std::uint64_t seed) : random(seed) {}

  // The first frame that should not have been sent; empty: none.
  std::string live(totals& sum) {
    pose();
    lab.controller.load();
    lab.controller.start(), latch();
    for (int k = 0; k < 3000 && judged.verdict.empty(); ++k) {
      happen();
      const bool runs = stalled == 0;
      if (!runs) --stalled;
      const bool stepped = runs && lab.controller.state() == cca::state::started;
      const auto before = lab.synchronizer().phase();
      for (auto& frames : lab.sent) frames.clear();
      if (runs) lab.controller.step();
      const auto after = lab.synchronizer().phase();
      const bool moves = stepped && before >= hw::motion_phase::enabling && after >= hw::motion_phase::begins;
      const bool closed = pressed || !stepped || after == hw::motion_phase::stopped;
      if (runs)
        judged.begin_beat(closed, moves, after == hw::motion_phase::enabling, lab.stop().mode(),
                          lab.controller.template get<"robot.rate">().p.approach);
      sum.motions += moves && lab.stop().mode() == hw::motion_mode::run;
      for (std::size_t b = 0; b < Lab::buses; ++b)
        for (const hw::can_frame& f : lab.sent[b]) judged.look(b, f, lab.synchronizer(), latched);
      lab.rest_of_beat();
      ++sum.beats;
    }
    sum.frames += judged.frames;
    sum.from_outside += judged.motions_from_outside;
    sum.bus_faults += bus_faults;
    for (const auto& of_bus : lab.refused) sum.refused += of_bus.frames;
    ++sum.lives;
    return judged.verdict;
  }

private:
  using joints = typename Lab::joints;

  double any(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); }
  bool chance(double of_one) { return any(0, 1) < of_one; }
  std::size_t below(std::size_t n) { return random() % n; }
  double wild() {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double all[] = {std::nan(""), inf, -inf, 1e300, -1e9, any(-10, 10)};
    return chance(0.1) ? all[below(6)] : any(-2, 3);
  }

  void pose() {
    for (std::size_t i = 0; i < Lab::count; ++i) {
      const double beyond = chance(0.1) ? (chance(0.2) ? 0.6 : 0.3) : 0;  // 0.5 is tolerated
      lab.plant.put(i, any(joints::angle[i].lower - beyond, joints::angle[i].upper + beyond));
    }
    for (double& a : lab.plant.abducted) a = any(-0.3, 0.3);
  }

  template <class F>
  void of_one_drive(F f) {
    lab.of_drive(below(Lab::count), f);
  }
  void mend() {
    std::apply([](auto&... drive) { (drive.clear(), ...); }, lab.far.drives);
    lab.far.board_silent = false;
    for (auto& of_bus : lab.refused) of_bus.now = false;
    for (auto& of_bus : lab.troubles) of_bus.fill(Lab::no_trouble);
    lab.controller.template get<"whim">().broken = false;
    lab.speed_scale.fill(1);
  }
  void latch() {
    for (std::size_t i = 0; i < Lab::count; ++i) latched[i] = lab.synchronizer().p.offset[i];
  }

  void happen() {
    auto& c = lab.controller;
    auto& wanted = c.template get<"whim">();
    if (chance(0.01)) wanted.angles[static_cast<Eigen::Index>(below(8))] = wild();
    if (chance(0.01)) wanted.abduction[static_cast<Eigen::Index>(below(4))] = wild() / 5;
    if (chance(0.004)) disturb();
    if (chance(0.002)) trouble_a_bus();
    if (chance(0.0005)) lab.refused[below(Lab::buses)].now = true, ++bus_faults;
    if (chance(0.1)) lab.refused[below(Lab::buses)].now = false;
    if (chance(0.001)) of_one_drive([&](auto& d) { d.go_silent(true); });
    if (chance(0.0007)) of_one_drive([&](auto& d) { d.fail(static_cast<std::uint32_t>(1 + below(48))); });
    if (chance(0.0005)) of_one_drive([&](auto& d) { d.reboot(lab.now, 20'000'000); });
    if (chance(0.0005)) lab.far.board_silent = true;
    if (chance(0.0005)) lab.speed_scale[below(8)] = any(-2, 3);
    if (chance(0.001)) stalled = 1 + static_cast<int>(below(10));
    if (chance(0.0005)) wanted.broken = true;
    if (chance(0.001)) lab.stop().press(), pressed = true;
    if (chance(0.02)) lab.stop().release(), pressed = false;
    if (chance(0.0005)) lab.stop().stop_softly();
    if (chance(0.02)) mend();
    if (chance(0.003)) set_parameters();
    if (chance(0.01)) live_on();
  }
  // Stop, start, resume: what the life-cycle allows now.
  void live_on() {
    auto& c = lab.controller;
    switch (c.state()) {
      case cca::state::loaded:
        return c.start(), latch();
      case cca::state::faulted:
        return chance(0.5) ? c.resume() : c.stop();
      default:
        if (chance(0.1)) return c.stop();
        if (lab.stop().mode() != hw::motion_mode::run || chance(0.05)) lab.synchronizer().start(), latch();
    }
  }
  void set_parameters() {
    auto& c = lab.controller;
    auto rate = c.template get<"robot.rate">().p;
    rate.approach = any(0.01, 100);
    c.template set<"robot.rate">(rate);
    auto offsets = lab.synchronizer().p;
    offsets.offset[below(8)] = any(-0.3, 0.3);
    try {
      c.template set<"robot.synchronizer">(offsets);
    } catch (const cca::refused&) {  // it moves
    }
  }
  // For 1 to 40 ms: frames are lost, late or come twice; or an end is passive, off or without a link.
  void trouble_a_bus() {
    using enum hw::bus_trouble;
    constexpr hw::bus_trouble all[] = {lose, lose, delay, duplicate, passive, bus_off, link_down};
    const std::size_t ends[] = {0, 1, hw::every_end};
    lab.troubles[below(Lab::buses)][below(3)] = {
        .what = all[below(7)],
        .from = lab.now,
        .until = lab.now + 1'000'000 * static_cast<std::int64_t>(1 + below(40)),
        .end = ends[below(3)],
        .chance = any(0.05, 1),
        .delay = static_cast<std::int64_t>(below(5'000'000))};
    ++bus_faults;
  }
  // A frame of another node: an id that is in use, or any; any bytes.
  void disturb() {
    static const auto ids = ids_of<typename Lab::board>(joints());
    hw::can_frame f;
    const hw::can_filter own = chance(0.1) ? hw::can_filter{{0, chance(0.5)}, 0} : ids[below(ids.size())];
    const std::uint32_t free = ~own.mask & (own.id.extended ? 0x1FFFFFFF : 0x7FF);
    f.id = {own.id.number | (static_cast<std::uint32_t>(random()) & free), own.id.extended};
    f.length = static_cast<std::uint8_t>(below(9));
    for (std::size_t i = 0; i < f.length; ++i) f.data[i] = static_cast<std::uint8_t>(random());
    for (std::size_t n = 1 + below(4); n > 0; --n) lab.wires[below(Lab::buses)].end(2).send({&f, 1});
  }

  std::mt19937_64 random;
  Lab lab{};
  fuzz::judge<joints, typename Lab::board> judged{};
  std::array<double, 8> latched{};
  int stalled = 0;
  std::uint64_t bus_faults = 0;
  bool pressed = false;
};

int judge_lives(std::uint64_t seconds, std::uint64_t seed) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  totals all;
  do {
    const auto tell = [&](const char* robot, const std::string& verdict) {
      std::printf("%s, --seed %llu: %s\n", robot, static_cast<unsigned long long>(seed), verdict.c_str());
      return 1;
    };
    if (const auto bad = life<damiao_lab>(seed).live(all); !bad.empty()) return tell("Damiao", bad);
    if (const auto bad = life<families_lab>(seed).live(all); !bad.empty()) return tell("all families", bad);
    ++seed;
  } while (std::chrono::steady_clock::now() < end);
  using number = unsigned long long;
  std::printf("%llu lives, %llu beats (%llu of them in motion), %llu frames judged: all were allowed\n",
              static_cast<number>(all.lives), static_cast<number>(all.beats),
              static_cast<number>(all.motions), static_cast<number>(all.frames));
  std::printf(
      "%llu motions of a joint from outside of its range, %llu faults of a bus, %llu frames refused\n",
      static_cast<number>(all.from_outside), static_cast<number>(all.bus_faults),
      static_cast<number>(all.refused));
  // A campaign in which nothing moves, or no bus fails, judges nothing.
  return all.motions > 0 && all.from_outside > 0 && all.bus_faults > 0 && all.refused > 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  std::uint64_t seconds = 60, seed = 1;
  cca::command_line line("random lives of whole robots; each frame that they send is judged");
  line.whole_number("--seconds S", seconds, 1, 86400, "how long (60)");
  line.whole_number("--seed N", seed, 0, "of the first life (1)");
  return cca::run_program(count, words, line, [&] { return judge_lives(seconds, seed); });
}
