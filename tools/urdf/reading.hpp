// Reads a URDF file: text in, links and joints out. Errors and what is left out go into `remarks`, with
// lines.
//
// What changes nothing of the dynamics is named once for each kind: <gazebo>, <transmission>,
// <safety_controller> and the like. A file of xacro has to be expanded first.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include <tinyxml2.h>

#include "reading_joints.hpp"
#include "reading_links.hpp"

namespace cca_urdf {

namespace detail {

inline void refuse_xacro(const element& e, remarks& said) {
  if (std::string_view(e.Name()).starts_with("xacro:"))
    said.error(e.GetLineNum(), tag(e) + " is for xacro: expand the file first, `xacro FILE > robot.urdf`");
  for (const element* c = e.FirstChildElement(); c; c = c->NextSiblingElement()) refuse_xacro(*c, said);
}

// Counts what nobody reads.
class unread {
public:
  void look_at(const element& e, std::initializer_list<std::string_view> read) {
    for (const element* c = e.FirstChildElement(); c; c = c->NextSiblingElement()) {
      const std::string name = c->Name();
      if (std::ranges::find(read, name) != read.end()) continue;
      auto& [first, count] = found_[name];
      if (count++ == 0) first = c->GetLineNum();
    }
  }
  void tell(remarks& said) const {
    for (const auto& [name, f] : found_)
      said.note(f.first, "<" + name + "> is not read" +
                             (f.second > 1 ? "; there are " + std::to_string(f.second) + " of them" : ""));
  }

private:
  std::map<std::string, std::pair<int, int>> found_;
};

}  // namespace detail

inline robot read_robot(std::string_view text, remarks& said) {
  robot r;
  if (const auto zero = text.find('\0'); zero != text.npos) {
    said.error(0, "byte " + std::to_string(zero) + " is 0: this is no text");
    return r;
  }
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    said.error(document.ErrorLineNum(),
               "this is not XML, or not all of it (" + std::string(document.ErrorName()) + ")");
    return r;
  }
  const element* root = document.RootElement();
  if (!root || std::string_view(root->Name()) != "robot") {
    said.error(root ? root->GetLineNum() : 0, "a URDF file is one <robot>");
    return r;
  }
  if (const element* second = root->NextSiblingElement())
    said.error(second->GetLineNum(), tag(*second) + " stands after the <robot>");
  detail::refuse_xacro(*root, said);
  if (said.has_error()) return r;

  r.name = reader("the robot", said).text(*root, "name");
  detail::unread rest;
  rest.look_at(*root, {"link", "joint", "material"});
  for (const element* e = root->FirstChildElement(); e; e = e->NextSiblingElement()) {
    if (std::string_view(e->Name()) == "link") {
      r.links.push_back(read_link(*e, said));
      rest.look_at(*e, {"inertial", "visual", "collision"});
    } else if (std::string_view(e->Name()) == "joint") {
      r.joints.push_back(read_joint(*e, said));
      rest.look_at(*e, {"parent", "child", "origin", "axis", "limit", "dynamics", "mimic"});
    }
  }
  rest.tell(said);
  return r;
}

}  // namespace cca_urdf
