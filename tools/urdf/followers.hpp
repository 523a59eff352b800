// Joints that follow others: which joint has the coordinate, and by which ratio. A joint may follow one that
// follows, but not itself.
#pragma once

#include <map>
#include <string>

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
      drive_of d{&j};
      for (std::size_t steps = 0; d.leader && d.leader->mimic; ++steps) {
        const mimic_of& m = *d.leader->mimic;
        const auto next = by_name.find(m.joint);
        if (next == by_name.end() || steps == r.joints.size()) {
          said.error(j.mimic->line,
                     named(j) + ": " +
                         (next == by_name.end() ? "there is no joint '" + m.joint + "' that moves"
                                                : "it follows itself, over others"));
          break;
        }
        d = {next->second, d.ratio * m.multiplier, d.ratio * m.offset + d.rest};
      }
      if (j.mimic && j.limit && j.limit->lower)
        said.note(j.line,
                  named(j) + ": it follows another joint, so its own limits and its motor are left out");
      all_[&j] = d;
    }
  }

  const drive_of& operator[](const joint& j) const { return all_.at(&j); }

  // Of the coordinate of a joint that leads: the damping of all joints that it moves.
  double damping(const joint& leader) const {
    double sum = 0;
    for (const auto& [j, d] : all_)
      if (d.leader == &leader) sum += d.ratio * d.ratio * j->damping;
    return sum;
  }

private:
  std::map<const joint*, drive_of> all_;
};

}  // namespace cca_urdf
