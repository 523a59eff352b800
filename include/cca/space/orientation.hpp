// Orientations: rotations in a frame, as unit quaternions in the order x, y, z, w. The zero is the identity.
//
//   struct trunk_attitude : cca::space<cca::orientation<world>, cca::axes<cca::x, cca::y, cca::z>,
//   cca::rate<1000>> {};
//
// `orientation<Frame>` is how something (a body, another frame) is turned in Frame: it turns Frame's axes
// into that thing's. `a * b` turns by b first, then by a, both about axes of Frame. `express(s)` takes a
// sample whose coordinates are along the axes of the thing, in a frame of its own, to Frame; it's the one
// operation that changes a frame. It has no value per axis; it's made with `from` (of Eigen::Quaterniond,
// Eigen::AngleAxisd), `about`, `from_roll_pitch_yaw`, `from_rotation_vector`;
// `Eigen::Quaterniond(o.vector())` is the way back. Preconditions: unit length, to rounding; `normalised()`
// sees to that. Errors: `frame.mismatch`. Sources: rotation.hpp.
#pragma once

#include <cca/space/cartesian.hpp>
#include <cca/space/rotation.hpp>
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

template <class Type> concept OrientationSample =
    Sample<Type> && is_orientation<typename Type::space::domain>;

// The domain type whose coordinates are along the axes of another frame.
template <class Domain, class In>
struct expressed_in;
template <class Frame, class In>
struct expressed_in<cartesian_position<Frame>, In> {
  using type = cartesian_position<In>;
};
template <class At, class Old, class In>
struct expressed_in<twist<At, Old>, In> {
  using type = twist<At, In>;
};
template <class At, class Old, class In>
struct expressed_in<wrench<At, Old>, In> {
  using type = wrench<At, In>;
};

template <class Type, class In>
using express =
    sample<with_domain<typename Type::space, typename expressed_in<typename Type::space::domain, In>::type>>;

// Three numbers are turned, and so is each three of six.
template <class Quaternion, class Vector>
Vector turned(const Quaternion& q, const Vector& v) {
  Vector result;
  for (int i = 0; i + 3 <= Vector::RowsAtCompileTime; i += 3)
    result.template segment<3>(i) = rotation::rotate(q, vector3(v.template segment<3>(i)));
  return result;
}

// By way of Self, so that a file without orientations compiles no vectors of three.
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
  static constexpr int width(int axes) {
    return axes == 3 ? 4 : throw "cca::orientation: its axes are axes<x, y, z>";
  }
  static constexpr double zero(int i, int) { return i == 3 ? 1 : 0; }

  template <class Self>
  struct methods : detail::mixin<Self> {
    using vector_3 = typename detail::spatial_types<Self>::vector;
    using matrix_3 = typename detail::spatial_types<Self>::matrix;

    static Self about(const vector_3& axis, double angle) { return Self(rotation::about(axis, angle)); }
    static Self from_roll_pitch_yaw(double roll, double pitch, double yaw) {
      return Self(rotation::from_roll_pitch_yaw<typename vector_3::Scalar>(roll, pitch, yaw));
    }
    static Self from_rotation_vector(const vector_3& v) { return Self(rotation::exp(v)); }
    // Of an Eigen::Quaterniond or an Eigen::AngleAxisd.
    template <class Rotation>
    static Self from(const Rotation& r) {
      if constexpr (requires { r.coeffs(); }) return Self(r.coeffs());
      else return about(r.axis(), r.angle());
    }

    // First b, then this one.
    template <detail::OrientationSample Other>
    Self operator*(const Other& b) const {
      static_assert(SameFrame<Frame, typename Other::space::domain::frame>,
                    "frame.mismatch: two orientations are composed that are rotations in different frames; "
                    "bring both into "
                    "one frame first (what is given along a thing's axes goes through `express(...)` of its "
                    "orientation)");
      return Self(rotation::product(this->self().vector(), b.vector()),
                  detail::older(this->self().origin(), b.origin()));
    }
    Self inverse() const { return Self(rotation::inverse(this->self().vector()), this->self().origin()); }
    Self normalised() const {
      return Self(rotation::normalised(this->self().vector()), this->self().origin());
    }

    // The one of its two quaternions with positive w.
    Self canonical() const { return Self(rotation::canonical(this->self().vector()), this->self().origin()); }

    // Of the rotation, and of the one between two: in [0, pi].
    double angle() const { return rotation::angle(this->self().vector()); }
    template <detail::OrientationSample Other>
    double angle_to(const Other& b) const {
      (void)detail::meet<Self, Other>();
      return rotation::angle(rotation::product(this->self().vector(), rotation::inverse(b.vector())));
    }

    // From the other one to this one the shorter way, as a rotation vector in Frame: b.plus(a.difference(b))
    // is a.
    template <detail::OrientationSample Other>
    vector_3 difference(const Other& from) const {
      (void)detail::meet<Self, Other>();
      return rotation::log(rotation::product(this->self().vector(), rotation::inverse(from.vector())));
    }
    // Turned on by a rotation vector in Frame; an angular velocity times a duration is one.
    Self plus(const vector_3& by) const {
      return Self(rotation::product(rotation::exp(by), this->self().vector()), this->self().origin());
    }
    vector_3 rotation_vector() const { return rotation::log(this->self().vector()); }

    // Slerp: the shorter way at constant angular velocity, this one at t = 0, `to` at t = 1.
    template <detail::OrientationSample To>
    Self interpolated(const To& to, double t) const {
      (void)detail::meet<Self, To>();
      return Self(rotation::slerp(this->self().vector(), to.vector(), t),
                  detail::older(this->self().origin(), to.origin()));
    }

    // It turns by roll about x, then by pitch about y, then by yaw about z, all axes of Frame.
    double roll() const { return rotation::roll(this->self().vector()); }    // (-pi, pi]
    double pitch() const { return rotation::pitch(this->self().vector()); }  // [-pi/2, pi/2]
    double yaw() const { return rotation::yaw(this->self().vector()); }      // (-pi, pi]

    matrix_3 matrix() const { return rotation::matrix(this->self().vector()); }

    // A vector, or a point about the origin of Frame, turned in Frame.
    vector_3 rotate(const vector_3& v) const { return rotation::rotate(this->self().vector(), v); }
    template <detail::PositionSample Position>
    auto rotate(const Position& p) const {
      static_assert(SameFrame<Frame, typename Position::space::domain::frame>,
                    "frame.mismatch: a position is rotated by an orientation of another frame; if the "
                    "position is given "
                    "along the axes of the thing whose orientation this is, `express(position)` takes it to "
                    "this frame");
      using result = sample<typename Position::space>;
      if constexpr (detail::spatial<Position>())
        return result(rotation::rotate(this->self().vector(), p.vector()),
                      detail::older(this->self().origin(), p.origin()));
      else return result(p.vector());
    }

    // A position, twist or wrench along the axes of the thing whose orientation this is: the same along those
    // of Frame. A position keeps its origin: the two frames share it (if they don't, it takes a pose).
    template <Sample Other>
    auto express(const Other& s) const {
      return detail::express<Other, Frame>(detail::turned(this->self().vector(), s.vector()),
                                           detail::older(this->self().origin(), s.origin()));
    }
  };
};

// The same rotation, to the last bit of a quaternion or of its opposite.
template <detail::OrientationSample A, detail::OrientationSample B>
bool operator==(const A& a, const B& b) {
  (void)detail::meet<A, B>();
  return rotation::canonical(a.vector()) == rotation::canonical(b.vector());
}

}  // namespace cca
