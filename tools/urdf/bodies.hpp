// From links to bodies: links that fixed joints hold together are one body, which has the sum of their masses
// and all of their shapes. Each joint that moves carries one body.
#pragma once

#include <string>
#include <vector>

#include "structure.hpp"

namespace cca_urdf {

// A link in the frame of its body: the fixed joints that lead to it, in order.
struct place_in_body {
  int body = -1;
  std::vector<origin> steps;

  Eigen::Isometry3d placed() const {
    Eigen::Isometry3d all = Eigen::Isometry3d::Identity();
    for (const origin& o : steps) all = all * o.placed();
    return all;
  }
};

struct body {
  const joint* moved_by = nullptr;  // null: the base
  int first = -1;                   // its first link; the frame of that link is the frame of the body
  std::vector<int> links;
  std::vector<const joint*> joints;  // those that move and hang on its links
  mass_of_link mass{};
};

class bodies {
public:
  bodies(const robot& r, const structure& tree, bool floats, remarks& said)
      : robot_(r), tree_(tree), places_(r.links.size()), floats_(floats) {
    find_base(said);
    if (base_ < 0) return;
    add(base_, nullptr, said);
    if (all_.size() == 1 && !said.has_error()) said.error(0, "the robot has no joint that moves");
    for (const body& b : all_) check(b, said);
  }

  const std::vector<body>& all() const { return all_; }  // the first is the base
  const place_in_body& place(int link) const { return places_[static_cast<std::size_t>(link)]; }
  const link& link_at(int i) const { return robot_.links[static_cast<std::size_t>(i)]; }
  bool floats() const { return floats_; }
  const structure& tree() const { return tree_; }

private:
  // A massless root that holds a floating joint is the world; what floats in it is the base.
  void find_base(remarks& said) {
    const auto& held = tree_.held(tree_.root());
    base_ = tree_.root();
    if (held.size() == 1 && held[0]->type == joint_type::floating && !link_at(base_).inertia) {
      floats_ = true;
      base_ = tree_.index_of(held[0]->child);
    }
    for (const joint& j : robot_.joints)
      if (j.type == joint_type::floating && tree_.index_of(j.child) != base_)
        said.error(j.line,
                   named(j) + " floats: only the base can, on a root without a mass that holds it alone");
  }

  void add(int first, const joint* by, remarks& said) {
    const int index = static_cast<int>(all_.size());
    all_.push_back({by, first, {}, {}, {}});
    collect(index, first, {});
    for (const joint* j : std::vector(all_[static_cast<std::size_t>(index)].joints))
      add(tree_.index_of(j->child), j, said);
  }

  void collect(int index, int link, std::vector<origin> steps) {
    body& b = all_[static_cast<std::size_t>(index)];
    b.links.push_back(link);
    places_[static_cast<std::size_t>(link)] = {index, steps};
    if (const auto& i = link_at(link).inertia)
      b.mass = b.mass + i->own.seen_from(place(link).placed() * i->where.placed());
    for (const joint* j : tree_.held(link)) {
      if (j->type == joint_type::floating) continue;
      if (j->moves()) {
        b.joints.push_back(j);
        continue;
      }
      auto further = steps;
      if (!j->where.is_identity()) further.push_back(j->where);
      collect(index, tree_.index_of(j->child), further);
    }
  }

  void check(const body& b, remarks& said) const {
    const link& first = link_at(b.first);
    if (!b.moved_by && !floats_) return;  // a base that is fixed needs no mass
    const std::string why = b.moved_by ? with_line(*b.moved_by) + " moves it" : "the base floats";
    if (!(b.mass.mass > 0))
      said.error(first.line, named(first) + " has no mass, but " + why + ": give it an <inertial>");
    else if (!is_positive_definite(b.mass.about_centre))
      said.error(first.line, named(first) + " has an inertia that is not positive definite, but " + why);
  }

  const robot& robot_;
  const structure& tree_;
  std::vector<place_in_body> places_;
  std::vector<body> all_;
  bool floats_;
  int base_ = -1;
};

}  // namespace cca_urdf
