// Learning a batch never disturbs the loop: while a thread is in the middle of it, each beat does the same
// work as before and after, bit for bit. Work is counted, not timed: each call of a function of the model
// counts, and so does each allocation.
#include <atomic>
#include <future>
#include <vector>

#include <cca/adaptive/module/adaptive_module.hpp>
#include <cca/adaptive/recursive_least_squares.hpp>

#include "rig.hpp"

namespace laws {
std::size_t allocations_of_this_thread();
}

using namespace adaptive_test;

namespace {

// Calls in the model, by this thread.
thread_local int calls = 0;
// The batch of another thread stops here, in its middle, until the loop has run.
std::atomic<bool> in_the_middle = false, may_go_on = true;
thread_local bool is_batch = false;

// y = W (1, x, x^2)
struct curve {
  using input = Eigen::Matrix<double, 1, 1>;
  using output = Eigen::Vector2d;
  using weight_matrix = Eigen::Matrix<double, 2, 3>;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (weight_matrix, weights));
    parameters() : weights(weight_matrix::Zero()) {}
  };
  static Eigen::Vector3d regressors(const input& x) {
    ++calls;
    if (is_batch) {
      in_the_middle = true;
      while (!may_go_on) {}
    }
    return {1, x[0], x[0] * x[0]};
  }
  static output answer(const parameters& p, const input& x) { return p.weights * regressors(x); }
  static std::string title() { return "curve"; }
};

// [motion]
// A motion of one's own: the command follows the learned curve over an input, on springs.
class follow_curve {
public:
  using model = curve;
  using default_learner = cca::recursive_least_squares<curve>;
  using demonstrated = leg;
  using inputs =
      cca::module_inputs<cca::in<"input", cca::over<cca::number, stride>>, cca::in<"reference", leg>>;
  using outputs = cca::module_outputs<cca::out<"command", leg>>;

  template <class Settings>
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 1>, gain),
                             (Settings, settings),
                             (cca::learned_files, files));
    parameters(double follows = 0.1, const Settings& of_learner = {}, const cca::learned_files& names = {})
        : gain(follows), settings(of_learner), files(names) {}
  };
  static std::vector<cca::learned_header::constant> constants(const auto&) { return {}; }

  auto step(const auto& give,
            const auto& p,
            const curve::parameters& function,
            const auto& teach,
            const cca::in<"input", cca::over<cca::number, stride>>& input,
            const cca::in<"reference", leg>& reference,
            const cca::optional_in<"demonstration", leg>& shown,
            cca::beat) {
    const curve::input x(input.vector());
    if (shown && shown.fresh()) teach(x, shown.vector() - reference.vector());
    const Eigen::Vector2d wanted = reference.vector() + curve::answer(function, x);
    at += p.gain * (wanted - at);
    return give(cca::status_of(cca::ode_status::transient), x, at);
  }
  void start() { at.setZero(); }

private:
  Eigen::Vector2d at{0, 0};
};
struct my_module : cca::adaptive_module<follow_curve> {};
// [motion end]

struct source {
  auto process(cca::beat now) -> std::
      tuple<cca::out<"x", cca::over<cca::number, stride>>, cca::out<"centre", leg>, cca::out<"shown", leg>> {
    const double x = std::sin(1e-8 * static_cast<double>(now.time()));
    return {x, Eigen::Vector2d(0.1, -0.2), Eigen::Vector2d(0.1 + x, -0.2 + x * x)};
  }
};
struct alone : cca::graph<cca::rate<1000>,
                          cca::node<"in", source>,
                          cca::node<"module", my_module, cca::timed<1>>,
                          cca::wire<"in.x", "module.input">,
                          cca::wire<"in.centre", "module.reference">,
                          cca::wire<"in.shown", "module.demonstration">,
                          cca::observe<"module.*">> {};

struct work {
  int calls;
  std::size_t allocations;
  bool operator==(const work&) const = default;
};
work of_beat(cca::controller<alone>& c) {
  const int before = calls;
  const std::size_t allocated = laws::allocations_of_this_thread();
  c.step();
  return {calls - before, laws::allocations_of_this_thread() - allocated};
}
Eigen::Vector2d command(cca::controller<alone>& c) {
  Eigen::Vector2d found{9, 9};
  c.observed([&](const cca::observation& one) {
    if (one.path == "module.command") found = {one.values[0], one.values[1]};
  });
  return found;
}

}  // namespace

TEST_CASE("each beat does the same work while a batch is learned: calls of the model, allocations, results") {
  cca::controller<alone> c;
  auto& module = c.get<"module">();
  c.load();
  c.start();
  c.run(cca::for_beats<10>{});
  module.learning.collect();
  c.run(cca::for_beats<500>{});
  module.learning.hand_over(module.learning.begin_batch(module.p.settings)());
  const work resting = of_beat(c);
  CHECK(resting.calls == 2);  // the answer, and the trained region
  CHECK(resting.allocations == 0);
  auto undisturbed = c;  // never learns again

  may_go_on = false;
  auto result = std::async(std::launch::async, [batch = module.learning.begin_batch(module.p.settings)] {
    is_batch = true;
    return batch();
  });
  while (!in_the_middle) {}
  for (int k = 0; k < 1000; ++k) {  // all of them within the batch
    const work now = of_beat(c);
    CHECK(now == resting);
    undisturbed.step();
    CHECK(command(c) == command(undisturbed));
  }
  CHECK(module.learning.state() == cca::learning::batch);
  may_go_on = true;
  module.learning.hand_over(result.get());
  CHECK(of_beat(c) == resting);
}

TEST_CASE("collecting and online examples add a fixed amount of work to each beat") {
  cca::controller<alone> c;
  auto& module = c.get<"module">();
  c.load();
  c.start();
  module.learning.collect();
  (void)of_beat(c);
  for (int k = 0; k < 3000; ++k) CHECK(of_beat(c) == work{1, 0});  // untrained: no region to ask
  module.learning.rest();
  module.learning.learn();
  (void)of_beat(c);
  for (int k = 0; k < 3000; ++k) CHECK(of_beat(c) == work{3, 0});
}

TEST_CASE("a motion of one's own learns its curve") {
  cca::controller<alone> c;
  auto& module = c.get<"module">();
  c.load();
  c.start();
  module.learning.collect();
  c.run(cca::for_beats<1500>{});
  module.learning.hand_over(module.learning.begin_batch(module.p.settings)());
  CHECK((module.learning.get().function.weights -
         (Eigen::Matrix<double, 2, 3>() << 0, 1, 0, 0, 0, 1).finished())
            .norm() < 1e-4);
}
