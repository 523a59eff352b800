// A learner finds the parameters of a function from examples (seed, chapter 3, *Learner*). A learning rule
// belongs to the form of the function: so a learner names the model that it adapts, and a module refuses one
// that is bound to another model.
//
//   AdaptableModel    what is adapted: `input`, `output` (vectors of fixed size), `parameters` (a struct with
//   named fields),
//                     `answer(parameters, input)`, `title()`, which tells it from others in a file
//   LocalModel        linear in `parameters::weights`, a column a local function: `activations(input)`,
//   `scale(input)`;
//                     the answer is weights * (scale * activations)
//   LinearModel       linear in `parameters::weights`: the answer is weights * regressors(input)
//   Learner           `model`, `settings` (what a user may set), `learned` (what a file keeps; its field
//   `function` holds the
//                     model's parameters), `inside(learned, x, settings)`: is x where it was trained
//   OnlineLearner     `step(learned, x, y, settings)`: one example, in a beat; its cost has a bound
//   BatchLearner      `batch(examples, settings)`: all of them, outside of the loop, whatever it takes
//
// A learner has no state of its own: that is `learned`, a value, held by a `training` (training.hpp). A batch
// is therefore done on another thread and handed over whole. Errors: learner.model. Laws:
// tests/laws/learner_laws.hpp; docs/learners.md.
#pragma once

#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include <cca/adaptive/ode.hpp>
#include <cca/base/reflect.hpp>

namespace cca {

template <class Model> concept AdaptableModel =
    detail::FixedVector<typename Model::input> && detail::FixedVector<typename Model::output> &&
    detail::Reflected<typename Model::parameters> &&
    requires(const typename Model::parameters& p, const typename Model::input& x) {
      { Model::answer(p, x) } -> std::convertible_to<typename Model::output>;
      { Model::title() } -> std::convertible_to<std::string>;
    };

template <class Model> concept LinearModel =
    AdaptableModel<Model> && requires(typename Model::parameters& p, const typename Model::input& x) {
      { Model::regressors(x) } -> detail::FixedVector;
      requires detail::EigenVector<decltype((p.weights * Model::regressors(x)).eval())>;
    };

template <class Model> concept LocalModel = LinearModel<Model> && requires(const typename Model::input& x) {
  { Model::activations(x) } -> detail::FixedVector;
  { Model::scale(x) } -> std::convertible_to<double>;
};

// What goes with what.
template <AdaptableModel Model>
struct example {
  typename Model::input x;
  typename Model::output y;
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

// True where a module may use a learner; else that has been reported, by a function whose arguments the
// compilers name: for a concept they would name them twice.
template <class LearnersModel, class ModulesModel, bool AreOne = std::is_same_v<LearnersModel, ModulesModel>>
constexpr bool check_models() {
  static_assert(AreOne,
                "learner.model: the learner of this module adapts another model than the one that the module "
                "runs, so what it learns "
                "would mean nothing to it (the compiler names the two, the learner's first); bind the "
                "learner to the module's model");
  return AreOne;
}

}  // namespace detail
}  // namespace cca
