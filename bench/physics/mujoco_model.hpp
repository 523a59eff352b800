#pragma once
// A described robot as a model of MuJoCo, which is optional (Debian: libmujoco-dev).
//
//   mjcf_of<R>(step, solver, cone)   the model as MuJoCo's XML, on a floor at height 0
//
// Masses, inertias, places, axes, stops, shapes, springs and gains are those of the description. What MuJoCo
// has in another way: a joint that follows another one is a joint of its own with a soft equality; a motor
// has a constant limit instead of a falling line; a spring that only pulls is an actuator on a tendon; a
// contact is a spring and a damper per mass, here for a quarter of the robot's mass, with the friction cone
// as pyramid or ellipse. A link without mass is merged into the link that turns in the same place.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <cca/sim/compiled/probes.hpp>
#include <cca/sim/engine/scene.hpp>

namespace bench {

template <class R>
class mjcf {
  using tree = cca::sim::detail::compiled_tree<R>;
  using probes = cca::sim::detail::probes_of<R>;
  static constexpr const auto& links = tree::described.links;

public:
  mjcf(double step, const char* solver, const char* cone) {
    cca::sim::contact_numbers ground;
    const double quarter = tree::mass / 4;
    char law[200];
    std::snprintf(law, sizeof law, "condim='3' friction='%.9g 0 0' solref='%.9g %.9g'", ground.friction,
                  -ground.stiffness / quarter, -ground.damping / quarter);
    contact = law;
    add("<mujoco><compiler angle='radian' autolimits='false' inertiafromgeom='false'/><size njmax='400' "
        "nconmax='80'/>\n"
        "<option timestep='%.9g' gravity='0 0 -9.81' solver='%s' cone='%s'/>\n<worldbody>"
        "<geom type='plane' size='50 50 1' contype='0' conaffinity='1' %s/>\n<body name='base'><freejoint/>",
        step, solver, cone, law);
    inertial(tree::body::base);
    shapes(-1), sites(-1);
    for (int i = 0; i < count; ++i)
      if (links[at(i)].parent < 0) link(i);
    text += "</body></worldbody>\n<equality>" + followers + "</equality>\n<tendon>";
    for (std::size_t i = 0; i < lines; ++i)
      add("<spatial name='line%zu'><site site='from%zu'/><site site='to%zu'/></spatial>", i, i, i);
    text += "</tendon>\n<actuator>";
    for (std::size_t c = 0; c < R::drives.size(); ++c) {
      const auto& d = R::drives[c];
      if (!(d.motor.torque > 0)) continue;
      const bool winds = d.cable.stiffness > 0;
      const double k = d.position_stiffness(), b = winds ? d.cable.damping : d.damping;
      add("<general name='drive%zu' joint='%s' biastype='affine' gainprm='%.12g' biasprm='0 %.12g %.12g' "
          "forcelimited='true' forcerange='%.12g %.12g'/>\n",
          c, leader[c].c_str(), k, -k, -b, winds ? 0.0 : -d.motor.torque, d.motor.torque);
    }
    if constexpr (lines > 0)
      for (std::size_t i = 0; i < lines; ++i) {
        const auto& s = R::line_springs[i];
        add("<general name='spring%zu' tendon='line%zu' biastype='affine' gainprm='0' biasprm='%.12g %.12g "
            "%.12g' forcelimited='true' forcerange='-1e9 %g'/>\n",
            i, i, s.stiffness * s.rest, -s.stiffness, -s.damping, s.only_pulls ? 0.0 : 1e9);
      }
    text += "</actuator></mujoco>\n";
  }
  std::string text;
  std::array<std::string, R::drives.size()> leader;  // the joint of each coordinate

private:
  static constexpr int count = static_cast<int>(tree::links);
  static constexpr std::size_t lines = tree::lines.size();
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::string contact, followers;

  template <class... Values>
  void add(const char* format, Values... values) {
    char line[1000];
    std::snprintf(line, sizeof line, format, values...);
    text += line;
  }
  void inertial(const cca::link_inertia& i) {
    const auto& m = i.about_centre;
    add("<inertial pos='%.15g %.15g %.15g' mass='%.15g' fullinertia='%.15g %.15g %.15g %.15g %.15g "
        "%.15g'/>\n",
        i.centre[0], i.centre[1], i.centre[2], i.mass, m[0], m[1], m[2], m[3], m[4], m[5]);
  }
  void shapes(int of) {
    for (const auto& s : probes::shapes) {
      if (s.link != of) continue;
      const auto& [x, y, z] = s.where.translation;
      const auto& q = s.where.rotation;
      const auto& size = s.form.size;
      const bool is_box = s.form.kind == cca::robots::shape_kind::box,
                 is_capsule = s.form.kind == cca::robots::shape_kind::capsule;
      add("<geom type='%s' pos='%.12g %.12g %.12g' quat='%.12g %.12g %.12g %.12g' size='%.12g %.12g %.12g' "
          "contype='1' conaffinity='0' %s/>\n",
          is_box       ? "box"
          : is_capsule ? "capsule"
                       : "sphere",
          x, y, z, q[3], q[0], q[1], q[2], is_box ? size[0] / 2 : size[0],
          is_box || is_capsule ? size[1] / 2 : 0.0, is_box ? size[2] / 2 : 0.0, contact.c_str());
    }
  }
  void sites(int of) {
    if constexpr (lines > 0) {
      constexpr auto parts = cca::sim::detail::links_by_part<typename R::body>();
      constexpr auto ends = cca::sim::detail::ends_of<typename R::body>();
      for (std::size_t i = 0; i < lines; ++i) {
        const auto site = [&](const char* name, const auto& p) {
          const auto place = cca::sim::detail::placed<typename R::body>(p, parts, ends);
          const auto& [x, y, z] = place.where.translation;
          if (place.link == of) add("<site name='%s%zu' pos='%.12g %.12g %.12g'/>\n", name, i, x, y, z);
        };
        site("from", R::line_springs[i].from), site("to", R::line_springs[i].to);
      }
    }
  }
  void joint(int i) {
    const auto& l = links[at(i)];
    const auto c = at(l.coordinate);
    const auto& d = R::drives[c];
    const char* kind = l.kind == cca::joint_kind::revolute ? "hinge" : "slide";
    add("<joint name='joint%d' type='%s' axis='%.12g %.12g %.12g'", i, kind, l.axis[0], l.axis[1], l.axis[2]);
    if (leader[c].empty()) {
      if (l.ratio != 1 || l.rest != 0)
        std::fprintf(stderr, "mjcf: the first joint of coordinate %zu has a ratio or a rest\n", c),
            std::exit(1);
      leader[c] = "joint" + std::to_string(i);
      add(" stiffness='%.12g' springref='%.12g' damping='%.12g'", d.spring, d.spring_rest, d.friction);
      if (tree::ranges[c].exists())
        add(" limited='true' range='%.12g %.12g' solreflimit='0.004 1'", tree::ranges[c].low,
            tree::ranges[c].high);
    } else {
      char both[200];
      std::snprintf(both, sizeof both,
                    "<joint joint1='joint%d' joint2='%s' polycoef='%.12g %.12g 0 0 0' solref='0.002 1'/>\n",
                    i, leader[c].c_str(), l.rest, l.ratio);
      followers += both;
    }
    text += "/>\n";
  }
  void link(int i) {
    const auto& l = links[at(i)];
    add("<body name='link%d' pos='%.15g %.15g %.15g'", i, l.at[0], l.at[1], l.at[2]);
    if (!l.straight)
      add(" xyaxes='%.15g %.15g %.15g %.15g %.15g %.15g'", l.turn[0], l.turn[1], l.turn[2], l.turn[3],
          l.turn[4], l.turn[5]);
    text += ">\n";
    int last = i;
    joint(last);
    while (!(links[at(last)].inertia.mass > 0)) {  // those without mass turn in the place of the next one
      int next = -1;
      for (int k = 0; k < count; ++k)
        if (links[at(k)].parent == last) next = k;
      const auto& n = links[at(next)];
      if (next < 0 || !n.straight || n.at[0] != 0 || n.at[1] != 0 || n.at[2] != 0)
        std::fprintf(stderr, "mjcf: link %d has no mass\n", last), std::exit(1);
      last = next;
      joint(last);
    }
    inertial(links[at(last)].inertia);
    shapes(last), sites(last);
    for (int k = 0; k < count; ++k)
      if (links[at(k)].parent == last) link(k);
    text += "</body>\n";
  }
};

}  // namespace bench
