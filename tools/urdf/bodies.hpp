// From links to bodies: links that fixed joints hold together are one body, which has the sum of their masses
// and all of their shapes. Each joint that moves carries one body.
#pragma once

#include <string>
#include <vector>

#include "structure.hpp"

namespace cca_urdf {

// A link in the frame of its body.
struct place_in_body {
  int body = -1;
  int before = -1;  // the link to which a fixed joint holds it; -1: it is the first one of its body
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
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
    add_all();
    if (all_.size() == 1 && !said.has_error())
      said.error(0, "the robot has no joint that moves, so nothing can be commanded: give one a range");
  }

  const std::vector<body>& all() const { return all_; }  // the first is the base
  std::vector<body>& all() { return all_; }
  const place_in_body& place(int link) const { return places_[static_cast<std::size_t>(link)]; }
  const link& link_at(int i) const { return robot_.links[static_cast<std::size_t>(i)]; }
  bool floats() const { return floats_; }
  const structure& tree() const { return tree_; }

  // The steps from one frame of a body to another: those of the file if they are few.
  std::vector<origin> between(int from, int to) const {
    constexpr int most = 4;
    std::vector<origin> steps;
    int at = to;
    for (int links = 0; at != from && place(at).before >= 0 && links < most; ++links) {
      if (const origin& o = tree_.holding(at)->where; !o.is_identity()) steps.insert(steps.begin(), o);
      at = place(at).before;
    }
    if (at == from) return steps;
    return {origin::of(place(from).placed.inverse() * place(to).placed)};
  }

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

  // Bodies and their links in the order of the file, without recursion: a chain may be long.
  void add_all() {
    struct open_body {
      int first;
      const joint* by;
    };
    for (std::vector<open_body> open{{base_, nullptr}}; !open.empty();) {
      const auto [first, by] = open.back();
      open.pop_back();
      all_.push_back({by, first, {}, {}, {}});
      collect(all_.back(), first);
      const auto& moving = all_.back().joints;
      for (auto j = moving.rbegin(); j != moving.rend(); ++j)
        open.push_back({tree_.index_of((*j)->child), *j});
    }
  }

  void collect(body& b, int first) {
    const int index = static_cast<int>(all_.size()) - 1;
    const auto take = [&](int link, const place_in_body& where, std::vector<const joint*>& open) {
      b.links.push_back(link);
      places_[static_cast<std::size_t>(link)] = where;
      if (const auto& i = link_at(link).inertia)
        b.mass = b.mass + i->own.seen_from(where.placed * i->where.placed());
      const auto& held = tree_.held(link);
      open.insert(open.end(), held.rbegin(), held.rend());
    };
    std::vector<const joint*> open;
    for (take(first, {index, -1, Eigen::Isometry3d::Identity()}, open); !open.empty();) {
      const joint* j = open.back();
      open.pop_back();
      if (j->type == joint_type::floating) continue;
      const int parent = tree_.index_of(j->parent);
      if (j->moves()) b.joints.push_back(j);
      else take(tree_.index_of(j->child), {index, parent, place(parent).placed * j->where.placed()}, open);
    }
  }

  const robot& robot_;
  const structure& tree_;
  std::vector<place_in_body> places_;
  std::vector<body> all_;
  bool floats_;
  int base_ = -1;
};

}  // namespace cca_urdf
