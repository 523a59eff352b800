// From bodies to parts: chains of joints, from one branching to the next, to an end, or to a link at which
// the user lets a part end.
//
// A part ends where its last body carries several joints or none, and is named after the link in which it
// ends: the one that all further joints hang on, or the only end of the fixed links there. If the last body
// has several fixed ends (a flange and a tool), the part ends in the frame of the body, and each of them is a
// part without joints. All other links that are fixed to something are frames on the way of a part: a chain
// of their own leads to them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bodies.hpp"

namespace cca_urdf {

struct limb {
  int from = -1, to = -1;     // links: in whose frame it begins and ends
  std::vector<int> bodies;    // those that its joints move, in order
  std::vector<origin> tip{};  // of the frame `to` in its last body, or in `from`
};

// The frame of a link that is fixed to one of the bodies of a part, or to the base.
struct frame_on_way {
  int link = -1, part = -1;  // part -1: on the base
  std::size_t joints = 0;    // of the part, which lead to it
};

class limbs {
public:
  // Longer chains make frames on their way too dear: each of them repeats the chain up to there.
  static constexpr std::size_t most_joints_to_frame = 64;

  limbs(const bodies& all, const std::vector<std::string>& wanted_ends, remarks& said) : bodies_(all) {
    for (const std::string& name : wanted_ends) choose_end(name, said);
    if (said.has_error()) return;
    divide();
    find_frames(said);
  }

  int base() const { return bodies_.all()[0].first; }
  const std::vector<limb>& all() const { return all_; }
  const std::vector<frame_on_way>& frames() const { return frames_; }
  const bodies& of() const { return bodies_; }
  // The part with the joint that moves a body, and the number of that joint; {-1, 0} for the base.
  std::pair<int, std::size_t> moved_in(int body) const {
    const auto found = moved_in_.find(body);
    return found == moved_in_.end() ? std::pair{-1, std::size_t{0}} : found->second;
  }
  // The part that ends in the frame of a link, or -1.
  int ending_in(int link) const {
    const auto found = ending_in_.find(link);
    return found == ending_in_.end() ? -1 : found->second;
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

  void choose_end(const std::string& name, remarks& said) {
    const int link = bodies_.tree().index_of(name);
    if (link < 0 || bodies_.place(link).body < 0)
      return said.error(0, "--end " + name + ": there is no such link");
    const int body = bodies_.place(link).body;
    if (body == 0)
      return said.error(0, "--end " + name + ": no joint moves this link, so no part can end there");
    if (const auto [at, fresh] = chosen_.emplace(body, link); !fresh && at->second != link)
      said.error(0, "--end " + name + ": no joint moves it against " + named(bodies_.link_at(at->second)) +
                        ", in which a part ends already");
  }

  // What hangs on a body, in the order of the file, without recursion: the number of branchings may be large.
  void divide() {
    struct open_joint {
      int frame;  // in which its part begins
      const joint* first;
    };
    std::vector<open_joint> open;
    const auto begin_in = [&](int frame, const body& b) {
      for (const int l : ends_of(b).fixed)
        if (l != frame) add({frame, l, {}, bodies_.between(frame, l)});
      for (auto j = b.joints.rbegin(); j != b.joints.rend(); ++j) open.push_back({frame, *j});
    };
    for (begin_in(base(), bodies_.all()[0]); !open.empty();) {
      const auto [frame, first] = open.back();
      open.pop_back();
      limb part{frame, -1, {}, {}};
      int at = body_moved_by(*first);
      for (part.bodies.push_back(at); goes_on(at); part.bodies.push_back(at))
        at = body_moved_by(*body_at(at).joints[0]);
      part.to = end_of(at);
      part.tip = bodies_.between(body_at(at).first, part.to);
      add(std::move(part));
      begin_in(all_.back().to, body_at(at));
    }
  }

  void add(limb part) {
    const int index = static_cast<int>(all_.size());
    for (std::size_t i = 0; i < part.bodies.size(); ++i) moved_in_[part.bodies[i]] = {index, i};
    ending_in_[part.to] = index;
    all_.push_back(std::move(part));
  }

  bool goes_on(int index) const { return body_at(index).joints.size() == 1 && !chosen_.contains(index); }

  int end_of(int index) const {
    if (const auto chosen = chosen_.find(index); chosen != chosen_.end()) return chosen->second;
    const body& b = body_at(index);
    const ends e = ends_of(b);
    if (e.fixed.size() + e.holding.size() != 1) return b.first;
    return e.fixed.empty() ? e.holding[0] : e.fixed[0];
  }

  void find_frames(remarks& said) {
    for (std::size_t i = 0; i < bodies_.all().size(); ++i)
      for (const int l : body_at(static_cast<int>(i)).links) {
        const auto [part, joint] = moved_in(static_cast<int>(i));
        if (l == body_at(static_cast<int>(i)).first || ending_in(l) >= 0) continue;
        const std::size_t joints = part < 0 ? 0 : joint + 1;
        if (joints <= most_joints_to_frame) frames_.push_back({l, part, joints});
        else
          said.note(bodies_.link_at(l).line,
                    named(bodies_.link_at(l)) +
                        " has no frame in the description: " + std::to_string(joints) +
                        " joints of one part lead to it; --end lets a part end on their way");
      }
  }

  const body& body_at(int i) const { return bodies_.all()[static_cast<std::size_t>(i)]; }
  int body_moved_by(const joint& j) const { return bodies_.place(bodies_.tree().index_of(j.child)).body; }

  const bodies& bodies_;
  std::map<int, int> chosen_;  // the link of a body in which a part ends
  std::vector<limb> all_;
  std::map<int, std::pair<int, std::size_t>> moved_in_;
  std::map<int, int> ending_in_;
  std::vector<frame_on_way> frames_;
};

}  // namespace cca_urdf
