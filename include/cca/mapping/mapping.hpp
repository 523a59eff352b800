// Mappings take samples of one space to another, transformations stay within one space (the source document,
// section 4.4.2). Both are components made from a function object:
//
//   struct polar { Eigen::Vector2d operator()(const cca::sample<foot>& p) const; };
//   cca::node<"polar", cca::mapping<foot, foot_polar, polar>>
//   cca::node<"mirror", cca::transformation<foot, mirror>>           the same, in one space
//
//   in  "input"    From
//   out "output"   To (of a transformation: the same space)
//
// The function takes a sample or its vector. It returns a sample of the output space, its vector, or a number
// if the space has one axis. The component has the `parameters` and hooks of the function object.
//
// `Mapping<C>` holds for each component with one input and one output, not counting outputs of domain
// `status` and optional inputs. `Transformation<C>`: these two have matching spaces. `input_space<C>` and
// `output_space<C>` are their spaces.
//
// NaN and infinity are passed to the function as they come; a function with a state must not keep them.
//
// Errors: transform.leaves_space, space.mismatch. Cost: that of the function.
// Example: tests/runtime/mapping/example.cpp; docs/mappings.md.
#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/component/component.hpp>
#include <cca/component/mapped_ports.hpp>
#include <cca/component/port.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/info.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca {

template <class Component> concept Mapping = detail::HasProcess<Component> &&
                                             detail::mapped_inputs<Component>::count == 1 &&
                                             detail::mapped_outputs<Component>::count == 1;

template <Mapping Component>
using input_space = typename detail::mapped_inputs<Component>::first::space;
template <Mapping Component>
using output_space = typename detail::mapped_outputs<Component>::first::space;

// A concept, because compilers print its arguments: the two spaces.
template <class SpaceA, class SpaceB> concept SameSpace = detail::matching<SpaceA, SpaceB>;

template <class Component> concept Transformation =
    Mapping<Component> && SameSpace<input_space<Component>, output_space<Component>>;

namespace detail {

template <class Function, class From> concept TakesSample =
    std::is_invocable_v<Function&, const sample<From>&>;
template <class Function, class From> concept TakesVector =
    !TakesSample<Function, From> && std::is_invocable_v<Function&, const typename From::vector_type&>;

template <class Function, class From>
struct result_of;
template <class Function, class From>
  requires TakesSample<Function, From>
struct result_of<Function, From> {
  using type = std::remove_cvref_t<std::invoke_result_t<Function&, const sample<From>&>>;
};
template <class Function, class From>
  requires TakesVector<Function, From>
struct result_of<Function, From> {
  using type = std::remove_cvref_t<std::invoke_result_t<Function&, const typename From::vector_type&>>;
};

// Whether the result of a function lies in a space: a sample of the space, a vector of its size, or a number
// if it has one axis.
template <class Result, class To>
constexpr bool lies_in() {
  if constexpr (Sample<Result>) return matching<typename Result::space, To>;
  else if constexpr (EigenVector<Result>)
    return Result::RowsAtCompileTime == To::size && Result::ColsAtCompileTime == 1;
  else return To::size == 1 && std::is_convertible_v<Result, double>;
}

template <class Result, class Space> concept LiesIn = lies_in<Result, Space>();

template <class Function, class From> concept Takes =
    TakesSample<Function, From> || TakesVector<Function, From>;

template <class Function, class From, class To> concept MapsInto =
    Takes<Function, From> && LiesIn<typename result_of<Function, From>::type, To>;

template <class To, class Result>
constexpr typename To::vector_type coordinates_of(const Result& y) {
  if constexpr (Sample<Result>) return y.vector();
  else if constexpr (EigenVector<Result>) return y;
  else return To::vector_type::Constant(static_cast<double>(y));
}

// The component. With a function that does not fit it publishes zero; the mistake is reported elsewhere.
template <class From, class To, class Function>
struct mapping_by : Function {
  auto process(in<"input", From> input) -> out<"output", To> {
    Function& f = *this;
    if constexpr (!MapsInto<Function, From, To>) return {};
    else if constexpr (TakesSample<Function, From>)
      return coordinates_of<To>(f(static_cast<const sample<From>&>(input)));
    else return coordinates_of<To>(f(input.vector()));
  }
};

// What a function returns, of a sample with its space.
template <class Function, class From>
constexpr void tell_result(text& m) {
  using result = typename result_of<Function, From>::type;
  if constexpr (Sample<result>) m << space_in_words<typename result::space>();
  else if constexpr (EigenVector<result>)
    m << "a matrix of " << static_cast<int>(result::RowsAtCompileTime) << " x "
      << static_cast<int>(result::ColsAtCompileTime);
  else m << "`" << type_name<result>() << "`";
}
template <class From, class Function>
struct takes_other {
  static constexpr void tell(text& m) {
    m << "space.mismatch: the function " << type_name<Function>()
      << " of this mapping takes neither a sample of its input space, " << space_in_words<From>()
      << ", nor the vector of " << From::size << (From::size == 1 ? " number" : " numbers")
      << " of one: give it `operator()(const cca::sample<" << type_name<From>()
      << ">&)`, or name the space that it takes as the first argument";
  }
};
template <class From, class To, class Function>
struct maps_elsewhere {
  static constexpr void tell(text& m) {
    m << "space.mismatch: the function " << type_name<Function>() << " of this mapping returns ";
    tell_result<Function, From>(m);
    m << ", which is neither a sample nor a vector nor a number of the output space, " << space_in_words<To>()
      << "; return one of these, or name the space that it returns as the second argument of the mapping";
  }
};
template <class Space, class Function>
struct leaves_space {
  static constexpr void tell(text& m) {
    m << "transform.leaves_space: the function " << type_name<Function>()
      << " of this transformation returns ";
    tell_result<Function, Space>(m);
    m << ", but its input is in " << space_in_words<Space>()
      << "; a transformation stays in its space, so return a sample or a vector of that space, or use "
         "`cca::mapping<from, to, function>`";
  }
};

// The checks stand in functions that the components name: an assertion that fails inside the class brings
// errors of its own with it.
template <class From, class To, class Function>
constexpr auto check_mapping() {
  static_assert(holds_or_tells<Takes<Function, From>, takes_other<From, Function>>::value);
  static_assert(holds_or_tells<(!Takes<Function, From> || MapsInto<Function, From, To>),
                               maps_elsewhere<From, To, Function>>::value);
}
template <class Space, class Function>
constexpr auto check_transformation() {
  static_assert(holds_or_tells<Takes<Function, Space>, takes_other<Space, Function>>::value);
  static_assert(holds_or_tells<(!Takes<Function, Space> || MapsInto<Function, Space, Space>),
                               leaves_space<Space, Function>>::value);
}

}  // namespace detail

template <class From, class To, class Function>
struct mapping : detail::mapping_by<From, To, Function> {
  using checked = decltype(detail::check_mapping<From, To, Function>());
};

template <class Space, class Function>
struct transformation : detail::mapping_by<Space, Space, Function> {
  using checked = decltype(detail::check_transformation<Space, Function>());
};

}  // namespace cca
