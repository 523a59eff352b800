// Rigid motions by a constant, as components: within one frame (transformations), and from one frame to
// another (mappings).
//
//   cca::translation_by<foot_in_hip, lifted>               moves what lies in the space: lifted::where is a
//   cca::placement cca::rotation_by<foot_in_hip, turned>                  turns it about the frame's origin
//   cca::rigid_motion<foot_in_hip, both>                   turns, then moves
//   cca::frame_change<hip_in_trunk, foot_in_hip, foot_in_trunk>      the same thing, in coordinates of
//   another frame
//
// in "input", out "output". Positions, orientations and poses are moved. Twists and wrenches are turned along
// the axes of the new frame; and if they act at the thing's origin and the output says the other frame's,
// they're moved to that point, too. Positions over a part of the axes can be translated, not turned. A frame
// that moves is a pose on a wire: `express` of it.
//
// Errors: frame.mismatch. Cost: a rotation by a constant. Source of the motion of twists and wrenches:
// Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 2 (coordinate transforms of spatial vectors).
// Checked against them, written as matrices of six rows. Example: tests/runtime/mapping/example.cpp.
#pragma once

#include <cca/component/port.hpp>
#include <cca/mapping/placement.hpp>
#include <cca/space/domain.hpp>

namespace cca {
namespace detail {

template <class Domain>
struct frame_along;  // along whose axes the coordinates are
template <class Frame>
struct frame_along<cartesian_position<Frame>> {
  using type = Frame;
};
template <class Frame>
struct frame_along<orientation<Frame>> {
  using type = Frame;
};
template <class Frame>
struct frame_along<pose<Frame>> {
  using type = Frame;
};
template <class At, class In>
struct frame_along<twist<At, In>> {
  using type = In;
};
template <class At, class In>
struct frame_along<wrench<At, In>> {
  using type = In;
};

template <class Domain, class Other>
constexpr bool one_kind = false;
template <class A, class B>
constexpr bool one_kind<cartesian_position<A>, cartesian_position<B>> = true;
template <class A, class B>
constexpr bool one_kind<orientation<A>, orientation<B>> = true;
template <class A, class B>
constexpr bool one_kind<pose<A>, pose<B>> = true;
template <class A, class I, class B, class J>
constexpr bool one_kind<twist<A, I>, twist<B, J>> = true;
template <class A, class I, class B, class J>
constexpr bool one_kind<wrench<A, I>, wrench<B, J>> = true;

template <class Domain>
struct acting {
  using at = void;
};
template <class At, class In>
struct acting<twist<At, In>> {
  using at = At;
};
template <class At, class In>
struct acting<wrench<At, In>> {
  using at = At;
};

constexpr bool turns(const placement& p) {
  return p.rotation[0] != 0 || p.rotation[1] != 0 || p.rotation[2] != 0;
}

// A position, along those of the axes x, y, z that its space has.
template <class Axes>
struct cartesian_part;
template <class... Axes>
struct cartesian_part<axes<Axes...>> {
  static constexpr int index(std::string_view name) {
    return name == x::name ? 0 : name == y::name ? 1 : name == z::name ? 2 : -1;
  }
  static constexpr std::array<int, sizeof...(Axes)> of{index(Axes::name)...};
  static constexpr bool named = ((index(Axes::name) >= 0) && ...);
};

// `Moved`: twists and wrenches are moved from the thing's origin to the frame's.
template <class Space, bool Moved>
typename Space::vector_type moved_by(const placement& where, const typename Space::vector_type& v) {
  using domain = typename Space::domain;
  const vector3 t = as_vector(where.translation);
  const vector4 q = as_vector(where.rotation);
  typename Space::vector_type result = v;
  if constexpr (one_kind<domain, cartesian_position<void>>) {
    if constexpr (Space::size == 3 && std::is_same_v<typename Space::axes, axes<x, y, z>>) {
      result = rotation::rotate(q, vector3(v)) + t;
    } else {
      using part = cartesian_part<typename Space::axes>;
      for (int i = 0; i < Space::size; ++i) result[i] += t[part::of[static_cast<std::size_t>(i)]];
    }
  } else if constexpr (one_kind<domain, orientation<void>>) {
    result = rotation::product(q, vector4(v));
  } else if constexpr (one_kind<domain, pose<void>>) {
    result.template head<3>() = rotation::rotate(q, vector3(v.template head<3>())) + t;
    result.template tail<4>() = rotation::product(q, vector4(v.template tail<4>()));
  } else {
    vector3 first = rotation::rotate(q, vector3(v.template head<3>()));
    vector3 second = rotation::rotate(q, vector3(v.template tail<3>()));
    if constexpr (Moved && is_twist<domain>) second += rotation::cross(t, first);
    else if constexpr (Moved) first += rotation::cross(t, second);
    result.template head<3>() = first;
    result.template tail<3>() = second;
  }
  return result;
}

template <class Space>
constexpr bool movable(const placement& by) {
  if constexpr (!one_kind<typename Space::domain, cartesian_position<void>>) return true;
  else
    return std::is_same_v<typename Space::axes, axes<x, y, z>> ||
           (cartesian_part<typename Space::axes>::named && !turns(by));
}

}  // namespace detail

// A space of positions, orientations, poses, twists or wrenches.
template <class Type> concept CartesianSpace =
    requires { typename detail::frame_along<typename Type::domain>::type; };

namespace detail {

// In functions, for the reason that stands in mapping.hpp.
template <class Space, class By>
constexpr auto check_motion() {
  static_assert(movable<Space>(By::where),
                "space.mismatch: a rigid motion moves positions along the axes x, y and z, and turns them "
                "only over all three, "
                "axes<x, y, z>");
  static_assert(std::is_void_v<typename acting<typename Space::domain>::at> ||
                    By::where.translation == placement{}.translation,
                "cca::rigid_motion: twists and wrenches are turned by it, not translated: "
                "`cca::frame_change` moves the point that "
                "they act at");
}

template <class Where, class From, class To>
struct frame_change_facts {
  using from = typename From::domain;
  using to = typename To::domain;
  using from_at = typename acting<from>::at;
  using to_at = typename acting<to>::at;
  static constexpr bool kind = one_kind<from, to> && std::is_same_v<typename From::axes, typename To::axes>;
  static constexpr bool starts = SameFrame<typename frame_along<from>::type, typename Where::thing>;
  static constexpr bool ends = SameFrame<typename frame_along<to>::type, typename Where::frame>;
  static constexpr bool stays = std::is_same_v<from_at, to_at>;
  static constexpr bool moves =
      std::is_same_v<from_at, typename Where::thing> && std::is_same_v<to_at, typename Where::frame>;
};

template <class Where, class From, class To>
constexpr auto check_frame_change() {
  using facts = frame_change_facts<Where, From, To>;
  static_assert(facts::kind,
                "space.mismatch: a frame change keeps the domain type, but for its frames, and the axes");
  static_assert(
      !facts::kind || SameFrame<typename frame_along<typename From::domain>::type, typename Where::thing>,
      "frame.mismatch: this frame change takes what is given in the frame that it places, and its input is "
      "given in "
      "another one; place that one, or put the frame change in between that leads there");
  static_assert(!facts::kind || !facts::starts ||
                    SameFrame<typename frame_along<typename To::domain>::type, typename Where::frame>,
                "frame.mismatch: this frame change gives what is expressed in the frame in which it places "
                "the other one, and its "
                "output is to be in a third; `cca::inverse_of` a placement leads the other way");
  static_assert(!facts::kind || !facts::starts || !facts::ends || facts::stays || facts::moves,
                "frame.mismatch: a frame change moves a twist or a wrench from the origin of the frame that "
                "it places to the origin "
                "of the other one, or leaves its point as it is; this output is to act at another point");
  static_assert(!facts::kind || movable<From>(Where::where),
                "space.mismatch: a frame change moves positions along the axes x, y and z, and turns them "
                "only over all three, "
                "axes<x, y, z>");
}

template <class By>
constexpr auto check_translation() {
  static_assert(!turns(By::where), "cca::translation_by: this one also turns; that is a `cca::rigid_motion`");
}
template <class By>
constexpr auto check_rotation() {
  static_assert(By::where.translation == placement{}.translation,
                "cca::rotation_by: this one also translates; that is a `cca::rigid_motion`");
}

}  // namespace detail

template <CartesianSpace Space, class By>
struct rigid_motion {
  using checked = decltype(detail::check_motion<Space, By>());
  auto process(in<"input", Space> input) -> out<"output", Space> {
    return detail::moved_by<Space, false>(By::where, input.vector());
  }
};

template <CartesianSpace Space, class By>
struct translation_by : rigid_motion<Space, By> {
  using checked_too = decltype(detail::check_translation<By>());
};

template <CartesianSpace Space, class By>
struct rotation_by : rigid_motion<Space, By> {
  using checked_too = decltype(detail::check_rotation<By>());
};

template <Placed Where, CartesianSpace From, CartesianSpace To>
struct frame_change {
  using checked = decltype(detail::check_frame_change<Where, From, To>());
  auto process(in<"input", From> input) -> out<"output", To> {
    using facts = detail::frame_change_facts<Where, From, To>;
    if constexpr (facts::kind) return detail::moved_by<From, !facts::stays>(Where::where, input.vector());
    else return {};
  }
};

}  // namespace cca
