// Phases: points on a circle, in rad, one per axis. 0 and 2 pi are the same phase.
//
// A sample holds the number that it was given; `wrapped()` is that phase's number in [0, 2 pi). Every other
// method gives the same result for all numbers of the same phase. Source of mean and coherence: Mardia and
// Jupp, Directional Statistics, 2000, chapter 2 (mean direction and mean resultant length; the latter is the
// order parameter of coupled oscillators, Kuramoto 1984).
#pragma once

#include <cca/base/math.hpp>
#include <cca/space/messages/vector_argument.hpp>
#include <cca/space/methods/circle.hpp>
#include <cca/space/methods/linear.hpp>

namespace cca {

struct phase : detail::linear_domain {
  using quantity = angle;

  template <class Self>
  struct methods : detail::mixin<Self> {
    // Into [0, 2 pi).
    constexpr Self wrapped() const { return advanced(0.0); }

    // Adds `by` rad, the same on every axis or one number per axis. The result is wrapped.
    constexpr Self advanced(double by) const {
      auto v = this->self().vector();
      for (int i = 0; i < Self::space::size; ++i) v.coeffRef(i) = wrap_turn(v.coeff(i) + by);
      return Self(v, this->self().origin());
    }
    template <class Vector>
    constexpr Self advanced(const Eigen::MatrixBase<Vector>& by) const {
      using space = typename Self::space;
      auto v = this->self().vector();
      if constexpr (detail::takes_vector<"advanced", space, space::size, Vector>()) v += by;
      for (int i = 0; i < space::size; ++i) v.coeffRef(i) = wrap_turn(v.coeff(i));
      return Self(v, this->self().origin());
    }

    // From the other sample to this one the short way, each in (-pi, pi]: positive if this one leads.
    template <Sample Other>
    constexpr auto difference(const Other& from) const {
      auto v = this->self().vector();
      if constexpr (detail::combinable<Self, Other>())
        for (int i = 0; i < Self::space::size; ++i)
          v.coeffRef(i) = wrap_signed(v.coeff(i) - from.vector().coeff(i));
      return v;
    }

    // Along the shorter arc; between opposite phases, the arc on which the phase grows. The result is
    // wrapped.
    template <Sample To>
    constexpr Self interpolated(const To& to, double t) const {
      auto v = this->self().vector();
      if constexpr (detail::combinable<Self, To>())
        for (int i = 0; i < Self::space::size; ++i)
          v.coeffRef(i) = wrap_turn(v.coeff(i) + t * wrap_signed(to.vector().coeff(i) - v.coeff(i)));
      return Self(v, detail::older(this->self().origin(), to.origin()));
    }

    // Over the axes, in [0, 2 pi). Meaningless if the phases balance each other (coherence 0).
    double mean() const { return wrap_turn(math::atan2(sine(), cosine())); }

    // Over the axes: 1 if all are equal, 0 if they balance each other.
    double coherence() const { return math::hypot(sine(), cosine()) / Self::space::size; }

  private:
    double sine() const {
      double sum = 0;
      for (int i = 0; i < Self::space::size; ++i) sum += math::sin(this->self().vector().coeff(i));
      return sum;
    }
    double cosine() const {
      double sum = 0;
      for (int i = 0; i < Self::space::size; ++i) sum += math::cos(this->self().vector().coeff(i));
      return sum;
    }
  };
};

}  // namespace cca
