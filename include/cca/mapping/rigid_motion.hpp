// Rigid motions by a constant, as components: within one frame (transformations) and from one frame to
// another (mappings).
//
//   cca::translation_by<foot_in_hip, lifted>     translates by lifted::where, a cca::placement
//   cca::rotation_by<foot_in_hip, turned>        rotates about the origin of the frame
//   cca::rigid_motion<foot_in_hip, both>         rotates, then translates
//   cca::frame_change<hip_in_trunk, foot_in_hip, foot_in_trunk>
//                                                the same thing, in coordinates of another frame
//
//   in  "input"    Space (of a frame change: From)
//   out "output"   Space (of a frame change: To)
//
// Positions, orientations and poses are moved. Twists and wrenches are rotated to the axes of the new frame;
// if they act at the origin of the thing and the output at that of the other frame, they are moved to that
// point too. Positions over some of the axes x, y, z can be translated, not rotated. For a frame that moves,
// wire a pose and use `express`.
//
// It has no state: an angle or coordinate that is NaN or infinite makes the output of that firing NaN, which
// components with a state and limiters recognise (input_status.hpp).
//
// Errors: frame.mismatch, space.mismatch. Cost: a rotation by a constant. Source (motion of twists and
// wrenches): Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 2 (coordinate transforms of spatial
// vectors). Checked against them, written as 6 x 6 matrices. Example: tests/runtime/mapping/example.cpp.
#pragma once

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/component/port.hpp>
#include <cca/mapping/placement.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca {
namespace detail {

template <class Domain>
struct frame_along;  // the frame along whose axes the coordinates are
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
constexpr bool same_kind = false;
template <class A, class B>
constexpr bool same_kind<cartesian_position<A>, cartesian_position<B>> = true;
template <class A, class B>
constexpr bool same_kind<orientation<A>, orientation<B>> = true;
template <class A, class B>
constexpr bool same_kind<pose<A>, pose<B>> = true;
template <class A, class I, class B, class J>
constexpr bool same_kind<twist<A, I>, twist<B, J>> = true;
template <class A, class I, class B, class J>
constexpr bool same_kind<wrench<A, I>, wrench<B, J>> = true;

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

constexpr bool rotates(const placement& p) {
  return p.rotation[0] != 0 || p.rotation[1] != 0 || p.rotation[2] != 0;
}

// The coordinates of a position along those axes x, y, z that its space has.
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

// `Moved`: twists and wrenches are moved from the origin of the thing to that of the frame.
template <class Space, bool Moved>
typename Space::vector_type moved_by(const placement& where, const typename Space::vector_type& v) {
  using domain = typename Space::domain;
  const vector3 t = as_vector(where.translation);
  const vector4 q = as_vector(where.rotation);
  typename Space::vector_type result = v;
  if constexpr (same_kind<domain, cartesian_position<void>>) {
    if constexpr (Space::size == 3 && std::is_same_v<typename Space::axes, axes<x, y, z>>) {
      result = rotation::rotate(q, vector3(v)) + t;
    } else {
      using part = cartesian_part<typename Space::axes>;
      for (int i = 0; i < Space::size; ++i) result[i] += t[part::of[static_cast<std::size_t>(i)]];
    }
  } else if constexpr (same_kind<domain, orientation<void>>) {
    result = rotation::product(q, vector4(v));
  } else if constexpr (same_kind<domain, pose<void>>) {
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
  if constexpr (!same_kind<typename Space::domain, cartesian_position<void>>) return true;
  else
    return std::is_same_v<typename Space::axes, axes<x, y, z>> ||
           (cartesian_part<typename Space::axes>::named && !rotates(by));
}

}  // namespace detail

// A space of positions, orientations, poses, twists or wrenches.
template <class Type> concept CartesianSpace =
    requires { typename detail::frame_along<typename Type::domain>::type; };

namespace detail {

template <class Space>
struct not_movable {
  static constexpr void tell(text& m) {
    m << "space.mismatch: " << space_in_words<Space>()
      << " can not be moved so: a rigid motion and a frame change move positions along the axes x, y and z, "
         "and rotate them only over all three, axes<x, y, z>";
  }
};
template <class Space, class By>
struct moves_acting_point {
  static constexpr void tell(text& m) {
    m << "space.mismatch: the placement " << type_name<By>()
      << " also translates, and a rigid motion only rotates what acts at a point, as a sample of "
      << space_in_words<Space>() << "; `cca::frame_change` moves that point";
  }
};
// In functions; mapping.hpp says why.
template <class Space, class By>
constexpr auto check_motion() {
  static_assert(holds_or_tells<movable<Space>(By::where), not_movable<Space>>::value);
  static_assert(holds_or_tells<(std::is_void_v<typename acting<typename Space::domain>::at> ||
                                By::where.translation == placement{}.translation),
                               moves_acting_point<Space, By>>::value);
}

template <class Where, class From, class To>
struct frame_change_facts {
  using from = typename From::domain;
  using to = typename To::domain;
  using from_at = typename acting<from>::at;
  using to_at = typename acting<to>::at;
  static constexpr bool kind = same_kind<from, to> && std::is_same_v<typename From::axes, typename To::axes>;
  static constexpr bool starts = SameFrame<typename frame_along<from>::type, typename Where::thing>;
  static constexpr bool ends = SameFrame<typename frame_along<to>::type, typename Where::frame>;
  static constexpr bool stays = std::is_same_v<from_at, to_at>;
  static constexpr bool moves =
      std::is_same_v<from_at, typename Where::thing> && std::is_same_v<to_at, typename Where::frame>;
};

// What is wrong with a frame change: of the first mistake.
template <class Where, class From, class To>
struct bad_frame_change {
  static constexpr void tell(text& m) {
    using facts = frame_change_facts<Where, From, To>;
    if (!facts::kind) {
      m << "space.mismatch: a frame change keeps the axes and the domain type, only the frame changes, but "
           "this one leads from "
        << space_in_words<From>() << " to " << space_in_words<To>();
      return;
    }
    m << "frame.mismatch: this frame change places " << type_name<typename Where::thing>() << " in "
      << type_name<typename Where::frame>();
    if (!facts::starts)
      m << ", so it takes what is given in " << type_name<typename Where::thing>() << ", but its input is "
        << space_in_words<From>()
        << "; place that frame, or put a frame change to the placed frame in between";
    else if (!facts::ends)
      m << ", so its output is given in " << type_name<typename Where::frame>() << ", but is "
        << space_in_words<To>() << "; `cca::inverse_of` a placement leads the other way";
    else
      m << ": it moves a twist or a wrench from the origin of the one to that of the other, or keeps its "
           "point; its output, "
        << space_in_words<To>() << ", acts at another point";
  }
};

template <class Where, class From, class To>
constexpr auto check_frame_change() {
  using facts = frame_change_facts<Where, From, To>;
  constexpr bool fits = facts::kind && facts::starts && facts::ends && (facts::stays || facts::moves);
  static_assert(holds_or_tells<fits, bad_frame_change<Where, From, To>>::value);
  static_assert(holds_or_tells<(!facts::kind || movable<From>(Where::where)), not_movable<From>>::value);
}

template <class By, bool Rotates>
struct moves_otherwise {
  static constexpr void tell(text& m) {
    m << (Rotates ? "cca::rotation_by: the placement " : "cca::translation_by: the placement ")
      << type_name<By>() << (Rotates ? " also translates" : " also rotates") << "; use `cca::rigid_motion`";
  }
};
template <class By>
constexpr auto check_translation() {
  static_assert(holds_or_tells<!rotates(By::where), moves_otherwise<By, false>>::value);
}
template <class By>
constexpr auto check_rotation() {
  static_assert(
      holds_or_tells<(By::where.translation == placement{}.translation), moves_otherwise<By, true>>::value);
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
