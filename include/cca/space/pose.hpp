// Poses: a position and an orientation in a frame, as seven numbers: x, y, z in m, then a unit quaternion x,
// y, z, w. The zero is the frame's own pose.
//
//   struct foot_pose : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
//
// `pose<Frame>` says where something (a body, another frame) is in Frame: it is the rigid motion that takes
// Frame to that thing. `a * b` moves by b first, then by a, both in Frame. `express(p)` takes a position in
// the frame of the thing to Frame. Preconditions: a quaternion of unit length, to rounding. Errors:
// `frame.mismatch`.
#pragma once

#include <array>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/messages/vector_argument.hpp>
#include <cca/space/orientation.hpp>

namespace cca {

template <class Frame>
struct pose;

namespace detail {

template <class Domain>
constexpr bool is_pose = false;
template <class Frame>
constexpr bool is_pose<pose<Frame>> = true;

template <class A, class B>
struct poses_in_two_frames {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: two poses are composed that are motions in different frames, " << type_name<A>()
      << " and " << type_name<B>()
      << "; bring both into one frame first (`express(...)` of the pose of a thing takes what is given in "
         "its frame)";
  }
};
template <class Frame, class Position, class Orientation>
struct pose_of_other_frame {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: a pose in " << type_name<Frame>()
      << " is made of a position and an orientation in its own frame, not of " << space_in_words<Position>()
      << " and " << space_in_words<Orientation>() << "; bring both there first, with `express(...)`";
  }
};
template <class Frame, class Position>
struct moved_in_other_frame {
  static constexpr void tell(text& m) {
    m << "frame.mismatch: a position of " << space_in_words<Position>()
      << " is moved by a pose of another frame, " << type_name<Frame>()
      << "; if the position is given in the frame of the thing whose pose this is, use `express(position)`";
  }
};

template <class Type> concept PoseSample = Sample<Type> && is_pose<typename Type::space::domain>;

}  // namespace detail

template <class Frame>
struct pose {
  using quantity = void;
  using frame = Frame;
  using frames = detail::frame_list<Frame>;
  static constexpr bool actuated = false;
  static constexpr std::array<std::string_view, 7> coordinates{"x", "y", "z", "qx", "qy", "qz", "qw"};
  static constexpr std::array<std::string_view, 7> coordinate_units{"m", "m", "m"};
  static constexpr int axis_count = 3;
  static constexpr int width(int) { return 7; }
  static constexpr double zero(int i, int) { return i == 6 ? 1 : 0; }

  template <class Self>
  struct methods : detail::mixin<Self> {
    using vector_3 = typename detail::spatial_types<Self>::vector;
    using vector_4 = typename detail::spatial_types<Self>::quaternion;

    // The pose's two parts, as samples.
    template <detail::PositionSample Position, detail::OrientationSample Orientation>
    static Self of(const Position& p, const Orientation& o) {
      static_assert(detail::holds_or_tells<(SameFrame<Frame, typename Position::space::domain::frame> &&
                                            SameFrame<Frame, typename Orientation::space::domain::frame>),
                                           detail::pose_of_other_frame<Frame, typename Position::space,
                                                                       typename Orientation::space>>::value);
      return make(p.vector(), o.vector(), detail::older(p.origin(), o.origin()));
    }
    auto position() const {
      return sample<with_domain<typename Self::space, cartesian_position<Frame>>>(translation(),
                                                                                  this->self().origin());
    }
    auto orientation() const {
      return sample<with_domain<typename Self::space, cca::orientation<Frame>>>(quaternion(),
                                                                                this->self().origin());
    }

    // First moves by b, then by this one.
    template <detail::PoseSample Other>
    Self operator*(const Other& b) const {
      using other = typename Other::space::domain::frame;
      static_assert(
          detail::holds_or_tells<SameFrame<Frame, other>, detail::poses_in_two_frames<Frame, other>>::value);
      return make(moved(vector_3(b.vector().template head<3>())),
                  rotation::product(quaternion(), vector_4(b.vector().template tail<4>())),
                  detail::older(this->self().origin(), b.origin()));
    }
    Self inverse() const {
      const vector_4 back = rotation::inverse(quaternion());
      return make(-rotation::rotate(back, translation()), back, this->self().origin());
    }

    // Moves a point of Frame within Frame.
    template <detail::PositionSample Position>
    auto transform(const Position& p) const {
      static_assert(
          detail::holds_or_tells<SameFrame<Frame, typename Position::space::domain::frame>,
                                 detail::moved_in_other_frame<Frame, typename Position::space>>::value);
      using result = sample<typename Position::space>;
      if constexpr (detail::spatial<Position>())
        return result(moved(p.vector()), detail::older(this->self().origin(), p.origin()));
      else return result(p.vector());
    }
    vector_3 transform(const vector_3& p) const { return moved(p); }
    template <detail::Unfit<3> Vector>
    vector_3 transform(const Eigen::MatrixBase<Vector>&) const {
      (void)detail::takes_vector<"transform", typename Self::space, 3, Vector>();
      return translation();
    }

    // Takes a position in the frame of the thing whose pose this is, and gives the same point in Frame.
    template <detail::PositionSample Position>
    auto express(const Position& p) const {
      (void)detail::spatial<Position>();
      return detail::express<Position, Frame>(moved(p.vector()),
                                              detail::older(this->self().origin(), p.origin()));
    }

    // The position on a straight line and the orientation by slerp, each at constant speed; not a screw
    // motion.
    template <detail::PoseSample To>
    Self interpolated(const To& to, double t) const {
      (void)detail::combinable<Self, To>();
      return make((1 - t) * translation() + t * to.vector().template head<3>(),
                  rotation::slerp(quaternion(), vector_4(to.vector().template tail<4>()), t),
                  detail::older(this->self().origin(), to.origin()));
    }

    // distance in m, angle_to in rad.
    template <detail::PoseSample Other>
    double distance(const Other& to) const {
      return position().distance(to.position());
    }
    template <detail::PoseSample Other>
    double angle_to(const Other& to) const {
      return orientation().angle_to(to.orientation());
    }

  private:
    static Self make(const vector_3& p, const vector_4& q, std::int64_t origin) {
      typename Self::space::vector_type v;
      for (int i = 0; i < 3; ++i) v.coeffRef(i) = p.coeff(i);
      for (int i = 0; i < 4; ++i) v.coeffRef(3 + i) = q.coeff(i);
      return Self(v, origin);
    }
    vector_3 translation() const { return this->self().vector().template head<3>(); }
    vector_4 quaternion() const { return this->self().vector().template tail<4>(); }
    vector_3 moved(const vector_3& p) const { return rotation::rotate(quaternion(), p) + translation(); }
  };
};

}  // namespace cca
