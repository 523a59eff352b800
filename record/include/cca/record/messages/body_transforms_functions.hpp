// The functions of messages that say where the links of a body are. body_transforms.hpp includes this, unless
// they are compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <cca/record/messages/body_transforms.hpp>

namespace cca::recording::detail {

CCA_RECORD_INLINE std::string transforms_schema() {
  std::string all = "geometry_msgs/TransformStamped[] transforms\n";
  const auto add = [&](std::string_view name, std::string_view fields) {
    all.append(80, '=').append("\nMSG: ").append(name).append("\n").append(fields);
  };
  add("geometry_msgs/TransformStamped",
      "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n");
  add("std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n");
  add("builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n");
  add("geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n");
  add("geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n");
  add("geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n");
  return all;
}

CCA_RECORD_INLINE body_transforms::body_transforms(body_description of, std::string turns_in)
    : d(std::move(of)),
      world(std::move(turns_in)),
      memory(256 + 512 * (d.links.size() + d.ends.size() + 1)) {}

CCA_RECORD_INLINE std::span<const unsigned char> body_transforms::made_of(const double* angles,
                                                                          const double* base,
                                                                          std::int64_t stamp) {
  cdr_writer to(memory);
  const bool has_world = base && !world.empty();
  to.add(static_cast<std::uint32_t>(d.links.size() + d.ends.size() + has_world));
  constexpr std::array<double, 3> origin{};
  if (has_world) add(to, stamp, world, d.base, origin, {base[0], base[1], base[2], base[3]});
  for (std::size_t i = 0; i < d.links.size(); ++i) {
    const auto& l = d.links[i];
    matrix3 turn = Eigen::Map<const matrix3>(l.turn.data());
    std::array<double, 3> at = l.at;
    const double angle = l.ratio * angles[l.coordinate] + l.rest;
    if (l.kind == joint_kind::revolute) {
      cca::detail::turn_about(turn, l, angle);
    } else {
      const Eigen::Vector3d moved = angle * (turn * cca::detail::as_vector(l.axis));
      for (std::size_t c = 0; c < 3; ++c) at[c] += moved[static_cast<int>(c)];
    }
    const auto q = cca::detail::quaternion_of(turn);
    add(to, stamp, d.name(l.parent), d.names[i], at, {q[0], q[1], q[2], q[3]});
  }
  for (const described_end& end : d.ends) add(to, stamp, d.name(end.link), end.name, end.at, end.turn);
  return to.view();
}

CCA_RECORD_INLINE void body_transforms::add(cdr_writer& to,
                                            std::int64_t stamp,
                                            std::string_view parent,
                                            std::string_view child,
                                            const std::array<double, 3>& at,
                                            const std::array<double, 4>& turn) {
  to.add(static_cast<std::int32_t>(stamp / 1'000'000'000));
  to.add(static_cast<std::uint32_t>(stamp % 1'000'000'000)).add(parent).add(child);
  for (const double x : at) to.add(x);
  for (const double x : turn) to.add(x);
}

}  // namespace cca::recording::detail
