// The trot of the Oncilla as a measure: the same commands in different worlds.
//
//   physics_trot accuracy           how far trunk and joints are apart after a second: of both engines with steps of 1/64 ms,
//                                   of each engine from its own limit
//   physics_trot bits               a hash of the state after a second of trot: the same with every compiler
//   physics_trot run ENGINE BEATS   runs so many beats, for callgrind; ENGINE is compiled, ode or none
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/robot/world/robot_world.hpp>

#include "commands_of_trot.hpp"
#include "figures.hpp"

namespace bench {

namespace sim = cca::sim;

sim::scene floor_with(bool pyramid) {
  sim::scene s;
  s.floor = 0, s.contact.pyramid = pyramid;
  return s;
}
sim::robot_world_settings with_steps(int steps) {
  sim::robot_world_settings s;
  s.steps_per_beat = steps;
  return s;
}

struct ode {
  static sim::robot_world with(int steps, bool pyramid) {
    return sim::robot_world(sim::model_of<walking>(), floor_with(pyramid), with_steps(steps));
  }
};
struct compiled {
  static sim::compiled_world<walking> with(int steps, bool pyramid) {
    return sim::compiled_world<walking>(floor_with(pyramid), with_steps(steps));
  }
};

// Base and joints after the trot.
struct place {
  Eigen::Vector3d at;
  Eigen::Matrix3d turn;
  std::array<double, 16> q;
};
template <class Engine>
place after(const recorded_trot& t, int steps, bool pyramid = false) {
  auto w = Engine::with(steps, pyramid);
  put_down(w, t);
  for (const laws_of_oncilla& laws : t.beats) w.advance(laws);
  if (w.trouble()) std::fprintf(stderr, "%s\n", w.trouble_text().c_str()), std::exit(1);
  const auto base = w.frame(-1);
  place p{base.where.at, base.where.turn, {}};
  for (std::size_t c = 0; c < 16; ++c) p.q[c] = w.joints()[c].angle;
  return p;
}
struct distance {
  double trunk = 0, joint = 0;  // m, rad
};
distance between(const place& a, const place& b) {
  distance d{(a.at - b.at).norm(), 0};
  for (std::size_t c = 0; c < 16; ++c) d.joint = std::max(d.joint, std::abs(a.q[c] - b.q[c]));
  return d;
}
void show(const std::string& name, const distance& d) {
  figure((name + " trunk").c_str(), d.trunk);
  figure((name + " joint").c_str(), d.joint);
}

void accuracy() {
  const recorded_trot t = trot_of(1);
  const place fine = after<compiled>(t, 64), other = after<ode>(t, 64);
  show("cone and pyramid", between(fine, other));
  show("one friction law", between(after<compiled>(t, 64, true), other));
  show("compiled from its limit", between(after<compiled>(t, 2), fine));
  show("ode from its limit", between(after<ode>(t, 2), other));
}

// FNV-1a.
std::uint64_t hash_of(const void* from, std::size_t size) {
  std::uint64_t h = 14695981039346656037u;
  for (std::size_t k = 0; k < size; ++k)
    h = (h ^ static_cast<const unsigned char*>(from)[k]) * 1099511628211u;
  return h;
}
void bits() {
  const recorded_trot t = trot_of(1);
  auto w = compiled::with(2, false);
  put_down(w, t);
  for (const laws_of_oncilla& laws : t.beats) w.advance(laws);
  const auto& m = w.save().motion;
  std::printf("bits\t%016llx\n", static_cast<unsigned long long>(hash_of(&m, sizeof m)));
}

template <class Engine>
void run(const recorded_trot& t, std::size_t beats) {
  auto w = Engine::with(2, false);
  put_down(w, t);
  for (std::size_t k = 0; k < beats; ++k) w.advance(t.beats[k]);
  figure("height", w.frame(-1).where.at[2]);
}

}  // namespace bench

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "", engine = argc > 2 ? argv[2] : "";
  const auto beats = argc > 3 ? static_cast<std::size_t>(std::atoi(argv[3])) : 0;
  if (what == "accuracy") {
    bench::accuracy();
  } else if (what == "bits") {
    bench::bits();
  } else if (what == "run" && beats > 0 && beats <= 3000 &&
             (engine == "compiled" || engine == "ode" || engine == "none")) {
    const auto t = bench::trot_of(3);
    if (engine == "compiled") bench::run<bench::compiled>(t, beats);
    if (engine == "ode") bench::run<bench::ode>(t, beats);
  } else {
    std::fprintf(stderr, "usage: physics_trot accuracy | bits | run compiled|ode|none BEATS (up to 3000)\n");
    return 2;
  }
}
