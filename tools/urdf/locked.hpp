// Joints that can't move: a range of one place is how some files lock a joint. It is fixed there, and what
// follows it is fixed, too.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model.hpp"
#include "numbers.hpp"
#include "remarks.hpp"

namespace cca_urdf {

namespace detail {

inline void lock(joint& j, double at) {
  if (at != 0) j.where = origin::of(j.where.placed() * j.moved(at));
  j.type = joint_type::fixed;
}

}  // namespace detail

inline void lock_joints(robot& r, remarks& said) {
  std::multimap<std::string, joint*> followers;  // by the joint that each follows
  std::vector<std::pair<std::string, double>> open;
  const auto lock = [&](joint& j, double at, const std::string& why) {
    said.note(j.line, named(j) + ": " + why + ", so it is fixed at " + text_of(at));
    detail::lock(j, at);
    open.push_back({j.name, at});
  };
  for (joint& j : r.joints) {
    if (j.mimic) followers.emplace(j.mimic->joint, &j);
    else if (j.moves() && j.limit && j.limit->lower && *j.limit->lower == *j.limit->upper)
      lock(j, *j.limit->lower, "`lower` and `upper` are the same");
  }
  while (!open.empty()) {
    const auto [name, at] = open.back();
    open.pop_back();
    const auto [first, last] = followers.equal_range(name);
    for (auto f = first; f != last; ++f)
      if (joint& j = *f->second; j.moves())
        lock(j, j.mimic->multiplier * at + j.mimic->offset, "it follows a joint that is fixed");
  }
}

}  // namespace cca_urdf
