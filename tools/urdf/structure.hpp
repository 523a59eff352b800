// The joints of a robot make one tree with one root. Everything else is named: links that nothing holds,
// loops, links with two parents, names that are written twice.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <cca/base/messages/first_words.hpp>

#include "model.hpp"
#include "remarks.hpp"

namespace cca_urdf {

class structure {
public:
  structure(const robot& r, remarks& said) : robot_(r) {
    const long before = said.errors();
    find_names(said);
    find_parents(said);
    if (said.errors() == before) find_root(said);
  }

  int root() const { return root_; }  // -1 after an error
  int index_of(const std::string& link) const {
    const auto found = index_.find(link);
    return found == index_.end() ? -1 : found->second;
  }
  // The joint that holds a link, or null.
  const joint* holding(int link) const { return parent_[static_cast<std::size_t>(link)]; }
  // The joints that a link holds, in the order of the file.
  const std::vector<const joint*>& held(int link) const { return held_[static_cast<std::size_t>(link)]; }

private:
  void find_names(remarks& said) {
    std::map<std::string, int> joints;
    for (const joint& j : robot_.joints)
      if (const auto [at, fresh] = joints.emplace(j.name, j.line); !fresh)
        said.error(j.line, named(j) + " is there twice; the first is in line " + std::to_string(at->second));
    for (const link& l : robot_.links)
      if (const auto [at, fresh] = index_.emplace(l.name, static_cast<int>(index_.size())); !fresh)
        said.error(l.line, named(l) + " is there twice; the first is in line " +
                               std::to_string(robot_.links[static_cast<std::size_t>(at->second)].line));
    parent_.resize(robot_.links.size());
    held_.resize(robot_.links.size());
    if (robot_.links.empty()) said.error(0, "the robot has no <link>");
  }

  void find_parents(remarks& said) {
    for (const joint& j : robot_.joints) {
      const int parent = index_of(j.parent), child = index_of(j.child);
      for (const auto& [name, found] : {std::pair{j.parent, parent}, {j.child, child}})
        if (found < 0 && !name.empty()) said.error(j.line, named(j) + ": there is no link '" + name + "'");
      if (parent < 0 || child < 0) continue;
      const joint*& holds = parent_[static_cast<std::size_t>(child)];
      if (holds)
        said.error(j.line, "link '" + j.child + "' is the child of " + with_line(*holds) + " and of " +
                               named(j) + ": a robot is a tree, so each link has one parent");
      else holds = &j;
      held_[static_cast<std::size_t>(parent)].push_back(&j);
    }
  }

  void find_root(remarks& said) {
    std::vector<int> roots;
    for (int i = 0; i < static_cast<int>(robot_.links.size()); ++i)
      if (!holding(i)) roots.push_back(i);
    if (roots.size() > 1) {
      const auto root = [&](std::size_t i) -> const auto& {
        return robot_.links[static_cast<std::size_t>(roots[i])];
      };
      said.error(root(1).line,
                 "no joint holds these links: " +
                     cca::detail::first_words(roots.size(), 5, ", ",
                                              [&](std::size_t i) { return with_line(root(i)); }) +
                     "; a robot is a tree with one root");
    }
    std::set<int> reached;
    for (std::vector<int> open = roots; !open.empty();) {
      const int at = open.back();
      open.pop_back();
      reached.insert(at);
      for (const joint* j : held(at)) open.push_back(index_of(j->child));
    }
    for (int i = 0; i < static_cast<int>(robot_.links.size()); ++i)
      if (!reached.contains(i)) return tell_loop(i, said);
    if (roots.size() == 1) root_ = roots[0];
  }

  // Upwards from a link that no root holds there is a loop.
  void tell_loop(int from, remarks& said) {
    int at = from;
    for (std::set<int> seen; seen.insert(at).second;) at = index_of(holding(at)->parent);
    std::string loop = "'" + robot_.links[static_cast<std::size_t>(at)].name + "'";
    int next = at;
    do {
      next = index_of(holding(next)->parent);
      loop += " on '" + robot_.links[static_cast<std::size_t>(next)].name + "'";
    } while (next != at);
    said.error(holding(at)->line, "the joints close a loop: " + loop + "; a robot is a tree");
  }

  const robot& robot_;
  std::map<std::string, int> index_;
  std::vector<const joint*> parent_;
  std::vector<std::vector<const joint*>> held_;
  int root_ = -1;
};

}  // namespace cca_urdf
