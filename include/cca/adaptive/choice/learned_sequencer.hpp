// A Sequencer that learns which skill comes next, from the judgement of a criterion (the source document,
// chapter 3: an adaptive module and a criterion that generate a sequence).
//
//   struct plan : cca::steps<
//       cca::step<"decide", cca::then_one_of<"trot", "pace">>,
//       cca::step<"trot",   cca::after<100>, cca::then<"arrived">>, ...
//   cca::node<"sequencer", cca::learned_sequencer<"*.status.*", plan>, cca::timed<10>>
//   cca::wire<"judge.state", "sequencer.criterion", cca::delayed<1>>         a cca::Criterion
//
//   observes the scope    as a sequencer (sequencer.hpp); delayed by one beat
//   in  "criterion"   criterion_port         how good the running step is
//   in  "error"       criterion_error        optional: how far from good, in the unit of the criterion
//   in  "learn"       learning_request       optional: a request of another component
//   out "step"        step_port              the number of the running step, `plan::at<"trot">`
//   out "running"     step_time              s since the step began
//   out "timed_out"   step_flag              1 if the step began by a timeout
//   out "status"      component_status_port  reached in the last step, converging before
//   out "module"      module_status_port     what the learner does, and whether the running step was tried
//   fault             if a condition of your own asks for a path without a publisher
//
// The plan states what may follow (`then_one_of`), and under which conditions. Among the steps whose
// conditions hold it takes the one with the largest learned value; at the same value the one that the plan
// names first. While the learner listens, it tries any of them with the probability `exploration` instead. It
// never takes a step that the plan does not allow, whatever was learned or loaded.
//
// When a step ends, the criterion judges it: 1 if fulfilled, 0 if open, -1 if lost. With "error": -1 if lost,
// else 1 - error / `half`, at least -1. A judgement counts for the step that was judged, after the one before
// it; plus `discount` times the best value of what may follow, so that a skill is also worth what it leads
// to. A timeout is judged, too. The first step of a start was not chosen, so it is not judged.
//
// While "criterion" is NaN, it counts as open; an "error" of NaN or infinity is lost. Observed numbers:
// sequence.hpp. All outputs and values stay finite: at most 1 / (1 - discount).
//
// Parameters: exploration, discount, half (in the unit of the criterion), seed, settings (of the learner),
// files. A file of a plan with other steps is refused. Errors: learner.model; `cca::refused` for files. Cost:
// that of a sequence, and one operation per allowed step. Source: preference.hpp.
// Example: tests/runtime/adaptive/learned_sequencer.cpp; docs/adaptive.md.
#pragma once

#include <cmath>
#include <string>
#include <tuple>
#include <type_traits>

#include <cca/adaptive/criterion.hpp>
#include <cca/adaptive/choice/preference.hpp>
#include <cca/adaptive/sequencer.hpp>
#include <cca/adaptive/training.hpp>
#include <cca/base/math/random_numbers.hpp>

namespace cca {

template <fixed_string Scope,
          class Plan,
          Learner Rule = preference_learning<preference_table<Plan>>,
          class Policy = delayed<1>>
struct learned_sequencer {
  using model = preference_table<Plan>;
  static constexpr bool bound = detail::check_models<typename Rule::model, model>();
  using learner = std::conditional_t<bound, Rule, preference_learning<model>>;
  using learner_settings = typename learner::settings;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (bounded<double, 0, 1>, exploration),
                             (bounded<double, 0, 0.99>, discount),
                             (bounded<double, 1e-12, 1e12>, half),
                             (bounded<int, 0, 1000000>, seed),
                             (learner_settings, settings),
                             (learned_files, files));
    parameters(double tries = 0.2,
               double counts_later = 0,
               double middle = 1,
               int first = 1,
               const learner_settings& of_learner = {},
               const learned_files& names = {})
        : exploration(tries),
          discount(counts_later),
          half(middle),
          seed(first),
          settings(of_learner),
          files(names) {}
  };
  static constexpr auto asked_paths = Plan::asked_paths;
  parameters p{};
  sequence<Plan> steps;
  training<learner, 500> learning;

  auto process(observe<detail::with_components<Scope>(), Policy> told,
               in<"criterion", criterion_port> criterion,
               optional_in<"error", criterion_error> error,
               optional_in<"learn", learning_request> call,
               beat now) -> detail::with_parts<Plan,
                                               out<"step", step_port>,
                                               out<"running", step_time>,
                                               out<"timed_out", step_flag>,
                                               out<"status", component_status_port>,
                                               out<"module", module_status_port>,
                                               fault> {
    if (call) learning.hear(call, p.settings);
    const int running = steps.step();
    const std::int64_t age = steps.beats(now);
    steps.update_by(now, [this](int from, std::span<const int> ready) { return chosen(from, ready); }, told);
    // A step may follow itself: then its time begins again.
    if (steps.step() != running || steps.beats(now) < age) {
      if (before >= 0) learn(before, running, judgement(criterion, error));
      before = running;
    }
    const std::int64_t period = now.index() > 0 ? now.time() / now.index() : 0;
    return detail::add_parts<Plan>(
        steps.step(), out<"step", step_port>(steps.step()),
        out<"running", step_time>(1e-9 * static_cast<double>(steps.beats(now) * period)),
        out<"timed_out", step_flag>(steps.timed_out() ? 1 : 0),
        out<"status", component_status_port>(
            status_of(steps.finished() ? component_status::reached : component_status::converging)),
        out<"module", module_status_port>(
            learning.status({std::max(before, 0), steps.step()}, p.settings, static_cast<bool>(call))),
        steps.unheard() ? fault("sequencer: a condition names a path that nobody publishes under its scope")
                        : fault());
  }

  void on_load() {
    if (!p.files.load.view().empty()) learning.load(std::string(p.files.load.view()));
  }
  void on_save() {
    if (!p.files.save.view().empty()) learning.save(std::string(p.files.save.view()));
  }
  void on_wired(std::string_view input) {
    if (input == "learn") learning.compute_batches();
  }
  // Why a constant request is refused (learner.request).
  static constexpr std::string_view refusal(std::string_view input, double constant) {
    return input == "learn" ? training<learner, 500>::refusal(constant) : std::string_view{};
  }
  void on_start() {
    steps = {};
    before = -1;
    random = random_numbers(static_cast<std::uint64_t>(p.seed));
  }

  // The learned value of going from one step to another.
  double value(int from, int to) const { return learning.answer({from, to})[0]; }

private:
  bool listens() const {
    return learning.state() == cca::learning::online || learning.state() == cca::learning::collecting;
  }

  int chosen(int from, std::span<const int> ready) {
    if (ready.size() > 1 && listens() && random.happens(p.exploration))
      return ready[static_cast<std::size_t>(random.uniform() * static_cast<double>(ready.size()))];
    int best = ready[0];
    for (const int one : ready)
      if (value(from, one) > value(from, best)) best = one;
    return best;
  }

  double judgement(const in<"criterion", criterion_port>& criterion,
                   const optional_in<"error", criterion_error>& error) const {
    const auto state = criterion.template as<criterion_state>();
    if (state == criterion_state::lost) return -1;
    if (!error) return state == criterion_state::fulfilled ? 1 : 0;
    const double off = std::abs(error[error_axis{}]);
    return off <= 2 * p.half ? 1 - off / p.half : -1;
  }

  void learn(int from, int to, double worth) {
    const auto& next = Plan::next_of[static_cast<std::size_t>(to)];
    double best = next.count > 0 ? value(to, next.steps[0]) : 0;
    for (std::size_t i = 1; i < static_cast<std::size_t>(next.count); ++i)
      best = std::max(best, value(to, next.steps[i]));
    const double most = 1 / (1 - p.discount);
    learning.teach({from, to}, typename model::output(std::clamp(worth + p.discount * best, -most, most)),
                   p.settings);
  }

  int before = -1;  // the step before the running one; -1: none
  random_numbers random{1};
};

}  // namespace cca
