// Orientations: rotations in a frame, as unit quaternions in the order x, y, z, w. The zero is the identity.
//
//   struct trunk_attitude
//       : cca::space<cca::orientation<world>, cca::axes<cca::x, cca::y, cca::z>, cca::rate<1000>> {};
//
// `orientation<Frame>` says how something (a body, another frame) is rotated in Frame: it rotates Frame's
// axes into that thing's axes. `a * b` rotates by b first, then by a, both about axes of Frame. `express(s)`
// takes a sample with coordinates along the thing's axes and gives it along those of Frame; no other
// operation changes a frame.
//
// Make one with `from` (of Eigen::Quaterniond, Eigen::AngleAxisd), `about`, `from_roll_pitch_yaw` or
// `from_rotation_vector`; the way back is `Eigen::Quaterniond(o.vector())`. It has no value per axis.
// Preconditions: unit length, to rounding; `normalised()` restores it. Errors: `frame.mismatch`.
// Sources: rotation.hpp.
#pragma once

#include <array>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/messages/vector_argument.hpp>
#include <cca/space/cartesian.hpp>
#include <cca/space/methods/rotation.hpp>
#include <cca/space/sample.hpp>

namespace cca {

template <class Frame>
struct orientation;
template <class At, class In>
struct twist;
template <class At, class In>
struct wrench;

namespace detail {

template <class Domain>
constexpr bool is_orientation = false;
template <class Frame>
constexpr bool is_orientation<orientation<Frame>> = true;

template <class A, class B>
struct orientations_in_two_frames {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: two orientations are composed that are rotations in different frames, "
      << type_name<A>() << " and " << type_name<B>()
      << "; bring both into one frame first (`express(...)` of the orientation of a thing takes what is "
         "given along its axes)";
  }
};
template <class Frame, class Position>
struct rotated_in_other_frame {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: a position of " << space_in_words<Position>()
      << " is rotated by an orientation of another frame, " << type_name<Frame>()
      << "; if the position is given along the axes of the thing whose orientation this is, use "
         "`express(position)`";
  }
};

template <class Type> concept OrientationSample =
    Sample<Type> && is_orientation<typename Type::space::domain>;

// The same domain type with its coordinates along the axes of another frame.
template <class Domain, class In>
struct expressed_in;
template <class Frame, class In>
struct expressed_in<cartesian_position<Frame>, In> {
  using type = cartesian_position<In>;
};
template <class Frame, class In>
struct expressed_in<cartesian_force<Frame>, In> {
  using type = cartesian_force<In>;
};
template <class At, class Old, class In>
struct expressed_in<twist<At, Old>, In> {
  using type = twist<At, In>;
};
template <class At, class Old, class In>
struct expressed_in<wrench<At, Old>, In> {
  using type = wrench<At, In>;
};

template <class Space> concept Expressible =
    Space::size % 3 == 0 && requires { typename expressed_in<typename Space::domain, void>::type; };

template <class Type, class In>
using express =
    sample<with_domain<typename Type::space, typename expressed_in<typename Type::space::domain, In>::type>>;

// Rotates each group of three numbers: one in a position, two in a twist or a wrench.
template <class Quaternion, class Vector>
Vector rotated(const Quaternion& q, const Vector& v) {
  Vector result;
  for (int i = 0; i + 3 <= Vector::RowsAtCompileTime; i += 3)
    result.template segment<3>(i) = rotation::rotate(q, vector3(v.template segment<3>(i)));
  return result;
}

// These depend on Self, so a file without orientations does not instantiate vectors of three.
template <class Self>
struct spatial_types {
  using vector = Eigen::Matrix<double, 3, 1>;
  using quaternion = Eigen::Matrix<double, 4, 1>;
  using matrix = Eigen::Matrix<double, 3, 3>;
};

}  // namespace detail

template <class Frame>
struct orientation {
  using quantity = angle;
  using frame = Frame;
  using frames = detail::frame_list<Frame>;
  static constexpr bool actuated = false;
  static constexpr std::array<std::string_view, 4> coordinates{"qx", "qy", "qz", "qw"};
  static constexpr std::array<std::string_view, 4> coordinate_units{};  // a quaternion has no unit
  static constexpr int axis_count = 3;
  static constexpr int width(int) { return 4; }
  static constexpr double zero(int i, int) { return i == 3 ? 1 : 0; }

  template <class Self>
  struct methods : detail::mixin<Self> {
    using vector_3 = typename detail::spatial_types<Self>::vector;
    using matrix_3 = typename detail::spatial_types<Self>::matrix;

    static Self about(const vector_3& axis, double angle) { return Self(rotation::about(axis, angle)); }
    static Self from_roll_pitch_yaw(double roll, double pitch, double yaw) {
      return Self(rotation::from_roll_pitch_yaw<typename vector_3::Scalar>(roll, pitch, yaw));
    }
    template <detail::Unfit<3> Vector>
    static Self about(const Eigen::MatrixBase<Vector>&, double) {
      (void)detail::takes_vector<"about", typename Self::space, 3, Vector>();
      return Self();
    }
    static Self from_rotation_vector(const vector_3& v) { return Self(rotation::exp(v)); }
    template <detail::Unfit<3> Vector>
    static Self from_rotation_vector(const Eigen::MatrixBase<Vector>&) {
      (void)detail::takes_vector<"from_rotation_vector", typename Self::space, 3, Vector>();
      return Self();
    }
    // From an Eigen::Quaterniond or an Eigen::AngleAxisd.
    template <class Rotation>
    static Self from(const Rotation& r) {
      if constexpr (requires { r.coeffs(); }) return Self(r.coeffs());
      else return about(r.axis(), r.angle());
    }

    // First rotates by b, then by this one.
    template <detail::OrientationSample Other>
    Self operator*(const Other& b) const {
      using other = typename Other::space::domain::frame;
      static_assert(detail::holds_or_tells<SameFrame<Frame, other>,
                                           detail::orientations_in_two_frames<Frame, other>>::value);
      return Self(rotation::product(this->self().vector(), b.vector()),
                  detail::older(this->self().origin(), b.origin()));
    }
    Self inverse() const { return Self(rotation::inverse(this->self().vector()), this->self().origin()); }
    Self normalised() const {
      return Self(rotation::normalised(this->self().vector()), this->self().origin());
    }

    // The same rotation with w positive: q and -q are the same rotation.
    Self canonical() const { return Self(rotation::canonical(this->self().vector()), this->self().origin()); }

    // The angle of this rotation, and of the rotation from b to this one: in [0, pi].
    double angle() const { return rotation::angle(this->self().vector()); }
    template <detail::OrientationSample Other>
    double angle_to(const Other& b) const {
      (void)detail::combinable<Self, Other>();
      return rotation::angle(rotation::product(this->self().vector(), rotation::inverse(b.vector())));
    }

    // From the other one to this one the shorter way, as a rotation vector in Frame:
    // b.plus(a.difference(b)) is a.
    template <detail::OrientationSample Other>
    vector_3 difference(const Other& from) const {
      (void)detail::combinable<Self, Other>();
      return rotation::log(rotation::product(this->self().vector(), rotation::inverse(from.vector())));
    }
    // Rotated further by a rotation vector in Frame, for example an angular velocity times a duration.
    Self plus(const vector_3& by) const {
      return Self(rotation::product(rotation::exp(by), this->self().vector()), this->self().origin());
    }
    template <detail::Unfit<3> Vector>
    Self plus(const Eigen::MatrixBase<Vector>&) const {
      (void)detail::takes_vector<"plus", typename Self::space, 3, Vector>();
      return this->self();
    }
    vector_3 rotation_vector() const { return rotation::log(this->self().vector()); }

    // Slerp: the shorter way at constant angular velocity; this one at t = 0, `to` at t = 1.
    template <detail::OrientationSample To>
    Self interpolated(const To& to, double t) const {
      (void)detail::combinable<Self, To>();
      return Self(rotation::slerp(this->self().vector(), to.vector(), t),
                  detail::older(this->self().origin(), to.origin()));
    }

    // Rotate by roll about x, then by pitch about y, then by yaw about z, all axes of Frame.
    CCA_INLINE double roll() const { return rotation::roll(this->self().vector()); }    // (-pi, pi]
    CCA_INLINE double pitch() const { return rotation::pitch(this->self().vector()); }  // [-pi/2, pi/2]
    CCA_INLINE double yaw() const { return rotation::yaw(this->self().vector()); }      // (-pi, pi]

    matrix_3 matrix() const { return rotation::matrix(this->self().vector()); }

    // Rotates a vector, or a point about the origin of Frame.
    vector_3 rotate(const vector_3& v) const { return rotation::rotate(this->self().vector(), v); }
    template <detail::Unfit<3> Vector>
    vector_3 rotate(const Eigen::MatrixBase<Vector>&) const {
      (void)detail::takes_vector<"rotate", typename Self::space, 3, Vector>();
      return rotation_vector();
    }
    template <detail::PositionSample Position>
    auto rotate(const Position& p) const {
      static_assert(
          detail::holds_or_tells<SameFrame<Frame, typename Position::space::domain::frame>,
                                 detail::rotated_in_other_frame<Frame, typename Position::space>>::value);
      using result = sample<typename Position::space>;
      if constexpr (detail::spatial<Position>())
        return result(rotation::rotate(this->self().vector(), p.vector()),
                      detail::older(this->self().origin(), p.origin()));
      else return result(p.vector());
    }

    // Takes a position, force, twist or wrench along the axes of the thing whose orientation this is, and
    // gives it along those of Frame. A position needs both frames to have the same origin; otherwise use a
    // pose.
    template <Sample Other>
    auto express(const Other& s) const {
      constexpr bool moves = detail::Expressible<typename Other::space>;
      static_assert(detail::holds_or_tells<moves, detail::not_spatial<typename Other::space>>::value);
      if constexpr (moves)
        return detail::express<Other, Frame>(detail::rotated(this->self().vector(), s.vector()),
                                             detail::older(this->self().origin(), s.origin()));
      else return s;
    }
  };
};

// The same rotation: the quaternions are equal or opposite, to the last bit.
template <detail::OrientationSample A, detail::OrientationSample B>
bool operator==(const A& a, const B& b) {
  (void)detail::combinable<A, B>();
  return rotation::canonical(a.vector()) == rotation::canonical(b.vector());
}

}  // namespace cca
