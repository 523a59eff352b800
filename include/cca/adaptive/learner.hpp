// A learner finds the parameters of a function from examples (the source document, chapter 3, *Learner*). A
// learning rule fits the form of the function, so a learner names the model that it adapts. A module refuses
// a learner of another model.
//
//   AdaptableModel    what is adapted: `input`, `output` (vectors of fixed size), `parameters` (a struct with
//                     named fields), `answer(parameters, input)`, `title()`, which identifies it in a file
//   LinearModel       linear in `parameters::weights`: the answer is weights * regressors(input)
//   LocalModel        linear, with one column of weights per local function: `activations(input)`,
//                     `scale(input)`; the answer is weights * (scale * activations)
//   SequenceModel     `is_sequence` is true: what belongs to an input also depends on those before it. Its
//                     examples keep their order, and say where a demonstration `begins`
//   Learner           `model`, `settings` (of the user), `learned` (what a file keeps; its field `function`
//                     holds the parameters of the model), `inside(learned, x, settings)`: is x in the trained
//                     region
//   OnlineLearner     `step(learned, x, y, settings)`: learns one example within a beat; its cost is bounded
//   BatchLearner      `batch(examples, settings)`: learns from all examples, outside of the loop
//
// NaN and infinity reach no learner: `training` ignores such an example, and says `outside` (the trained
// region) of such an input without asking the learner. So a learner checks no number, and has neither a
// status nor a fault.
//
// A learner has no state of its own. The state is `learned`, a value in a `training` (training.hpp), so a
// batch can run on another thread and hand over its whole result. Errors: learner.model.
// Laws: tests/laws/learner_laws.hpp; docs/learners.md.
#pragma once

#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include <cca/adaptive/ode.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/reflect.hpp>

namespace cca {

namespace detail {

template <class Model>
struct no_title {
  static constexpr void tell(text& m) {
    m << "learner.model: the model " << type_name<Model>()
      << " has no title, by which a file of learned parameters is recognised: add `static std::string "
         "title()` to it, which returns for example `reaching v1`";
  }
};
// Asked last, of what is a model in all else.
template <class Model>
constexpr bool has_title() {
  constexpr bool states = requires {
    { Model::title() } -> std::convertible_to<std::string>;
  };
  static_assert(holds_or_tells<states, no_title<Model>>::value);
  return true;
}

}  // namespace detail

template <class Model> concept AdaptableModel =
    detail::FixedVector<typename Model::input> && detail::FixedVector<typename Model::output> &&
    detail::Reflected<typename Model::parameters> &&
    requires(const typename Model::parameters& p, const typename Model::input& x) {
      { Model::answer(p, x) } -> std::convertible_to<typename Model::output>;
    } && detail::has_title<Model>();

template <class Model> concept LinearModel =
    AdaptableModel<Model> && requires(typename Model::parameters& p, const typename Model::input& x) {
      { Model::regressors(x) } -> detail::FixedVector;
      requires detail::EigenVector<decltype((p.weights * Model::regressors(x)).eval())>;
    };

template <class Model> concept LocalModel = LinearModel<Model> && requires(const typename Model::input& x) {
  { Model::activations(x) } -> detail::FixedVector;
  { Model::scale(x) } -> std::convertible_to<double>;
};

template <class Model> concept SequenceModel =
    AdaptableModel<Model> && requires { requires Model::is_sequence; };

// An input and the output that belongs to it.
template <AdaptableModel Model>
struct example {
  typename Model::input x;
  typename Model::output y;
};
template <SequenceModel Model>
struct example<Model> {
  typename Model::input x;
  typename Model::output y;
  bool begins = false;  // the first of a demonstration
};

template <class Type> concept Learner = AdaptableModel<typename Type::model> &&
                                        detail::Reflected<typename Type::settings> &&
                                        detail::Reflected<typename Type::learned> &&
                                        requires(const typename Type::learned& known,
                                                 const typename Type::model::input& x,
                                                 const typename Type::settings& s) {
                                          {
                                            known.function
                                          } -> std::convertible_to<const typename Type::model::parameters&>;
                                          { Type::inside(known, x, s) } -> std::same_as<bool>;
                                          { Type::name } -> std::convertible_to<std::string_view>;
                                        };

template <class Type> concept OnlineLearner =
    Learner<Type> && requires(typename Type::learned& known,
                              const typename Type::model::input& x,
                              const typename Type::model::output& y,
                              const typename Type::settings& s) { Type::step(known, x, y, s); };

template <class Type> concept BatchLearner =
    Learner<Type> &&
    requires(std::span<const example<typename Type::model>> examples, const typename Type::settings& s) {
      { Type::batch(examples, s) } -> std::same_as<typename Type::learned>;
    };

namespace detail {

template <class LearnerModel, class ModuleModel>
struct other_model {
  static constexpr void tell(text& m) {
    m << "learner.model: the learner of this module adapts the model " << type_name<LearnerModel>()
      << ", and the module runs " << type_name<ModuleModel>()
      << ", so the module could not use the result; bind the learner to the model of the module";
  }
};
// True if a module may use a learner; else it reports the mistake.
template <class LearnerModel, class ModuleModel>
constexpr bool check_models() {
  constexpr bool same = std::is_same_v<LearnerModel, ModuleModel>;
  static_assert(holds_or_tells<same, other_model<LearnerModel, ModuleModel>>::value);
  return same;
}

}  // namespace detail
}  // namespace cca
