// Numbers that a component can't use: one policy for adaptive/, mapping/ and motor/.
//
//   an input is            state                       status        output
//   NaN or infinite        unchanged                   unreadable    the safe value that the header names
//   beyond its bound       goes on with the bound      clamped       goes on
//
// The status is out<"status", input_status_port>, or ode_status, whose last two states mean the same. A
// component that must stop a robot because of it: `cca::fault_when_unreadable` (unreadable_fault.hpp). The
// bound is `largest_input`, unless the header names another. Reason: no quantity of a robot in SI units comes
// near it, and products of a few such numbers still fit into a double. A number beyond it is an error of its
// writer; without a bound it would become infinite in a state and stay there.
//
// A component without a state may pass NaN on: then its header says so.
// Cost: a comparison per number, one branch. Laws: tests/laws/finite_laws.hpp. Why it is so:
// docs/decisions/0019-numbers-that-a-component-cant-use.md.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

#include <cca/base/math/reductions.hpp>
#include <cca/base/eigen.hpp>
#include <cca/space/methods/scalar.hpp>
#include <cca/space/sample.hpp>
#include <cca/space/space.hpp>

namespace cca {

enum class input_status : std::uint8_t { usable, clamped, unreadable };

struct input_axis : dimension<"input"> {};
struct input_status_port : space<status, axes<input_axis>> {};

inline constexpr double largest_input = 1e12;  // in the unit of the input

namespace detail {

// No coordinate is NaN or infinite. Costs a sum and a comparison.
template <class Vector>
inline bool all_finite(const Eigen::MatrixBase<Vector>& v) {
  return math::sum(v - v) == 0;
}

// A sample has arrived (no initial value) and it is finite.
template <class Port>
inline bool has_come(const Port& port) {
  return port.origin() != never && all_finite(port.vector());
}

// In the check() of parameters: numbers that keep products with inputs finite.
template <class Numbers>
inline std::string_view too_large(const Eigen::DenseBase<Numbers>& numbers, std::string_view complaint) {
  return numbers.derived().cwiseAbs().maxCoeff() > largest_input ? complaint : std::string_view();
}

// Reads the inputs of one firing and keeps the worst that it found.
class input_check {
public:
  // The vector, within the bounds. Each number that is not finite is returned as it is.
  template <class Vector>
  [[gnu::always_inline]] typename Vector::PlainObject operator()(const Eigen::MatrixBase<Vector>& v) {
    typename Vector::PlainObject x = v;
    if (!(x.array().abs() <= largest_input).all()) [[unlikely]]
      for (int i = 0; i < x.size(); ++i) x[i] = number(x[i]);
    return x;
  }
  [[gnu::always_inline]] double number(double x, double least = -largest_input, double most = largest_input) {
    if (x >= least && x <= most) [[likely]]
      return x;
    if (!std::isfinite(x)) {
      worst = input_status::unreadable;
      return x;
    }
    note_clamped();
    return x < least ? least : most;
  }

  // Something else was cut to what the component can do.
  void note_clamped() {
    if (worst == input_status::usable) worst = input_status::clamped;
  }

  bool unreadable() const { return worst == input_status::unreadable; }
  input_status get() const { return worst; }

private:
  input_status worst = input_status::usable;
};

}  // namespace detail
}  // namespace cca
