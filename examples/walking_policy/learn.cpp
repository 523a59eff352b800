// Trains the walking policy in the simulator, on all cores, and writes its weights.
//
//   walking_policy_learn --out walk.policy
//   mpirun -n 4 walking_policy_learn --out walk.policy    (docs/cluster.md)
//
// 1. It imitates the trot of examples/trot. The trot drives, and the network learns what it would do. Then
//    the policy drives, and the network also learns what the trot would do where the policy has led the robot
//    (Ross, Gordon, Bagnell, A reduction of imitation learning and structured prediction to no-regret online
//    learning, AISTATS 2011: DAgger).
// 2. It changes the weights of the last layer by an evolution strategy (evolution.hpp), so that the robot
//    keeps the commanded speed and turn with less slip and work. The other layers stay: what they compute
//    from the observations is used, and so the search has 264 numbers instead of 1,992.
//
// Each run has a command, a disturbance, a robot and a ground of its own (trial.hpp).
// The same seed gives the same bits on any number of cores and ranks.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../trot/report/all_cores.hpp"
#include "../trot/report/engine.hpp"
#include "../trot/report/progress.hpp"
#include "../trot/report/statistics.hpp"
#include "../trot/own_run.hpp"
#include "evolution.hpp"
#include "imitation.hpp"
#include "trial.hpp"
#include "worth.hpp"

namespace {

// A pupil in a world, and its school.
template <class World>
struct school : walking::school<walking::uncertain_oncilla<World>> {};
template <class World>
struct walk : walking::architecture<walking::uncertain_oncilla<World>> {};

using parameters = walking::policy::network::parameters;
constexpr int review_every = 10;  // generations

struct options {
  std::string out = "walk.policy", imitated, from;
  std::uint64_t seed = 1;
  int rounds = 4, runs = 32, passes = 20, generations = 400, directions = 32, reviews = 48, both = 0;
  double seconds = 6, noise = 0.025, step = 0.01;
  bool quick = false, quiet = false;
  trot::engine engine = trot::engine::compiled;

  void offer(cca::command_line& line) {
    line.text("--out FILE", out, "the weights (walk.policy)");
    line.text("--imitated FILE", imitated, "the weights before the evolution");
    line.text("--from FILE", from, "weights with which the evolution begins; without imitation");
    line.whole_number("--seed N", seed, 1, "of the training (1)");
    line.number("--rounds N", rounds, 1, 100, "of imitation; in the first the trot drives (4)");
    line.number("--runs N", runs, 1, 1000, "of a round (32)");
    line.number("--passes N", passes, 1, 10000, "over all lessons, in a round (20)");
    line.number("--generations N", generations, 0, 1e4, "of the evolution (400)");
    line.number("--directions N", directions, 2, 1000, "of a generation, two runs each (32)");
    line.number("--noise X", noise, 1e-6, 1, "of the evolution: how far it looks, in each weight (0.025)");
    line.number("--step X", step, 1e-6, 1, "of the evolution: how far it goes (0.01)");
    line.number("--seconds S", seconds, 3, 100, "of a run, simulated (6)");
    line.whole_number("--both N", both, 0, 1000,
                      "each how many-th direction is in the other engine; 0: none (0)");
    line.flag("--quick", quick, "a few short runs, to try the program");
    line.flag("--quiet", quiet, "no progress bar");
    trot::offer_engine(line, engine);
    cca::offer_descriptions<cca::controller<school<cca::sim::compiled_oncilla_world>>>(line);
  }
  void shorten() {
    rounds = 2, runs = 2, passes = 2, generations = 2, directions = 2, reviews = 2, both = 2, seconds = 3;
  }
};

// What a run of the imitation gives.
struct attended {
  BOOST_HANA_DEFINE_STRUCT(attended, (std::vector<walking::lesson>, lessons), (bool, fell));
};

template <class World, class Other>
class training {
public:
  training(const options& o, trot::all_cores& cores)
      : o_(o), cores_(cores), bar_("learn", shows()), start_(std::chrono::steady_clock::now()) {
    for (int i = 0; i < o.reviews; ++i) review_.push_back(next());
  }

  int run() {
    if (o_.from.empty()) {
      imitate();
      if (ends_early_) return ended();
      if (!o_.imitated.empty()) save(o_.imitated, weights_);
    } else {
      walking::policy learned;
      learned.read(o_.from);
      weights_ = learned.weights;
    }
    const int generations = evolve();
    bar_.done();
    save(o_.out, weights_);
    if (!cores_.is_first()) return interrupted_.exit_code();
    std::printf("seed %llu, %d generations; %zu runs of up to %.0f s; %.0f s, %u cores here, ranks %d\n",
                static_cast<unsigned long long>(o_.seed), generations, runs_, o_.seconds, seconds(),
                std::thread::hardware_concurrency(), cores_.count());
    std::printf("written to %s\n", o_.out.c_str());
    if (!ends_early_) return 0;
    std::cerr << "walking_policy_learn: interrupted; these are the weights of --generations " << generations
              << '\n';
    return interrupted_.exit_code();
  }

private:
  walking::trial next() { return walking::drawn_trial(walking::first_of_training * o_.seed + trials_++); }
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  int ended() {
    bar_.done();
    if (cores_.is_first()) std::cerr << "walking_policy_learn: interrupted; nothing is written\n";
    return interrupted_.exit_code();
  }
  bool shows() const { return !o_.quiet && cores_.is_first(); }
  void save(const std::string& file, const parameters& weights) const {
    if (!cores_.is_first()) return;
    walking::policy learned;
    learned.weights = weights;
    learned.save(file);
  }

  void imitate() {
    std::vector<walking::lesson> lessons = attend(true), fresh;
    walking::imitation fit(weights_, lessons, o_.seed);
    for (int round = 1; !ends_early_; ++round) {
      fit.learn(lessons, o_.passes);
      say("imitation %d: %zu lessons, error %.4f rad, falls %zu", round, lessons.size(), fit.error(lessons),
          falls_);
      if (round == o_.rounds) break;
      fresh = attend(false);
      lessons.insert(lessons.end(), fresh.begin(), fresh.end());
    }
  }

  // Runs of the teacher or of the policy, each with a disturbance of its own; the lessons in the order of the
  // runs.
  std::vector<walking::lesson> attend(bool by_teacher) {
    using school_here = cca::controller<school<World>>;
    school_here start;
    start.template get<"gait.policy">().weights = weights_;
    if (by_teacher) start.template get<"gait.policy">().weights.weights[0] = 1;  // it does not drive
    start.template get<"driver">().by_teacher = by_teacher;
    start.load();
    std::vector<walking::trial> trials;
    for (int i = 0; i < o_.runs; ++i) trials.push_back(next());
    const std::vector<attended> runs = rollouts(trials.size(), "imitation", [&](std::size_t i) {
      const auto begin = [this, t = trials[i]](school_here& c) {
        c.template get<"notebook">().lessons.reserve(trot::beats_in<school_here>(o_.seconds) /
                                                     walking::period);
        return walking::attempt(c, t, o_.seconds, [this] { return !interrupted_; });
      };
      return trot::run_of(start, begin, [](const trot::recording& run, const school_here& c) {
        attended kept;
        kept.lessons = c.template get<"notebook">().lessons;
        kept.fell = run.fell;
        return kept;
      });
    });
    std::vector<walking::lesson> all;
    falls_ = 0;
    for (const attended& run : runs) {
      all.insert(all.end(), run.lessons.begin(), run.lessons.end());
      falls_ += run.fell;
    }
    return all;
  }

  // Returns after how many generations it was reviewed last. Only means that a review has found better count.
  int evolve() {
    walking::evolution_strategy search(
        Eigen::Map<Eigen::VectorXd>(weights_.weights.data() + walking::last_layer.at,
                                    walking::last_layer.size()),
        {.directions = o_.directions, .noise = o_.noise, .length = o_.step}, o_.seed);
    double best = review(search.mean());
    parameters kept = weights_;
    int reviewed = 0;
    say("imitated: worth %.4f", best);
    for (int generation = 1; generation <= o_.generations && !ends_early_; ++generation) {
      const auto points = search.ask();
      std::vector<walking::trial> trials;  // one for each direction
      for (int i = 0; i < o_.directions; ++i) trials.push_back(next());
      std::vector<attempt> attempts;
      for (std::size_t i = 0; i < points.size(); ++i) attempts.push_back({points[i], trials[i / 2], i / 2});
      const std::vector<double> values = worths(attempts, "evolution");
      if (ends_early_) break;
      search.tell(values);
      if (generation % review_every != 0 && generation != o_.generations) continue;
      const double now = review(search.mean());
      if (ends_early_) break;
      reviewed = generation;
      say("generation %d: worth %.4f", generation, now);
      if (now <= best) continue;
      best = now, kept = with(search.mean());
      save(o_.out, kept);
    }
    weights_ = kept;
    return reviewed;
  }

  parameters with(const Eigen::VectorXd& last) const {
    parameters all = weights_;
    std::copy(last.begin(), last.end(), all.weights.begin() + walking::last_layer.at);
    return all;
  }

  struct attempt {
    const Eigen::VectorXd& last;
    const walking::trial& trial;
    std::size_t number;
  };
  bool is_in_other(const attempt& a) const {
    return o_.both > 0 && a.number % static_cast<std::size_t>(o_.both) == 0;
  }
  // None, if they end early.
  std::vector<double> worths(const std::vector<attempt>& all, const char* what) {
    std::vector<double> values(all.size());
    worths<World>(all, false, what, values);
    if (o_.both > 0 && !ends_early_) worths<Other>(all, true, what, values);
    return ends_early_ ? std::vector<double>() : values;
  }
  // Of those in this engine.
  template <class In>
  void worths(const std::vector<attempt>& all, bool other, const char* what, std::vector<double>& to) {
    using walk_here = cca::controller<walk<In>>;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (is_in_other(all[i]) == other) which.push_back(i);
    const walk_here start;
    const std::vector<double> values = rollouts(which.size(), what, [&](std::size_t i) {
      const attempt& a = all[which[i]];
      const auto begin = [this, &a](walk_here& c) {
        c.template get<"gait.policy">().weights = with(a.last);
        c.load();
        return walking::attempt(c, a.trial, o_.seconds, [this] { return !interrupted_; });
      };
      return trot::run_of(start, begin, [this, &a](const trot::recording& run, const walk_here&) {
        return walking::worth(walking::along_its_way(run), a.trial.wanted, o_.seconds);
      });
    });
    for (std::size_t i = 0; i < values.size(); ++i) to[which[i]] = values[i];
  }

  // The same trials each time, so that their means can be compared.
  double review(const Eigen::VectorXd& last) {
    std::vector<attempt> attempts;
    for (std::size_t i = 0; i < review_.size(); ++i) attempts.push_back({last, review_[i], i});
    const std::vector<double> values = worths(attempts, "review");
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }

  template <class Run>
  auto rollouts(std::size_t count, const char* what, Run run) {
    const auto show = [&, what](std::size_t over) {
      bar_.show(0.999 * static_cast<double>(over) / static_cast<double>(count), what);
    };
    const auto over =
        cores_.rollouts(count, run, {.over = show, .stops = [&] { return bool(interrupted_); }});
    runs_ += over.size();
    ends_early_ = over.size() < count;  // ctrl-c, here or on another rank
    return over;
  }

  template <class... Values>
  void say(const char* format, Values... values) {
    if (!shows() || ends_early_) return;
    bar_.done();
    std::printf(format, values...);
    std::printf("; %.0f s\n", seconds());
    std::fflush(stdout);
  }

  const options& o_;
  trot::all_cores& cores_;
  const cca::interruption interrupted_{};  // ctrl-c: the evolution keeps what it has; an imitation is lost
  std::uint64_t trials_ = 0;
  std::vector<walking::trial> review_;
  parameters weights_;
  std::size_t runs_ = 0, falls_ = 0;
  bool ends_early_ = false;
  trot::progress_bar bar_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace

int main(int count, char** words) {
  trot::all_cores cores(count, words);
  options o;
  cca::command_line line("trains a walking policy in the simulator, on all cores");
  o.offer(line);
  return cca::run_program(count, words, line, [&] {
    if (o.quick) o.shorten();
    using ode = cca::sim::world;
    using compiled = trot::beside<cca::sim::compiled_oncilla_world>;
    return o.engine == trot::engine::compiled ? training<compiled, ode>(o, cores).run()
                                              : training<ode, compiled>(o, cores).run();
  });
}
