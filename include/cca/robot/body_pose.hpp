// The position of all parts of a body: forward kinematics, Jacobians and the centre of mass, in the frame of
// the base of the body.
//
//   const cca::body_pose<oncilla_body> now(q);        q over axes_of<oncilla_body>, rad (prismatic: m)
//   now.tip<"left_front_leg">()                       position and orientation of the end of the part
//   now.jacobian<"left_front_leg">()                  6 x coordinates: angular velocity, then velocity of the
//                                                     origin of that end
//   now.centre_of_mass()                              of all links and the base, m
//
// An angle that is NaN or infinite makes each link behind it and the centre of mass not finite; nothing is
// kept.
// A pose is the sines and cosines of the angles (math/angles.hpp): the same bits on all machines, but not
// those of the C library. Joints of one angle, and of its negative, share them. Everything has fixed size;
// nothing allocates. Cost: about 80 instructions per angle.
#pragma once

#include <array>
#include <cstddef>

#include <cca/base/math/reductions.hpp>
#include <cca/mapping/kinematics.hpp>
#include <cca/robot/recorded/joint_values.hpp>
#include <cca/robot/recorded/placed_ends.hpp>

namespace cca {
namespace detail {

// The common centre of mass of all links and the base.
template <std::size_t Count>
vector3 centre_of_mass(const std::array<body_link, Count>& links,
                       const std::array<placed_link, Count>& placed,
                       const link_inertia& base) {
  double mass = base.mass;
  vector3 moment = base.mass * as_vector(base.centre);
  for (std::size_t i = 0; i < Count; ++i) {
    const auto& [m, centre, inertia] = links[i].inertia;
    mass += m;
    moment += m * (placed[i].frame.at + math::product(placed[i].frame.turn, as_vector(centre)));
  }
  return mass > 0 ? vector3(moment / mass) : vector3::Zero();
}

// All links, placed. It is a value: `links()[i]` is a copy.
template <std::size_t Count>
struct placed_links : std::array<placed_link, Count> {
  placed_link operator[](std::size_t i) const { return std::array<placed_link, Count>::operator[](i); }
};

}  // namespace detail

template <class Type>
class body_pose {
  static constexpr const auto& tree = detail::body_tree_of<Type>;
  static constexpr std::size_t count = tree.links.size();

public:
  static constexpr int size = axes_of<Type>::count;
  using vector_type = Eigen::Matrix<double, size, 1>;
  using jacobian_type = Eigen::Matrix<double, 6, size>;

  explicit body_pose(const vector_type& q) {
    values.take(q);
    if constexpr (keeps_links) place(kept);
  }

  template <fixed_string Part>
  rigid tip() const {
    using quantity = detail::recorded_tip<Type, number<Part>()>;
    if constexpr (!detail::is_recorded<quantity>()) {
      return end(number<Part>());
    } else {
      rigid found;
      detail::straight_line<quantity>::evaluate({found.turn.data(), found.at.data()}, joint_values());
      return found;
    }
  }

  template <fixed_string Part>
  jacobian_type jacobian() const {
    constexpr std::size_t i = number<Part>();
    jacobian_type j;
    using quantity = detail::recorded_jacobian<Type, i>;
    if constexpr (detail::is_recorded<quantity>()) {
      detail::straight_line<quantity>::evaluate({j.data()}, joint_values());
    } else {
      const auto& placed = links();
      detail::fill_jacobian(tree.links, placed, tree.ends[i].link, end(i, placed).at, j);
    }
    return j;
  }

  // Parts count in order of declaration.
  rigid end(std::size_t part) const { return end(part, links()); }

  Eigen::Matrix<double, 3, 1> centre_of_mass() const {
    using quantity = detail::recorded_centre_of_mass<Type>;
    if constexpr (detail::is_recorded<quantity>()) {
      Eigen::Matrix<double, 3, 1> centre;
      detail::straight_line<quantity>::evaluate({centre.data()}, joint_values());
      return centre;
    } else {
      return detail::centre_of_mass(tree.links, links(), detail::base_inertia_of<Type>());
    }
  }

  // Of the body's tree of links. Used by the dynamics, as are the joint values.
  decltype(auto) links() const {
    if constexpr (keeps_links) {
      return (kept);
    } else {
      detail::placed_links<count> placed;
      place(placed);
      return placed;
    }
  }
  const double* joint_values() const { return values.numbers; }

private:
  template <fixed_string Part>
  static constexpr std::size_t number() {
    constexpr int i = part_index<Type>(Part.view());
    static_assert(detail::holds_or_tells<(i >= 0), detail::unknown_part<Type, Part>>::value);
    return i < 0 ? 0 : static_cast<std::size_t>(i);
  }

  static rigid end(std::size_t part, const detail::placed_links<count>& placed) {
    const auto& e = tree.ends[part];
    return (e.link < 0 ? rigid{} : placed[static_cast<std::size_t>(e.link)].frame) * e.where;
  }

  void place(detail::placed_links<count>& placed) const {
    detail::place_turned_links(tree.links, [&](std::size_t i) { return values.turn_of(i); }, placed);
  }

  // A body of so many links that nothing of it is recorded needs them in each function.
  static constexpr bool keeps_links = count > detail::most_recorded_links;
  struct nothing {};

  detail::joint_values<Type> values;
  [[no_unique_address]] std::conditional_t<keeps_links, detail::placed_links<count>, nothing> kept;
};
template <class Type>
  requires(!Body<Type>)
class body_pose<Type> : public body_pose<typename detail::mended_body<Type>::type> {
  static_assert(detail::holds_or_tells<false, detail::no_body<Type>>::value);

public:
  using body_pose<typename detail::mended_body<Type>::type>::body_pose;
};

}  // namespace cca
