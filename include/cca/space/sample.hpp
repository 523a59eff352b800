// A sample is an immutable value of a space with its time of origin; it has the methods of its domain type.
// It is read by axis, `q[hip{}]`, or whole, `q.vector()`; `q.template on<hip>()` is the part along some axes.
#pragma once

#include <cstdint>
#include <limits>

#include <cca/space/space.hpp>

namespace cca {

// The time of origin of a value that no sample has replaced yet.
inline constexpr std::int64_t never = std::numeric_limits<std::int64_t>::lowest();

template <class Space>
class sample : public Space::domain::template methods<sample<Space>> {
public:
  using space = Space;
  using vector_type = typename Space::vector_type;

  constexpr sample() {
    for (int i = 0; i < Space::size; ++i) value[i] = detail::zero_of<Space>[static_cast<std::size_t>(i)];
  }
  template <class Vector>
  explicit constexpr sample(const Eigen::MatrixBase<Vector>& v, std::int64_t from = never) : value(v), time(from) {}

  // Coordinates in the order of the axes, in the domain's units.
  constexpr const vector_type& vector() const { return value; }

  // Nanoseconds since beat 0; `never` for an initial value.
  constexpr std::int64_t origin() const { return time; }

  template <class Axis>
  constexpr double operator[](Axis) const {
    static_assert(Space::axes::template contains<Axis>, "cca::sample: this space has no such axis");
    static_assert(Space::size == Space::axes::count, "cca::sample: this domain type has no value per axis");
    return value[Space::axes::template index_of<Axis>];
  }

  template <class... Axes>
  constexpr auto on() const {
    Eigen::Matrix<double, sizeof...(Axes), 1> part;
    int i = 0;
    ((part[i++] = (*this)[Axes{}]), ...);
    return sample<sub_space<Space, Axes...>>(part, time);
  }

protected:
  vector_type value;
  std::int64_t time = never;
};

}  // namespace cca
