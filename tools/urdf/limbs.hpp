// From bodies to parts: chains of joints, from one branching to the next or to an end.
//
// A part ends where its last body carries several joints or none, and is named after the link in which it
// ends: the one that all further joints hang on, or the only end of the fixed links there. If the last body
// has several fixed ends (a flange and a tool), the part ends in the frame of the body, and each of them is a
// part without joints. A fixed end in the middle of a chain has no frame in the description; a note says so.
#pragma once

#include <string>
#include <vector>

#include "bodies.hpp"

namespace cca_urdf {

struct limb {
  int from = -1, to = -1;     // links: in whose frame it begins and ends
  std::vector<int> bodies;    // those that its joints move, in order
  std::vector<origin> tip{};  // of the frame `to` in its last body, or in `from`
};

class limbs {
public:
  limbs(const bodies& all, remarks& said) : bodies_(all) { begin(0, all.all()[0].first, said); }

  int base() const { return bodies_.all()[0].first; }
  const std::vector<limb>& all() const { return all_; }
  const bodies& of() const { return bodies_; }

  // The steps from one frame of a body to another: the first is the frame of the body, or the end of a part.
  std::vector<origin> between(int frame, int link) const {
    std::vector<origin> steps = bodies_.place(link).steps;
    const std::size_t before = bodies_.place(frame).steps.size();
    steps.erase(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(before));
    return steps;
  }

private:
  // The links of a body where something hangs on or where it ends.
  struct ends {
    std::vector<int> fixed, holding;
  };
  ends ends_of(const body& b) const {
    ends e;
    for (const int l : b.links) {
      const auto& held = bodies_.tree().held(l);
      if (held.empty() && l != b.first) e.fixed.push_back(l);
      if (std::ranges::any_of(held, &joint::moves)) e.holding.push_back(l);
    }
    return e;
  }

  // All that hangs on a body whose frame `frame` other parts can begin in.
  void begin(int index, int frame, remarks& said) {
    const body& b = body_at(index);
    for (const int l : ends_of(b).fixed)
      if (l != frame) all_.push_back({frame, l, {}, between(frame, l)});
    for (const joint* j : b.joints) {
      limb part{frame, -1, {}, {}};
      int at = body_moved_by(*j);
      for (part.bodies.push_back(at); goes_on(at, said); part.bodies.push_back(at))
        at = body_moved_by(*body_at(at).joints[0]);
      const body& last = body_at(at);
      part.to = end_of(last);
      part.tip = bodies_.place(part.to).steps;
      all_.push_back(part);
      begin(at, part.to, said);
    }
  }

  bool goes_on(int index, remarks& said) const {
    const body& b = body_at(index);
    if (b.joints.size() != 1) return false;
    for (const int l : ends_of(b).fixed) {
      const link& left_out = bodies_.link_at(l);
      said.note(left_out.line, named(left_out) +
                                   " has no frame in the description: it is fixed in the middle of a "
                                   "chain; its mass and its shapes are there");
    }
    return true;
  }

  int end_of(const body& b) const {
    const ends e = ends_of(b);
    if (e.fixed.size() + e.holding.size() != 1) return b.first;
    return e.fixed.empty() ? e.holding[0] : e.fixed[0];
  }

  const body& body_at(int i) const { return bodies_.all()[static_cast<std::size_t>(i)]; }
  int body_moved_by(const joint& j) const { return bodies_.place(bodies_.tree().index_of(j.child)).body; }

  const bodies& bodies_;
  std::vector<limb> all_;
};

}  // namespace cca_urdf
