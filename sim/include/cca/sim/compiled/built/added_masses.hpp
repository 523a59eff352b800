// What the links of a compiled world weigh beside their description, which is constants in the code of its
// limbs (limb_code.hpp): the difference is added to their equations, where there is one.
//
// Along the axes of the base, about its origin: there the moments of mass of all that hangs on a joint are a
// sum. Forces: recursive Newton-Euler; M: composite bodies (Featherstone, Rigid Body Dynamics Algorithms,
// 2008, chapters 5 and 6). Cost: some hundred operations for each link; nothing where `exist()` is false.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/robot/model/body_factors.hpp>

namespace cca::sim::detail {

// Mass, mass times centre, second moments xx, yy, zz, xy, xz, yz.
template <class Real>
struct moments_at_base {
  Real mass{};
  triple<Real> first{};
  std::array<Real, 6> second{};

  constexpr moments_at_base& operator+=(const moments_at_base& b) {
    mass = mass + b.mass, first = first + b.first;
    for (std::size_t k = 0; k < 6; ++k) second[k] = second[k] + b.second[k];
    return *this;
  }
  // Of the link that these are of in its own frame, placed here.
  template <class Moments>
  static constexpr moments_at_base of(const Moments& own, const placed_frame<Real>& f) {
    moments_at_base m;
    m.mass = Real(own.mass);
    const triple<Real> arm = f.direction({Real(own.first[0]), Real(own.first[1]), Real(own.first[2])});
    m.first = arm + m.mass * f.at;
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = r; c < 3; ++c) {
        Real sum = f.at[r] * arm[c] + arm[r] * f.at[c] + m.mass * f.at[r] * f.at[c];
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t l = 0; l < 3; ++l) sum = sum + Real(own.at(k, l)) * f.axes[k][r] * f.axes[l][c];
        m.second[cca::detail::mass_moments::index(r, c)] = sum;
      }
    return m;
  }
  // The angular momentum of a turning about the origin.
  constexpr triple<Real> spin(const triple<Real>& w) const {
    const auto& [xx, yy, zz, xy, xz, yz] = second;
    return {(yy + zz) * w[0] - xy * w[1] - xz * w[2], (xx + zz) * w[1] - xy * w[0] - yz * w[2],
            (xx + yy) * w[2] - xz * w[0] - yz * w[1]};
  }
  // The moments and the force that a motion takes, given by its two parts at the origin.
  struct load {
    triple<Real> moment, force;
  };
  constexpr load of_motion(const triple<Real>& turning, const triple<Real>& linear) const {
    return {cross(first, linear) + spin(turning), mass * linear + cross(turning, first)};
  }
};

// Mass, mass times centre, second moments: of each lane its own.
template <class Number>
struct moments_in_lanes {
  Number mass{};
  std::array<Number, 3> first{};
  std::array<Number, 6> second{};

  constexpr const Number& at(std::size_t r, std::size_t c) const {
    return second[cca::detail::mass_moments::index(r, c)];
  }
  void take_lane(int k, const cca::detail::mass_moments& one) {
    mass.set(k, one.mass);
    for (std::size_t r = 0; r < first.size(); ++r) first[r].set(k, one.first[r]);
    for (std::size_t r = 0; r < second.size(); ++r) second[r].set(k, one.second[r]);
  }
};

template <class R, class Number = double>
class added_masses {
  using tree = compiled_tree<R>;
  static constexpr bool has_lanes = is_in_lanes<Number>;
  using moments = std::conditional_t<has_lanes, moments_in_lanes<Number>, cca::detail::mass_moments>;
  template <class, class>
  friend class added_masses;

public:
  constexpr added_masses() = default;
  // As `by` has it, in all lanes.
  explicit added_masses(const body_factors& by)
    requires has_lanes
  {
    const added_masses<R, double> one(by);
    for (int k = 0; k < Number::count; ++k) take_lane(k, one);
  }
  explicit added_masses(const body_factors& by)
    requires(!has_lanes)
  {
    if constexpr (tree::floats)
      base_ = times(by.mass_factor(-1) - 1, cca::detail::base_inertia_of<typename R::body>());
    mass_ = base_.mass;
    exist_ = by.mass_factor(-1) != 1 && tree::floats;
    for (std::size_t i = 0; i < tree::links; ++i) {
      const double more = by.mass_factor(static_cast<int>(i)) - 1;
      exist_ = exist_ || more != 0;
      const auto turn = cca::detail::transposed(tree::reduced.own[i]);
      auto origin = cca::detail::product(turn, tree::reduced.shift[i]);
      for (double& x : origin) x = -x;
      links_[i] = times(more, tree::described.links[i].inertia).seen_from(turn, origin);
      mass_ += links_[i].mass;
    }
  }

  // Of a robot in a lane. Where none has any, none are written. `take_lane` of each lane, in their order.
  void take_lane(int k, const added_masses<R, double>& one)
    requires has_lanes
  {
    const bool had = k > 0 && exist_;
    exist_ = had || one.exist_;
    if (!exist_) return;
    if (!had) links_ = {}, base_ = {}, mass_ = {};
    for (std::size_t i = 0; i < tree::links; ++i) links_[i].take_lane(k, one.links_[i]);
    base_.take_lane(k, one.base_), mass_.set(k, one.mass_);
  }

  bool exist() const { return exist_; }
  const Number& mass() const { return mass_; }

  // Mass times centre of all, in the base.
  template <class Real>
  triple<Real> first(const std::array<placed_frame<Real>, tree::links>& places) const {
    triple<Real> sum{Real(base_.first[0]), Real(base_.first[1]), Real(base_.first[2])};
    for (std::size_t i = 0; i < tree::links; ++i)
      sum = sum + moments_at_base<Real>::of(links_[i], places[i]).first;
    return sum;
  }

  // Adds to M and to the forces that motion and gravity leave (tree_equations::weigh).
  template <class Equations, class Speeds, class Real>
  void weigh(Equations& now,
             const Speeds& speeds,
             const triple<Real>& turning,
             const triple<Real>& up) const {
    using on = on_links<R, Real>;
    struct motion {
      triple<Real> w, turned, a;  // rad/s, rad/s^2, and m/s^2 of the origin of the link
    };
    std::array<motion, tree::links> moves;
    std::array<moments_at_base<Real>, tree::links> all;
    const motion root{turning, {}, up};
    for (std::size_t i = 0; i < tree::links; ++i) {
      const auto& l = tree::reduced.links[i];
      const auto& f = now.places()[i];
      const auto parent = static_cast<std::size_t>(l.parent);
      const motion& p = l.parent < 0 ? root : moves[parent];
      const triple<Real> arm = l.parent < 0 ? f.at : f.at - now.places()[parent].at;
      const triple<Real> own =
          (Real(l.ratio) * speeds[static_cast<std::size_t>(l.coordinate)]) * f.axes[l.axis];
      motion& m = moves[i];
      m = {p.w, p.turned, p.a + cross(p.turned, arm) + cross(p.w, cross(p.w, arm))};
      if (l.revolute) m.w = p.w + own, m.turned = p.turned + cross(p.w, own);
      else m.a = m.a + Real(2.0) * cross(p.w, own);
      all[i] = moments_at_base<Real>::of(links_[i], f);
      resist<on>(now, static_cast<int>(i), all[i], m.w, m.turned,
                 m.a - cross(m.turned, f.at) - cross(m.w, cross(m.w, f.at)));
    }
    moments_at_base<Real> whole = moments_at_base<Real>::of(base_, placed_frame<Real>{});
    if constexpr (tree::floats) resist<on>(now, -1, whole, turning, {}, up);

    for (std::size_t i = tree::links; i-- > 0;) {
      const auto& l = tree::reduced.links[i];
      if (l.parent >= 0) all[static_cast<std::size_t>(l.parent)] += all[i];
      else whole += all[i];
      const triple<Real> axis = Real(l.ratio) * now.places()[i].axes[l.axis];
      const auto load =
          l.revolute ? all[i].of_motion(axis, cross(now.places()[i].at, axis)) : all[i].of_motion({}, axis);
      const std::size_t own = on::row(l.coordinate);
      if constexpr (tree::floats)
        for (std::size_t k = 0; k < 3; ++k) {
          entry(now, own, k) = entry(now, own, k) + load.moment[k];
          entry(now, own, 3 + k) = entry(now, own, 3 + k) + load.force[k];
        }
      bool is_own = true;
      on::each_joint(now.places(), static_cast<int>(i),
                     [&](std::size_t r, const triple<Real>& u, const triple<Real>& at, bool turns) {
                       const Real x =
                           turns ? dot(u, load.moment - cross(at, load.force)) : dot(u, load.force);
                       Real& e = entry(now, own, r);
                       e = e + (r == own && !is_own ? x + x : x);
                       is_own = false;
                     });
    }
    if constexpr (tree::floats) {
      for (std::size_t k = 0; k < 3; ++k) {
        triple<Real> unit{};
        unit[k] = Real(1.0);
        const auto turned = whole.of_motion(unit, {}), moved = whole.of_motion({}, unit);
        for (std::size_t r = k; r < 3; ++r) {
          entry(now, r, k) = entry(now, r, k) + turned.moment[r];
          entry(now, 3 + r, 3 + k) = entry(now, 3 + r, 3 + k) + moved.force[r];
        }
        for (std::size_t r = 0; r < 3; ++r) entry(now, 3 + r, k) = entry(now, 3 + r, k) + turned.force[r];
      }
    }
  }

private:
  static cca::detail::mass_moments times(double factor, link_inertia of) {
    of.mass *= factor;
    for (double& x : of.about_centre) x *= factor;
    return cca::detail::mass_moments(of);
  }

  // What the motion of one link takes, at the origin of the base.
  template <class On, class Equations, class Real>
  static void resist(Equations& now,
                     int link,
                     const moments_at_base<Real>& of,
                     const triple<Real>& w,
                     const triple<Real>& turned,
                     const triple<Real>& a) {
    const auto load = of.of_motion(turned, a);
    const Real less(-1.0);
    On::add_wrench(now.places(), link, {}, less * (load.force + cross(w, cross(w, of.first))),
                   less * (load.moment + cross(w, of.spin(w))), now.forces);
  }
  // Of two rows that meet.
  template <class Equations>
  static auto& entry(Equations& now, std::size_t a, std::size_t b) {
    const std::size_t row = a > b ? a : b, column = a > b ? b : a;
    return now.mass.row(row)[static_cast<std::size_t>(tree::branches.depth[column])];
  }

  std::array<moments, tree::links> links_{};  // in the frames of the reduced links
  moments base_{};
  Number mass_{};
  bool exist_ = false;
};

}  // namespace cca::sim::detail
