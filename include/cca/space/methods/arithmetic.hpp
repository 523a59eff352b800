// What `to - at` says where a domain type has no such operator: calculate with the numbers of the samples,
// `to.vector() - at.vector()`. Errors: space.arithmetic. Cost: none, nothing of it is ever compiled in.
#pragma once

#include <concepts>
#include <type_traits>

#include <cca/base/eigen.hpp>
#include <cca/space/methods/linear.hpp>

namespace cca {
namespace detail {

template <class Type> concept Numbers =
    std::is_arithmetic_v<Type> || std::derived_from<Type, Eigen::MatrixBase<Type>>;
template <class Type> concept HasSums = requires(const Type& a) { a.operator*(1.0); };

template <class A, class B> concept SampleWith =
    (Sample<A> && (Sample<B> || Numbers<B>)) || (Numbers<A> && Sample<B>);

template <class A, class B> concept NoSum =
    SampleWith<A, B> && !requires(const A& a, const B& b) { a.operator+(b); };
template <class A, class B> concept NoProduct = SampleWith<A, B> && !requires(const A& a, const B& b) {
  a.operator*(b);
} && !(std::is_arithmetic_v<A> && HasSums<B>);

// The vector that the user most likely wants, so that nothing else is reported.
template <class A, class B>
constexpr auto no_vector() {
  if constexpr (Sample<B> && std::is_class_v<A> && !Sample<A>) {
    return Eigen::Matrix<double, A::RowsAtCompileTime, 1>::Zero().eval();
  } else {
    using vector = typename std::conditional_t<Sample<A>, A, B>::space::vector_type;
    return vector::Zero().eval();
  }
}

template <class A, class B, char Operator>
struct no_arithmetic {
  static constexpr void tell(text& m) {
    using space = typename std::conditional_t<Sample<A>, A, B>::space;
    m << "space.arithmetic: samples of " << space_in_words<space>() << " have no such operator ";
    m.put(Operator);
    m << ": calculate with their numbers, as in `to.vector() - at.vector()`, or with the functions of the "
         "domain type, as in `to.difference(at)`; docs/spaces.md lists them";
  }
};

template <class A, class B, char Operator>
constexpr auto refuse_arithmetic() {
  static_assert(holds_or_tells<false, no_arithmetic<A, B, Operator>>::value);
  return no_vector<A, B>();
}

}  // namespace detail

template <class A, class B>
  requires detail::NoSum<A, B>
constexpr auto operator+(const A&, const B&) {
  return detail::refuse_arithmetic<A, B, '+'>();
}
template <class A, class B>
  requires detail::NoSum<A, B>
constexpr auto operator-(const A&, const B&) {
  return detail::refuse_arithmetic<A, B, '-'>();
}
template <class A, class B>
  requires detail::NoProduct<A, B>
constexpr auto operator*(const A&, const B&) {
  return detail::refuse_arithmetic<A, B, '*'>();
}
template <Sample A, detail::Numbers B>
constexpr auto operator/(const A&, const B&) {
  return detail::refuse_arithmetic<A, B, '/'>();
}

}  // namespace cca
