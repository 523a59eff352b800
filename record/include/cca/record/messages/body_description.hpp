// A cca::body as values: its links with their joints, the ends of its parts, its axes. What is written of a
// robot for viewers is made of it (urdf.hpp, body_transforms.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include <cca/base/array_size.hpp>
#include <cca/base/type_name.hpp>
#include <cca/robot/body_pose.hpp>
#include <cca/space/limits.hpp>
#include <cca/space/quantity.hpp>

namespace cca::recording::detail {

struct described_axis {
  std::string name;
  double lower, upper;      // rad (prismatic: m); infinite: none
  double velocity, effort;  // the greatest absolute values
};

struct described_end {
  std::string name;  // of the frame in which a part ends
  int link = -1;     // -1: the base
  std::array<double, 3> at{};
  std::array<double, 4> turn{};  // x y z w
};

struct body_description {
  std::string base;  // the frame
  link_inertia base_inertia;
  std::vector<cca::detail::body_link> links;  // each after the one on which it hangs
  std::vector<std::string> names;             // of the links
  std::vector<described_end> ends;
  std::vector<described_axis> axes;  // the coordinates

  const std::string& name(int link) const { return link < 0 ? base : names[cca::detail::array_size(link)]; }
};

template <class Axis, class Quantity>
double greatest_limit() {
  const double lower = cca::detail::lower_limit_of<Axis, Quantity>,
               upper = cca::detail::upper_limit_of<Axis, Quantity>;
  return -lower > upper ? -lower : upper;
}

template <class Parts>
struct part_list;
template <class... Parts>
struct part_list<std::tuple<Parts...>> {
  template <class F>
  static void for_each(F f) {
    (f.template operator()<Parts>(), ...);
  }
};

template <Body Type>
body_description description_of() {
  body_description d;
  d.base = cca::detail::type_name<typename Type::base_frame>();
  d.base_inertia = cca::detail::base_inertia_of<Type>();
  const auto& tree = cca::detail::body_tree_of<Type>;
  d.links.assign(tree.links.begin(), tree.links.end());
  // "left_front_leg_2": the third link of a part. The tree has the links of a part in a row.
  d.names.resize(d.links.size());
  std::size_t i = 0;
  part_list<typename Type::parts>::for_each([&]<class Part>() {
    const auto& end = tree.ends[i++];
    const std::size_t count = Part::chain::joints.size();
    for (std::size_t n = 0; n < count; ++n)
      d.names[cca::detail::array_size(end.link) + 1 - count + n] =
          std::string(Part::name) + "_" + std::to_string(n);
    d.ends.push_back({std::string(cca::detail::type_name<typename Part::chain::tip_frame>()), end.link,
                      end.where.translation, end.where.rotation});
  });
  [&]<class... Axis>(const axes<Axis...>*) {
    (d.axes.push_back({std::string(Axis::name), cca::detail::lower_limit_of<Axis, angle>,
                       cca::detail::upper_limit_of<Axis, angle>, greatest_limit<Axis, velocity>(),
                       greatest_limit<Axis, torque>()}),
     ...);
  }(static_cast<const axes_of<Type>*>(nullptr));
  // Two parts may end in frames of the same name; names of links are unique.
  for (std::size_t n = 0; n < d.ends.size(); ++n)
    for (std::size_t other = 0; other < d.ends.size(); ++other)
      if (n != other && d.ends[n].name == d.ends[other].name) {
        d.ends[n].name = std::string(Type::attached::names[n]) + "_" + d.ends[n].name;
        break;
      }
  return d;
}

}  // namespace cca::recording::detail
