// The beat of adaptive modules while a batch is learned on another thread, and while nothing is learned.
//
//   learning list                        the names of the modules
//   learning NAME resting|batch BEATS    runs one of them (under callgrind, which counts only in one_beat)
//
// Both have learned once. `resting`: they run with that. `batch`: another batch has begun, and a thread
// learns it again and again, and the loop runs with what was learned before. Demonstrations come in both.
#include <atomic>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string_view>
#include <thread>
#include <type_traits>

#include <cca/cca.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/modules/dmp_discrete_module.hpp>
#include <cca/motor/modules/dmp_pose_module.hpp>
#include <cca/motor/modules/gmr_module.hpp>
#include <cca/motor/modules/rcpg_module.hpp>

#include "words.hpp"

namespace bench {

struct stride : cca::dimension<"stride"> {};
struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct trunk : cca::frame<"trunk"> {};
struct hand : cca::frame<"hand"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct place : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
struct lesson : cca::space<cca::number, cca::axes<cca::x>> {};

struct source {
  auto process(cca::beat now) -> std::tuple<cca::out<"phase", cca::over<cca::phase, stride>>,
                                            cca::out<"one", cca::over<cca::amplitude, stride>>,
                                            cca::out<"time", lesson>,
                                            cca::out<"centre", leg>,
                                            cca::out<"angles", leg>,
                                            cca::out<"goal", place>,
                                            cca::out<"pose", place>> {
    const double t = std::fmod(1e-9 * static_cast<double>(now.time()), 1.0), f = 2 * cca::pi * t;
    place::vector_type goal, pose;
    goal << 0.5, 0, 0.2, 0, 0, std::sin(0.5), std::cos(0.5);
    pose << 0.5 * t, 0.1 * std::sin(f), 0.2 * t, 0, 0, std::sin(0.5 * t), std::cos(0.5 * t);
    const Eigen::Vector2d centre(0.1, -0.8), angles(0.1 + 0.3 * std::sin(f), std::cos(f) - 0.8);
    return {f, 1.0, t, centre, angles, goal, pose};
  }
};

template <class Module, class... Wires>
struct alone : cca::graph<cca::rate<1000>,
                          cca::node<"in", source>,
                          cca::node<"module", Module, cca::timed<1>>,
                          Wires...,
                          cca::observe<"module.*">> {};

template <cca::fixed_string From, cca::fixed_string To>
using from = cca::wire<From, To>;

struct rhythmic : alone<cca::dmp_rhythmic_module<leg, stride, 25>,
                        from<"in.phase", "module.phase">,
                        from<"in.one", "module.amplitude">,
                        from<"in.centre", "module.reference">,
                        from<"in.angles", "module.demonstration">> {
  static constexpr const char* name = "rhythmic primitive";
};
struct discrete : alone<cca::dmp_discrete_module<leg, 20>,
                        from<"in.centre", "module.reference">,
                        from<"in.angles", "module.demonstration">> {
  static constexpr const char* name = "discrete primitive";
};
struct pose : alone<cca::dmp_pose_module<place, hand, 20>,
                    from<"in.goal", "module.reference">,
                    from<"in.pose", "module.demonstration">> {
  static constexpr const char* name = "primitive of a pose";
};
struct regression : alone<cca::gmr_module<lesson, leg, 12>,
                          from<"in.time", "module.input">,
                          from<"in.centre", "module.reference">,
                          from<"in.angles", "module.demonstration">> {
  static constexpr const char* name = "mixture regression";
};
struct reservoir : alone<cca::rcpg_module<leg, 100>,
                         from<"in.centre", "module.reference">,
                         from<"in.angles", "module.demonstration">> {
  static constexpr const char* name = "reservoir";
};

template <class Graph>
[[gnu::noinline]] void one_beat(cca::controller<Graph>& c) {
  c.step();
}

template <class Graph>
void run(bool batch, int beats) {
  const auto c = std::make_unique<cca::controller<Graph>>();
  c->load();
  c->start();
  auto& module = c->template get<"module">();
  module.learning.collect();
  for (int k = 0; k < 300; ++k) c->step();  // few: one batch of the mixture takes long under callgrind
  module.learning.hand_over(module.learning.begin_batch(module.p.settings)());
  std::atomic<bool> done = false;
  std::atomic<bool> learning = false;
  std::thread learner;
  if (batch) {
    learner = std::thread([&, work = module.learning.begin_batch(module.p.settings)] {
      learning = true;
      while (!done) (void)work();
    });
    while (!learning) std::this_thread::yield();
  }
  for (int k = 0; k < beats; ++k) one_beat(*c);
  done = true;
  if (batch) learner.join();
  if (module.learning.state() != (batch ? cca::learning::batch : cca::learning::trained)) std::abort();
}

template <class... Graphs>
int program(int argc, char** argv) {
  const std::string_view name = argc > 1 ? argv[1] : "";
  if (name == "list" && argc == 2) {
    (std::puts(Graphs::name), ...);
    return 0;
  }
  const std::string_view state = argc > 2 ? argv[2] : "";
  if (argc != 4 || (state != "resting" && state != "batch"))
    refuse(name, "list, or a module, resting or batch, and a number of beats");
  const int beats = beats_in(argv[3]);
  const bool found = ((name == Graphs::name ? (run<Graphs>(state == "batch", beats), true) : false) || ...);
  if (!found) refuse(name, "the name of a module: see `list`");
  return 0;
}

}  // namespace bench

int main(int argc, char** argv) {
  return bench::program<bench::rhythmic, bench::discrete, bench::pose, bench::regression, bench::reservoir>(
      argc, argv);
}
