// Writes a robot as a header: its frames, axes, chains, body and description.
#pragma once

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "followers.hpp"
#include "limbs.hpp"
#include "names.hpp"
#include "pieces.hpp"

namespace cca_urdf {

struct header_options {
  std::string name_space;  // empty: the name of the robot
  std::string source;      // the file that was read
  double rate = 1000;      // Hz
  bool touches_itself = false;
};

class header {
public:
  header(const robot& r,
         const limbs& parts,
         const followers& coupled,
         const header_options& options,
         remarks& said)
      : robot_(r), limbs_(parts), bodies_(parts.of()), followers_(coupled), options_(options) {
    for (const limb& l : limbs_.all()) frame_names_.add(name_of(l.to));
    frame_names_.add(name_of(limbs_.base()));
    for (const frame_on_way& f : limbs_.frames()) frame_names_.add(name_of(f.link));
    for (const body& b : bodies_.all()) {
      if (!b.moved_by || !leads(*b.moved_by)) continue;
      const std::string& name = b.moved_by->name;
      if (const std::string& id = axis_names_.add(name); id != name)
        said.note(b.moved_by->line, named(*b.moved_by) + " is the axis '" + id + "' in the description");
    }
    if (options_.touches_itself && bodies_with_shapes() < 2)
      said.note(0, "nothing touches itself: fewer than two bodies have a shape");
  }

  std::string text(const std::vector<remark>& notes) const {
    std::string space = options_.name_space;
    if (space.empty()) space = namespace_of(robot_.name);
    std::string all = "// The robot '" + one_line(robot_.name) + "', from " + one_line(options_.source) +
                      " by cca-urdf. Change that file and write this one again.\n";
    if (!notes.empty()) all += "//\n// Left out or changed:\n";
    for (const remark& n : notes)
      all += "//   line " + std::to_string(n.line) + ": " + one_line(n.text) + "\n";
    all +=
        "//\n// Units: m, rad, kg, kg m^2, N m; prismatic joints: m, N.\n#pragma once\n\n#include <array>\n\n"
        "#include <cca/robot/body.hpp>\n#include <cca/robots/description.hpp>\n#include "
        "<cca/space/limits.hpp>\n\n";
    all += "namespace " + space + " {\n\n" + frames() + axes() + chains() + chains_to_frames() +
           whole_body() + description();
    return all + "}  // namespace " + space + "\n";
  }

private:
  const std::string& name_of(int link) const { return bodies_.link_at(link).name; }
  std::string frame_of(int link) const { return "frame::" + frame_names_[name_of(link)]; }
  std::string chain_of(int link) const {  // C++ reserves names with two underscores in a row
    const std::string& id = frame_names_[name_of(link)];
    return id + (id.ends_with('_') ? "chain" : "_chain");
  }
  std::string axis_of(const joint& j) const { return "axis::" + axis_names_[j.name]; }
  const joint& joint_of(int body) const { return *bodies_.all()[static_cast<std::size_t>(body)].moved_by; }

  bool leads(const joint& j) const { return followers_[j].leader == &j; }
  const std::string& axis_name(const joint& j) const { return axis_names_[followers_[j].leader->name]; }

  bool all_lead(const limb& of) const {
    return std::ranges::all_of(of.bodies, [&](int i) { return leads(joint_of(i)); });
  }
  bool has_mass(const limb& of) const {
    return std::ranges::any_of(
        of.bodies, [&](int i) { return bodies_.all()[static_cast<std::size_t>(i)].mass.mass > 0; });
  }

  std::string driven_text(const joint& j) const {
    const drive_of& d = followers_[j];
    std::string numbers;
    if (d.ratio != 1 || d.rest != 0) numbers += ", " + text_of(d.ratio);
    if (d.rest != 0) numbers += ", " + text_of(d.rest);
    return ".driven_by(\"" + axis_name(j) + "\"" + numbers + ")";
  }

  std::string frames() const {
    std::string all = "namespace frame {\n";
    const auto add = [&](int link) {
      const std::string& id = frame_names_[name_of(link)];
      all += "struct " + id + " : cca::frame<\"" + id + "\"> {};\n";
    };
    add(limbs_.base());
    for (const limb& l : limbs_.all()) add(l.to);
    for (const frame_on_way& f : limbs_.frames()) add(f.link);
    return all + "}  // namespace frame\n\n";
  }

  std::string axes() const {
    std::string all = "namespace axis {\n";
    for (const body& b : bodies_.all()) {
      if (!b.moved_by || !leads(*b.moved_by)) continue;
      const std::string& id = axis_names_[b.moved_by->name];
      const std::string limits = limits_of(*b.moved_by);
      std::string states;
      if (b.moved_by->type == joint_type::continuous)
        states += "  static constexpr bool continuous = true;\n";
      if (!limits.empty()) states += "  static constexpr auto limits = cca::limits{" + limits + "};\n";
      all += "struct " + id + " : cca::dimension<\"" + id + "\"> {" + (states.empty() ? "" : "\n") + states;
      all += "};\n";
    }
    return all + "}  // namespace axis\n\n";
  }

  std::string chains() const {
    std::string all = "// Of each link: mass; centre; xx, yy, zz, xy, xz, yz about the centre.\n";
    for (const limb& l : limbs_.all()) {
      std::string joints, links, own_axes;
      const bool name_axes = !all_lead(l);  // only then do joints name their axes
      int frame = l.from;
      for (const int i : l.bodies) {
        const body& b = bodies_.all()[static_cast<std::size_t>(i)];
        const joint& j = *b.moved_by;
        std::vector<origin> steps = bodies_.between(frame, bodies_.tree().index_of(j.parent));
        steps.push_back(j.where);
        if (leads(j)) own_axes += (own_axes.empty() ? "" : ", ") + axis_of(j);
        joints +=
            (joints.empty() ? "" : ",\n      ") + joint_text(j, steps) + (name_axes ? driven_text(j) : "");
        links += (links.empty() ? "" : ",\n      ") + inertia_text(b.mass);
        frame = b.first;
      }
      all += chain_begin(l.to, l.from, own_axes) + joints_text(joints) + tip_text(l.tip);
      if (has_mass(l)) all += "  static constexpr std::array links{\n      " + links + "};\n";
      all += "};\n";
    }
    return all + "\n";
  }

  // Kinematics only: what hangs on the rest of the part is missing.
  std::string chains_to_frames() const {
    std::string all;
    for (const frame_on_way& f : limbs_.frames()) {
      const limb base{limbs_.base(), -1, {}, {}};
      const limb& l = f.part < 0 ? base : limbs_.all()[static_cast<std::size_t>(f.part)];
      std::string joints, own_axes;
      int frame = l.from;
      for (std::size_t i = 0; i < f.joints; ++i) {
        const joint& j = joint_of(l.bodies[i]);
        joints += (i ? ", " : "") + chain_of(l.to) + "::joints[" + std::to_string(i) + "]";
        if (leads(j)) own_axes += (own_axes.empty() ? "" : ", ") + axis_of(j);
        frame = bodies_.all()[static_cast<std::size_t>(l.bodies[i])].first;
      }
      all += chain_begin(f.link, l.from, own_axes) + joints_text(joints) +
             tip_text(bodies_.between(frame, f.link)) + "};\n";
    }
    return all.empty() ? all : "// To frames on the way of a part, for kinematics.\n" + all + "\n";
  }

  std::string chain_begin(int to, int from, const std::string& own_axes) const {
    return "struct " + chain_of(to) + " : cca::serial_chain<" + frame_of(from) + ", " + frame_of(to) +
           ", cca::axes<" + own_axes + ">> {\n";
  }
  static std::string joints_text(const std::string& joints) {
    return joints.empty() ? "  static constexpr std::array<cca::joint, 0> joints{};\n"
                          : "  static constexpr std::array joints{\n      " + joints + "};\n";
  }
  static std::string tip_text(const std::vector<origin>& steps) {
    return "  static constexpr cca::placement tip = " + placement_text(steps) + ";\n";
  }

  std::string whole_body() const {
    std::string all = "struct whole_body : cca::body<\n    " + frame_of(limbs_.base());
    for (const limb& l : limbs_.all()) {
      const std::string& id = frame_names_[name_of(l.to)];
      std::string nodes;
      std::set<std::string> named;
      for (const int i : l.bodies)
        if (const std::string& node = axis_name(joint_of(i)); named.insert(node).second)
          nodes += (nodes.empty() ? "\"" : ", \"") + node + "\"";
      all += ",\n    cca::part<\"" + id + "\", " + chain_of(l.to) +
             (nodes.empty() ? "" : ", cca::driven_by<" + nodes + ">") + ">";
    }
    all += "> {\n";
    const body& base = bodies_.all()[0];
    if (base.mass.mass > 0) all += "  static constexpr " + inertia_text(base.mass, " base") + ";\n";
    return all + "};\n\n";
  }

  std::string description() const {
    std::string drives, start;
    bool starts_at_zero = true;
    int count = 0;
    for (const limb& l : limbs_.all())
      for (const int i : l.bodies) {
        if (!leads(joint_of(i))) continue;
        const double at = start_of(joint_of(i));
        starts_at_zero = starts_at_zero && at == 0;
        drives += (count ? ",\n      " : "") + drive_text(joint_of(i), followers_.damping(joint_of(i)));
        start += (count++ ? ", " : "") + text_of(at);
      }
    std::string all = "struct description {\n  using body = whole_body;\n  using rate = cca::rate<" +
                      text_of(options_.rate) + ">;\n";
    all += "  using commands = cca::robots::commands<cca::robots::torque_command>;\n";
    if (bodies_.floats()) all += "  static constexpr bool floats = true;\n";
    all += "  // The motors give their full torque up to the limit of the velocity.\n";
    all += "  static constexpr std::array drives{\n      " + drives + "};\n";
    if (!starts_at_zero)
      all +=
          "  // Where 0 is outside of a range, the middle of that range.\n  static constexpr "
          "std::array<double, " +
          std::to_string(count) + "> start{" + start + "};\n";
    if (options_.touches_itself)
      all +=
          "  // By --touches-itself: its shapes touch each other, but for those of neighbours.\n"
          "  static constexpr bool touches_itself = true;\n";
    if (const std::string shapes = all_shapes(); !shapes.empty()) {
      if (!options_.touches_itself && bodies_with_shapes() > 1)
        all += "  // They pass through each other: --touches-itself was not given.\n";
      all += "  static constexpr std::array shapes{\n      " + shapes + "};\n";
    }
    const bool weighs =
        std::ranges::all_of(bodies_.all(), [](const body& b) { return !b.moved_by || b.mass.mass > 0; });
    return all +
           "};\n\nstatic_assert(cca::robots::" + (weighs ? "check_description" : "check_without_masses") +
           "<description>());\n\n";
  }

  std::size_t bodies_with_shapes() const {
    std::set<int> with;
    for (std::size_t i = 0; i < robot_.links.size(); ++i)
      if (const int body = bodies_.place(static_cast<int>(i)).body;
          body >= 0 && !robot_.links[i].collisions.empty())
        with.insert(body);
    return with.size();
  }

  // A shape on the link in which a part ends is at the tip: the force sensor of that part feels it.
  std::string all_shapes() const {
    std::string all;
    for (std::size_t i = 0; i < robot_.links.size(); ++i)
      for (const collision& c : robot_.links[i].collisions) {
        const int link = static_cast<int>(i);
        if (bodies_.place(link).body < 0) continue;
        all += (all.empty() ? "" : ",\n      ") + shape_text(link, c);
      }
    return all;
  }
  std::string shape_text(int link, const collision& c) const {
    const place_in_body& at = bodies_.place(link);
    const int first = bodies_.all()[static_cast<std::size_t>(at.body)].first;
    if (const int part = limbs_.ending_in(link); part >= 0 && link != first)
      return "cca::robots::at_tip(\"" + frame_names_[name_of(link)] + "\", " + form_text(c) + ", " +
             placement_text({c.where}) + ")";
    std::vector<origin> steps = bodies_.between(first, link);
    steps.push_back(c.where);
    if (const auto [part, joint] = limbs_.moved_in(at.body); part >= 0)
      return "cca::robots::on_link(\"" +
             frame_names_[name_of(limbs_.all()[static_cast<std::size_t>(part)].to)] + "\", " +
             std::to_string(joint) + ", " + form_text(c) + ", " + placement_text(steps) + ")";
    return "cca::robots::on_base(" + form_text(c) + ", " + placement_text(steps) + ")";
  }

  const robot& robot_;
  const limbs& limbs_;
  const bodies& bodies_;
  const followers& followers_;
  header_options options_;
  // Not the members of frames and axes, and not the other nodes of a robot (cca/robots/ports.hpp).
  name_list frame_names_{{"name", "label"}};
  name_list axis_names_{{"name",       "label",          "limits",       "simulator",    "angles",
                         "velocities", "torques",        "position",     "velocity",     "torque",
                         "stiffness",  "damping",        "synchronizer", "servos",       "finite",
                         "stale",      "emergency_stop", "soft_stop",    "damping_stop", "rate"}};
};

}  // namespace cca_urdf
