// An Adaptive Mapping: a mapping whose function is learned (the source document, chapter 3). An Adaptive
// Transformation: the same within one space.
//
//   using ik = cca::extreme_learning_machine<cca::elm_function<paw, leg_angles, 100>>;
//   cca::node<"ik", cca::adaptive_mapping<paw, leg_angles, ik>>
//
//   in  "input"      From
//   in  "teacher"    To                   optional: the right output for this input; each fresh sample is an
//                                         example
//   in  "learn"      learning_request     optional: a request of another component
//   out "output"     To
//   out "module"     module_status_port
//
// adaptive_transformation<Space, Rule> learns a correction that is added to the input: untrained, it passes
// the input on. Programs learn between two beats through `learning`, a cca::training. Parameters: settings
// (of the learner), files (load, save). Both are a cca::Mapping and may stand in chains.
// Numbers beyond 1e12 count as 1e12. NaN and infinity are never learned; the output of that firing is NaN,
// and the status says `outside` (the trained region). Preconditions: spaces with one number per axis. Errors:
// learner.model, learner.request; `cca::refused` for files. Cost: one answer; with a teacher also one step of
// the learner. Example: tests/runtime/adaptive/mapping.cpp.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <cca/component/input_status.hpp>
#include <cca/adaptive/training.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/mapping/mapping.hpp>

namespace cca {
namespace detail {

template <class Model, class From, class To>
constexpr bool maps_between = matching<typename Model::from, From> && matching<typename Model::to, To>;

template <class Model, class From, class To>
struct model_between_others {
  static constexpr void tell(text& m) {
    m << "learner.model: the learner of this adaptive mapping adapts the model " << type_name<Model>()
      << " from " << space_in_words<typename Model::from>() << " to " << space_in_words<typename Model::to>()
      << ", and the mapping is from " << space_in_words<From>() << " to " << space_in_words<To>()
      << "; bind the learner to a model between these spaces";
  }
};
template <class Model, class From, class To>
constexpr bool check_model_of_mapping() {
  constexpr bool fits = maps_between<Model, From, To>;
  static_assert(holds_or_tells<fits, model_between_others<Model, From, To>>::value);
  return fits;
}

// `Correction`: the learned function is added to the input.
template <class From, class To, class Rule, int Capacity, bool Correction>
struct learned_mapping {
  static constexpr bool bound = check_model_of_mapping<typename Rule::model, From, To>();
  using checked = std::bool_constant<bound>;  // checked where the class is named, not only where it runs
  using learner_settings = typename Rule::settings;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (learner_settings, settings), (learned_files, files));
  };
  parameters p{};
  training<Rule, Capacity> learning;

  auto process(in<"input", From> input,
               optional_in<"teacher", To> teacher,
               optional_in<"learn", learning_request> call)
      -> std::tuple<out<"output", To>, out<"module", module_status_port>> {
    if constexpr (!bound) {
      return {};
    } else {
      if (call) learning.hear(call, p.settings);
      detail::input_check inputs;
      const typename From::vector_type x = inputs(input.vector());
      typename To::vector_type zero = To::vector_type::Zero();
      if constexpr (Correction) zero = x;
      if (teacher && teacher.fresh()) learning.teach(x, teacher.vector() - zero, p.settings);
      // A model may answer infinity with a finite number.
      const typename To::vector_type y =
          inputs.unreadable() ? To::vector_type::Constant(std::numeric_limits<double>::quiet_NaN()).eval()
                              : typename To::vector_type(zero + learning.answer(x));
      return {y, learning.status(x, p.settings, static_cast<bool>(call))};
    }
  }

  void on_load() {
    if (!p.files.load.view().empty()) learning.load(std::string(p.files.load.view()));
  }
  void on_save() {
    if (!p.files.save.view().empty()) learning.save(std::string(p.files.save.view()));
  }
  void on_wired(std::string_view port) {
    if (port == "learn") learning.compute_batches();
  }
  // Why a constant request is refused (learner.request).
  static constexpr std::string_view refusal(std::string_view port, double constant) {
    return port == "learn" ? training<Rule, Capacity>::refusal(constant) : std::string_view{};
  }
};

}  // namespace detail

template <Space From, Space To, Learner Rule, int Capacity = 1000>
  requires(From::size == From::axes::count && To::size == To::axes::count)
struct adaptive_mapping : detail::learned_mapping<From, To, Rule, Capacity, false> {};

template <Space Within, Learner Rule, int Capacity = 1000>
  requires(Within::size == Within::axes::count)
struct adaptive_transformation : detail::learned_mapping<Within, Within, Rule, Capacity, true> {};

}  // namespace cca
