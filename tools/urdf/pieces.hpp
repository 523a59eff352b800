// The pieces of a header: numbers, placements, joints, inertias, drives and shapes as C++.
#pragma once

#include <string>
#include <vector>

#include "bodies.hpp"

namespace cca_urdf {

// Text of a file in a comment: no end of line gets out of it.
inline std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\\') c = ' ';
  return text;
}

inline std::string placement_text(const std::vector<origin>& steps) {
  std::string all;
  const auto add = [&](const std::string& factor) { all += (all.empty() ? "" : " * ") + factor; };
  for (const origin& o : steps) {
    if (o.xyz != std::array<double, 3>{}) add("cca::at(" + list_of(o.xyz) + ")");
    for (const std::size_t k : {2, 1, 0})
      if (o.rpy[k] != 0)
        add("cca::turned_about(cca::along_" + std::string(1, static_cast<char>('x' + k)) + ", " +
            text_of(o.rpy[k]) + ")");
  }
  return all.empty() ? "cca::placement{}" : all;
}

inline std::string joint_text(const joint& j, const std::vector<origin>& steps) {
  const std::array<double, 3>& a = j.axis;
  std::string axis = "{" + list_of(a) + "}";
  if (a == std::array<double, 3>{1, 0, 0}) axis = "cca::along_x";
  if (a == std::array<double, 3>{0, 1, 0}) axis = "cca::along_y";
  if (a == std::array<double, 3>{0, 0, 1}) axis = "cca::along_z";
  return std::string("cca::") + (j.type == joint_type::prismatic ? "prismatic" : "revolute") + "(" + axis +
         ", " + placement_text(steps) + ")";
}

inline std::string inertia_text(const mass_of_link& m, const std::string& name = "") {
  const auto& i = m.about_centre;
  if (!(m.mass > 0)) return "cca::link_inertia" + name + "{}";
  return "cca::link_inertia" + name + "{" + text_of(m.mass) + ", {" + list_of(m.centre) + "}, {" +
         list_of(std::array{i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)}) + "}}";
}

inline std::string limits_of(const joint& j) {
  std::string all;
  const auto add = [&](const char* quantity, double low, double high) {
    all += (all.empty() ? "" : ", ") + std::string("cca::") + quantity + "{" + text_of(low) + ", " +
           text_of(high) + "}";
  };
  if (!j.limit) return all;
  if (j.limit->lower) add("angle", *j.limit->lower, *j.limit->upper);
  if (j.limit->velocity > 0) add("velocity", -j.limit->velocity, j.limit->velocity);
  add("torque", -j.limit->effort, j.limit->effort);
  return all;
}

// A motor gives its full torque up to half of its no-load speed; without a limit of velocity, at any.
inline std::string drive_text(const joint& j, double damping) {
  std::string inside;
  if (j.limit && j.limit->effort > 0)
    inside = ".motor = {" + text_of(j.limit->effort) + ", " +
             (j.limit->velocity > 0 ? text_of(2 * j.limit->velocity) : "1e9") + "}";
  if (damping > 0) inside += (inside.empty() ? "" : ", ") + std::string(".friction = ") + text_of(damping);
  return "cca::robots::joint_drive{" + inside + "}";
}

// A coordinate at the start.
inline double start_of(const joint& j) {
  if (!j.limit || !j.limit->lower || (*j.limit->lower <= 0 && *j.limit->upper >= 0)) return 0;
  return (*j.limit->lower + *j.limit->upper) / 2;
}

inline std::string form_text(const collision& c) {
  const auto& s = c.size;
  const std::string begin = "cca::robots::";
  if (c.kind == form_kind::box) return begin + "box(" + list_of(s) + ")";
  if (c.kind == form_kind::sphere) return begin + "sphere(" + text_of(s[0]) + ")";
  return begin + "capsule(" + text_of(s[0]) + ", " + text_of(s[1]) + ")";
}

}  // namespace cca_urdf
