// An array-valued space: N elements of one space, one after another, as one sample.
//
//   struct paws : cca::array_of<paw_position, 4> {};      axes element<x, 0>, element<z, 0>, ...
//
// It takes the rate of the element's space; its domain type is `array_domain`. In a sample, `template
// part<I>()` is the sample of element I; interpolation works element by element. Each element's axes keep
// their limits.
#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/array_size.hpp>
#include <cca/space/frame.hpp>
#include <cca/base/joined_names.hpp>
#include <cca/space/methods/linear.hpp>
#include <cca/space/methods/scalar.hpp>
#include <cca/space/sample.hpp>

namespace cca {

// The axis of one element: `hip` of element 2 is named "hip2".
template <class Axis, std::size_t Number>
struct element : Axis {
  static constexpr auto label = detail::numbered<Axis::label, Number>;
  static constexpr std::string_view name = label.view();
};

template <class Domain, int Count>
struct array_domain {
  using quantity = typename Domain::quantity;
  using frames = typename detail::frames_of<Domain>::type;
  static constexpr bool actuated = Domain::actuated;
  static constexpr int width(int axes) { return Count * Domain::width(axes / Count); }
  static constexpr double zero(int i, int axes) {
    return Domain::zero(i % Domain::width(axes / Count), axes / Count);
  }

  template <class Self>
  struct methods : detail::mixin<Self> {
    template <int Number>
    constexpr auto part() const {
      using one = typename Self::space::element_space;
      return sample<one>(this->self().vector().template segment<one::size>(Number * one::size),
                         this->self().origin());
    }

    // Each element on its own; this sample at t = 0, `to` at t = 1.
    template <Sample To>
    constexpr Self interpolated(const To& to, double t) const {
      typename Self::space::vector_type v;
      if constexpr (detail::combinable<Self, To>())
        [&]<int... Number>(std::integer_sequence<int, Number...>) {
          constexpr int size = Self::space::element_space::size;
          ((v.template segment<size>(Number * size) =
                part<Number>().interpolated(to.template part<Number>(), t).vector()),
           ...);
        }(std::make_integer_sequence<int, Count>());
      return Self(v, detail::older(this->self().origin(), to.origin()));
    }
  };
};

namespace detail {

template <class Axes, class Numbers>
struct array_axes;
template <class... Axes, std::size_t... Number>
struct array_axes<axes<Axes...>, std::index_sequence<Number...>> {
  template <std::size_t N>
  using one = axes<element<Axes, N>...>;
  template <class... All>
  struct all;
  template <class... A>
  struct all<axes<A...>> {
    using type = axes<A...>;
  };
  template <class... A, class... B, class... Rest>
  struct all<axes<A...>, axes<B...>, Rest...> : all<axes<A..., B...>, Rest...> {};
  using type = typename all<one<Number>...>::type;
};

template <int Count>
inline constexpr int at_least_one = Count > 0 ? Count : 1;  // so that an array of none gives one error
template <class Element, int Count>
struct empty_array {
  static constexpr void tell(text& m) {
    m << "space.bad_axes: `cca::array_of<" << type_name<Element>() << ", " << Count
      << ">` is to have as many elements, and an array has at least one: give it another number";
  }
};

// After its message, what is no space counts as this one.
struct some_axis : dimension<"element"> {};
struct some_element : space<number, axes<some_axis>> {};
template <class Element>
using element_of_array = std::conditional_t<Space<Element>, Element, some_element>;
template <class Element, int Count>
struct array_of_no_space {
  static constexpr void tell(text& m) {
    m << "space.bad_domain: the elements of `cca::array_of<" << type_name<Element>() << ", " << Count
      << ">` are no space: name a struct derived from cca::space<...>; several numbers that belong together "
         "are a space of several axes";
  }
};

template <class Element, int Count>
using space_of_array =
    space<array_domain<typename Element::domain, at_least_one<Count>>,
          typename array_axes<typename Element::axes,
                              std::make_index_sequence<array_size(at_least_one<Count>)>>::type,
          typename Element::rate>;

}  // namespace detail

template <class Element, int Count>
struct array_of : detail::space_of_array<detail::element_of_array<Element>, Count> {
  static_assert(detail::holds_or_tells<Space<Element>, detail::array_of_no_space<Element, Count>>::value);
  static_assert(detail::holds_or_tells<(Count > 0), detail::empty_array<Element, Count>>::value);
  using element_space = detail::element_of_array<Element>;
};

}  // namespace cca
