// A sample is an immutable value of a space with its time of origin; it has the methods of its domain type.
// Read it by axis, `q[hip{}]`, or whole, `q.vector()`; `q.template on<hip>()` is the part along some axes.
//
// A sample owns its coordinates. Only an input may refer to those that its writer stored, as long as its
// component runs: a copy of it owns its own.
// Errors: space.wrong_length, space.unknown_axis.
#pragma once

#include <cstdint>
#include <type_traits>

#include <cca/base/inlining.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/messages/vector_argument.hpp>
#include <cca/space/origin.hpp>
#include <cca/space/space.hpp>

namespace cca {

namespace detail {

struct to_be_filled {};  // leaves the coordinates uninitialised: the beat fills them

// The two spaces match and differ only in their names.
template <class From, class To> concept Renames =
    !std::is_same_v<From, To> && std::is_same_v<typename From::domain, typename To::domain> &&
    std::is_same_v<typename From::axes, typename To::axes> &&
    (hz_of<typename From::rate> == hz_of<typename To::rate> || hz_of<typename From::rate> == 0 ||
     hz_of<typename To::rate> == 0);

// Samples of so many numbers are not copied to a component that reads them.
template <class Space>
inline constexpr bool is_large = Space::size > 64;

// May an input refer to a sample? Up to four numbers are copied in fewer instructions.
template <class Space>
inline constexpr bool may_refer = is_large<Space> || (shows_in_place && Space::size > 4);

template <class Vector, bool MayRefer>
struct stored_elsewhere {
  const Vector* shown = nullptr;  // null: here
};
template <class Vector>
struct stored_elsewhere<Vector, false> {};

// Of a sample that is made from one.
template <class Space, int Given>
struct unfit_vector {
  static constexpr void tell(text& m) {
    m << "space.wrong_length: a sample of " << space_in_words<Space>() << " has " << Space::size
      << (Space::size == 1 ? " coordinate" : " coordinates") << " and is made from a vector of " << Given
      << ": give one number for each axis (an orientation and a pose have a quaternion)";
  }
};

}  // namespace detail

template <class Space>
class sample : public Space::domain::template methods<sample<Space>>,
               detail::stored_elsewhere<typename Space::vector_type, detail::may_refer<Space>> {
public:
  using space = Space;
  using vector_type = typename Space::vector_type;

  constexpr sample() {
    for (int i = 0; i < Space::size; ++i)
      value.coeffRef(i) = detail::zero_of<Space>[static_cast<std::size_t>(i)];
  }
  explicit sample(detail::to_be_filled) {}
  explicit constexpr sample(const vector_type& v, std::int64_t from = never) : time(from) { copy(v); }
  template <class Vector>
  explicit constexpr sample(const Eigen::MatrixBase<Vector>& v, std::int64_t from = never)
      : value(v), time(from) {}
  template <class Vector>
    requires detail::Unfit<Vector, Space::size>
  explicit constexpr sample(const Eigen::MatrixBase<Vector>&, std::int64_t = never) {
    static_assert(
        detail::holds_or_tells<false, detail::unfit_vector<Space, Vector::SizeAtCompileTime>>::value);
  }
  template <detail::Renames<Space> Other>
  constexpr sample(const sample<Other>& other) : time(other.origin()) {
    copy(other.vector());
  }
  constexpr sample(const sample& other)
      : Space::domain::template methods<sample<Space>>(),
        detail::stored_elsewhere<vector_type, detail::may_refer<Space>>(),
        time(other.time) {
    copy(other.vector());
  }
  constexpr sample& operator=(const sample& other) {
    copy(other.vector());
    if constexpr (detail::may_refer<Space>) this->shown = nullptr;
    time = other.time;
    return *this;
  }

  // Coordinates in the order of the axes, in the domain's units.
  constexpr const vector_type& vector() const {
    if constexpr (detail::may_refer<Space>)
      if (this->shown) return *this->shown;
    return value;
  }

  // Nanoseconds since beat 0; `never` for an initial value.
  constexpr std::int64_t origin() const { return time; }

  template <class Axis>
  constexpr double operator[](Axis) const {
    static_assert(detail::holds_or_tells<Space::axes::template contains<Axis>,
                                         detail::unknown_axis<Space, Axis>>::value);
    static_assert(
        detail::holds_or_tells<(Space::size == Space::axes::count || !Space::axes::template contains<Axis>),
                               detail::no_number_per_axis<Space>>::value);
    return vector().coeff(Space::axes::template index_of<Axis>);
  }

  template <class... Axes>
  constexpr auto on() const {
    static_assert(detail::holds_or_tells < Space::size == Space::axes::count,
                  detail::no_number_per_axis < Space >> ::value);
    if constexpr (Space::size == Space::axes::count) {
      Eigen::Matrix<double, sizeof...(Axes), 1> part;
      int i = 0;
      ((part.coeffRef(i++) = (*this)[Axes{}]), ...);
      return sample<sub_space<Space, Axes...>>(part, time);
    } else {
      return *this;
    }
  }

protected:
  // Until it is filled again. `from` has to outlive it.
  void refer_to(const vector_type& from)
    requires detail::may_refer<Space>
  {
    this->shown = &from;
  }

  vector_type value;
  std::int64_t time = never;

private:
  constexpr void copy(const vector_type& from) {
    if constexpr (Space::size <= 16)
      for (int i = 0; i < Space::size; ++i) value.coeffRef(i) = from.coeff(i);
    else value = from;
  }
};

}  // namespace cca
