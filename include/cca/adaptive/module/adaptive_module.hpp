// One template makes an Adaptive Module: a motion (an ode with its ports), a learner that is bound to the
// motion's model, the statuses of both, and a file (the source document, chapter 3, *Adaptive Module*).
//
//   struct my_module : cca::adaptive_module<my_motion> {};
//
//   in  ...              the inputs of the motion; for an adaptive component one of them is "reference"
//   in  "demonstration"  the motion's space  optional: the movement to learn
//   in  "learn"          learning_request    optional: a request of another component (training.hpp)
//   out ...              the outputs of the motion; for an adaptive component one of them is "command"
//   out "ode"            ode_status_port
//   out "module"         module_status_port  what the learner does, whether this input was trained, and what
//                                            became of the last request
//
// A motion is a class with a state. It has
//
//   model, default_learner       what is learned (learner.hpp), and the learner if the user names none
//   demonstrated                 the space of the port "demonstration"
//   inputs, outputs              module_inputs<ports...>, module_outputs<ports...>
//   parameters<Settings>         the parameters of the module, with the fields `settings` (a Settings, of the
//                                learner) and `files` (learned_files)
//   step(give, p, function, teach, inputs..., demonstration, now)
//                                one firing. `function` is the learned value. `teach(x, y)` gives an example
//                                to the learner; `teach.listens()`: it would use one;
//                                `teach.begin_demonstration()`: the next one begins another demonstration
//                                (for a SequenceModel). It returns give(the number for "ode", the input of
//                                the model, the outputs...)
//   start()                      the next movement begins anew
//   constants(p)                 static: the values that the learned numbers depend on; a file states them
//   load(p)                      optional: before a file is read
//   examples(movement, s, p)     optional, static: those of a whole movement with a sample every s seconds
//
// A program learns between two beats through `learning`, a cca::training. `demonstrate(movement, s)` teaches
// a whole recorded movement there; it is refused while nothing listens, for fewer than three samples, for a
// number that is NaN or infinite, and for more samples than the module keeps.
//
// While an input is NaN or infinite, the motion does what its header says; a demonstration that is not finite
// is never learned. Errors: learner.model; `cca::refused` for files and movements. Cost: that of the motion;
// with a demonstration also one step of the learner. Learning a batch adds nothing to a beat
// (tests/runtime/adaptive/undisturbed.cpp).
// Example: include/cca/motor/modules/gmr_module.hpp; docs/adaptive.md.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include <cca/adaptive/ode_status.hpp>
#include <cca/adaptive/training.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>

namespace cca {

template <class... Ports>
struct module_inputs {};
template <class... Ports>
struct module_outputs {};

// Hands examples to a training.
template <class Training>
class module_teacher {
public:
  module_teacher(Training& to, const typename Training::settings& s) : learning(to), settings(s) {}
  bool listens() const {
    return learning.state() == cca::learning::collecting || learning.state() == cca::learning::online;
  }
  // The next example begins another demonstration: for models of sequences.
  [[gnu::always_inline]] void begin_demonstration() const { learning.begin_demonstration(); }
  // docs/compilers.md says why it is inlined.
  [[gnu::always_inline]] void operator()(const typename Training::input& x,
                                         const typename Training::output& y) const {
    learning.teach(x, y, settings);
  }

private:
  Training& learning;
  const typename Training::settings& settings;
};

namespace detail {

template <class Motion, Learner Rule, int Capacity, class Inputs, class Outputs>
struct module_of;

template <class Motion, Learner Rule, int Capacity, class... In, class... Out>
struct module_of<Motion, Rule, Capacity, module_inputs<In...>, module_outputs<Out...>> {
  using model = typename Motion::model;
  using demonstrated = typename Motion::demonstrated;
  static constexpr bool bound = check_models<typename Rule::model, model>();
  using learner = std::conditional_t<bound, Rule, typename Motion::default_learner>;
  using learner_settings = typename learner::settings;
  using parameters = typename Motion::template parameters<learner_settings>;
  parameters p{};
  training<learner, Capacity> learning;

  auto process(In... inputs,
               optional_in<"demonstration", demonstrated> demonstration,
               optional_in<"learn", learning_request> call,
               beat now)
      -> std::tuple<Out..., out<"ode", ode_status_port>, out<"module", module_status_port>> {
    const auto asked = static_cast<bool>(call);
    if (asked) learning.hear(call, p.settings);
    // The motion calls it, so the outputs are made in their place: a result that is taken apart here costs
    // 90 instructions.
    const auto give = [this, asked](double ode, const typename model::input& at,
                                    const Out&... outputs) __attribute__((always_inline)) {
      return std::tuple<Out..., out<"ode", ode_status_port>, out<"module", module_status_port>>(
          outputs..., ode, learning.status(at, p.settings, asked));
    };
    return motion.step(give, p, learning.get().function, module_teacher(learning, p.settings), inputs...,
                       demonstration, now);
  }

  // Teaches a whole movement, with a sample every `seconds`. For use between two beats.
  void demonstrate(std::span<const typename demonstrated::vector_type> movement, double seconds)
    requires requires(const parameters& with) { Motion::examples(movement, seconds, with); }
  {
    const module_teacher teach(learning, p.settings);
    const std::string refusal = "cca::adaptive_module: demonstrate() is refused: ";
    if (!teach.listens())
      throw refused(refusal + "the learner is `" + std::string(to_string(learning.state())) +
                    "`; call learning.collect() or learning.learn() first");
    if (!(seconds > 0) || !(seconds <= largest_input))
      throw refused(refusal + "there are " + number_text(seconds) + " s between its samples");
    if (movement.size() < 3)
      throw refused(refusal + "the movement has " + std::to_string(movement.size()) +
                    " samples; it needs at least 3");
    if (movement.size() > static_cast<std::size_t>(Capacity) && learning.state() == cca::learning::collecting)
      throw refused(refusal + "the movement has " + std::to_string(movement.size()) +
                    " samples, and the module keeps " + std::to_string(Capacity) +
                    "; give the module a larger capacity, or leave samples out");
    for (std::size_t i = 0; i < movement.size(); ++i)
      if (!all_finite(movement[i]))
        throw refused(refusal + "sample " + std::to_string(i) + " of the movement is NaN or infinite");
    learning.begin_demonstration();
    for (const auto& one : Motion::examples(movement, seconds, p)) teach(one.x, one.y);
  }

  void on_load() {
    if constexpr (requires { motion.load(p); }) motion.load(p);
    if (!p.files.load.view().empty()) learning.load(std::string(p.files.load.view()), constants());
  }
  void on_save() {
    if (!p.files.save.view().empty()) learning.save(std::string(p.files.save.view()), constants());
  }
  void on_start() { motion.start(); }
  void on_wired(std::string_view input) {
    if (input == "learn") learning.compute_batches();
  }
  // Why a constant request is refused (learner.request).
  static constexpr std::string_view refusal(std::string_view input, double constant) {
    return input == "learn" ? training<learner, Capacity>::refusal(constant) : std::string_view{};
  }

  std::vector<learned_header::constant> constants() const { return Motion::constants(p); }

  // For programs, after the run.
  std::string summary() const {
    const std::size_t lost = learning.lost_examples();
    if (lost == 0) return {};
    return std::to_string(lost) + " examples were lost, the oldest: it keeps " + std::to_string(Capacity) +
           ", its template argument `Capacity`";
  }

private:
  Motion motion;
};

}  // namespace detail

template <class Motion, Learner Rule = typename Motion::default_learner, int Capacity = 2000>
struct adaptive_module
    : detail::module_of<Motion, Rule, Capacity, typename Motion::inputs, typename Motion::outputs> {};

}  // namespace cca
