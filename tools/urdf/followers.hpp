// Joints that follow others: which joint has the coordinate, and by which ratio. A joint may follow one that
// follows, but not itself.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model.hpp"
#include "numbers.hpp"
#include "remarks.hpp"

namespace cca_urdf {

// angle = ratio * that of `leader` + rest; a joint that follows none leads itself.
struct drive_of {
  const joint* leader = nullptr;
  double ratio = 1, rest = 0;
};

class followers {
public:
  followers(const robot& r, remarks& said) {
    std::map<std::string, const joint*> by_name;
    for (const joint& j : r.joints)
      if (j.moves()) by_name[j.name] = &j;
    for (const joint& j : r.joints) {
      if (j.moves() && j.mimic && j.mimic->has_own_limit)
        said.note(j.line,
                  named(j) + ": it follows another joint, so its own limits and its motor are left out");
      find_leader(j, by_name, said);
    }
    for (const auto& [j, d] : all_) damping_[d.leader] += d.ratio * d.ratio * j->damping;
  }

  const drive_of& operator[](const joint& j) const { return all_.at(&j); }

  // Of the coordinate of a joint that leads: the damping of all joints that it moves.
  double damping(const joint& leader) const { return damping_.at(&leader); }

private:
  // Up to a joint that leads itself or whose leader is known, then back.
  void find_leader(const joint& j, const std::map<std::string, const joint*>& by_name, remarks& said) {
    std::vector<const joint*> path;
    const joint* at = &j;
    while (!all_.contains(at) && at->moves() && at->mimic) {
      path.push_back(at);
      const auto next = by_name.find(at->mimic->joint);
      if (next == by_name.end() || path.size() > by_name.size()) {
        said.error(at->mimic->line,
                   named(*at) + ": " +
                       (next == by_name.end() ? "there is no joint '" + at->mimic->joint + "' that moves"
                                              : "it follows itself, over others"));
        for (const joint* each : path) all_[each] = {each};  // said once
        return;
      }
      at = next->second;
    }
    drive_of d = all_.try_emplace(at, drive_of{at}).first->second;
    for (auto each = path.rbegin(); each != path.rend(); ++each) {
      const mimic_of& m = *(*each)->mimic;
      d = all_[*each] = {d.leader, m.multiplier * d.ratio, m.multiplier * d.rest + m.offset};
    }
  }

  std::map<const joint*, drive_of> all_;
  std::map<const joint*, double> damping_;
};

}  // namespace cca_urdf
