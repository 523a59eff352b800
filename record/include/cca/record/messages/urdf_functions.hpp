// The functions that write a body as URDF. urdf.hpp includes this, unless they are compiled once for the
// program (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <cca/record/messages/body_description.hpp>
#include <cca/record/messages/urdf.hpp>

namespace cca::recording::detail {

class urdf_writer {
public:
  explicit urdf_writer(const body_description& of) : d(of) { text.imbue(std::locale::classic()); }

  std::string write(std::string_view robot) {
    text.precision(12);
    text << "<?xml version=\"1.0\"?>\n<robot name=\"" << escaped(robot) << "\">\n";
    link(-1, d.base_inertia);
    for (std::size_t i = 0; i < d.links.size(); ++i) {
      link(static_cast<int>(i), d.links[i].inertia);
      joint(i);
    }
    for (const described_end& end : d.ends) {
      text << "  <link name=\"" << escaped(end.name) << "\"/>\n";
      begin_joint(end.name + "_fixed", "fixed", end.link, end.name, end.at, end.turn);
      text << "  </joint>\n";
    }
    text << "</robot>\n";
    return text.str();
  }

private:
  static std::string escaped(std::string_view name) {
    std::string all;
    for (const char c : name) {
      if (c == '<') all += "&lt;";
      else if (c == '&') all += "&amp;";
      else if (c == '"') all += "&quot;";
      else all += c;
    }
    return all;
  }
  std::ostringstream& numbers(const std::array<double, 3>& v) {
    text << v[0] + 0.0 << ' ' << v[1] + 0.0 << ' ' << v[2] + 0.0;  // no -0
    return text;
  }
  // Roll, pitch, yaw.
  static std::array<double, 3> angles_of(const std::array<double, 4>& q) {
    const auto [x, y, z, w] = q;
    const double sine = std::clamp(2 * (w * y - z * x), -1.0, 1.0);
    if (std::abs(sine) > 1 - 1e-12) return {0, std::asin(sine), std::copysign(2.0, -sine) * std::atan2(x, w)};
    return {std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), std::asin(sine),
            std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))};
  }
  void origin(const std::array<double, 3>& at, const std::array<double, 4>& turn = {0, 0, 0, 1}) {
    text << "    <origin xyz=\"";
    numbers(at) << "\" rpy=\"";
    numbers(angles_of(turn)) << "\"/>\n";
  }

  void link(int number, const link_inertia& of) {
    text << "  <link name=\"" << escaped(d.name(number)) << "\">\n";
    if (of.mass > 0) {
      const auto& i = of.about_centre;
      text << "    <inertial>\n";
      origin(of.centre);
      text << "    <mass value=\"" << of.mass << "\"/>\n    <inertia ixx=\"" << i[0] << "\" iyy=\"" << i[1]
           << "\" izz=\"" << i[2] << "\" ixy=\"" << i[3] << "\" ixz=\"" << i[4] << "\" iyz=\"" << i[5]
           << "\"/>\n    </inertial>\n";
    }
    double thickest = 0;
    for (std::size_t child = 0; child < d.links.size(); ++child)
      if (d.links[child].parent == number) thickest = std::max(thickest, rod(d.links[child].at));
    for (const described_end& end : d.ends)
      if (end.link == number) thickest = std::max(thickest, rod(end.at));
    text << "    <visual>\n    <geometry><sphere radius=\"" << 1.2 * std::max(thickest, 0.005)
         << "\"/></geometry>\n    </visual>\n  </link>\n";
  }
  // A cylinder from the origin of a link to a point. Its radius.
  double rod(const std::array<double, 3>& to) {
    const double length = std::hypot(to[0], to[1], to[2]);
    if (length < 1e-6) return 0;
    const double radius = std::clamp(0.12 * length, 0.005, 0.04);
    text << "    <visual>\n";
    // From z to the direction of the rod: pitch, then yaw.
    text << "    <origin xyz=\"";
    numbers({to[0] / 2, to[1] / 2, to[2] / 2})
        << "\" rpy=\"0 " << std::acos(std::clamp(to[2] / length, -1.0, 1.0)) << ' '
        << (std::hypot(to[0], to[1]) < 1e-9 ? 0 : std::atan2(to[1], to[0]))
        << "\"/>\n    <geometry><cylinder radius=\"" << radius << "\" length=\"" << length
        << "\"/></geometry>\n    </visual>\n";
    return radius;
  }

  void begin_joint(const std::string& name,
                   std::string_view type,
                   int parent,
                   const std::string& child,
                   const std::array<double, 3>& at,
                   const std::array<double, 4>& turn) {
    text << "  <joint name=\"" << escaped(name) << "\" type=\"" << type << "\">\n    <parent link=\""
         << escaped(d.name(parent)) << "\"/>\n    <child link=\"" << escaped(child) << "\"/>\n";
    origin(at, turn);
  }
  // The first joint that follows an axis as it is, or against it, is that of the axis.
  bool is_first(std::size_t i) const {
    const auto leads = [&](const auto& l) { return std::abs(l.ratio) == 1 && l.rest == 0; };
    for (std::size_t before = 0; before < i; ++before)
      if (d.links[before].coordinate == d.links[i].coordinate && leads(d.links[before])) return false;
    return leads(d.links[i]);
  }
  void joint(std::size_t i) {
    const auto& l = d.links[i];
    const described_axis& axis = d.axes[cca::detail::array_size(l.coordinate)];
    const bool leads = is_first(i);
    const bool is_bounded = axis.upper < std::numeric_limits<double>::infinity() &&
                            axis.lower > -std::numeric_limits<double>::infinity();
    const bool slides = l.kind == joint_kind::prismatic;
    Eigen::Map<const matrix3> turn(l.turn.data());
    const auto q = cca::detail::quaternion_of(turn);
    begin_joint(leads ? axis.name : axis.name + "_" + d.names[i],
                slides       ? "prismatic"
                : is_bounded ? "revolute"
                             : "continuous",
                l.parent, d.names[i], l.at, {q[0], q[1], q[2], q[3]});
    const double sign = leads ? l.ratio : 1;
    text << "    <axis xyz=\"";
    numbers({sign * l.axis[0], sign * l.axis[1], sign * l.axis[2]}) << "\"/>\n";
    double ends[] = {axis.lower, axis.upper};
    if (!leads)
      for (double& end : ends) end = l.ratio * end + l.rest;
    if (is_bounded || slides) {
      const auto finite = [](double x, double instead) { return std::isfinite(x) ? x : instead; };
      text << "    <limit lower=\"" << finite(std::min(ends[0], ends[1]), -1e3) << "\" upper=\""
           << finite(std::max(ends[0], ends[1]), 1e3) << "\" effort=\"" << finite(axis.effort, 1e3)
           << "\" velocity=\"" << finite(axis.velocity, 1e3) << "\"/>\n";
    }
    if (!leads)
      text << "    <mimic joint=\"" << escaped(axis.name) << "\" multiplier=\"" << l.ratio << "\" offset=\""
           << l.rest << "\"/>\n";
    text << "  </joint>\n";
  }

  const body_description& d;
  std::ostringstream text;
};

CCA_RECORD_INLINE std::string urdf_of(const body_description& d, std::string_view robot) {
  return urdf_writer(d).write(robot);
}

}  // namespace cca::recording::detail
