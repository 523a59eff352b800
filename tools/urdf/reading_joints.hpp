// <joint> elements: type, place, axis, limits, friction, and what they follow.
#pragma once

#include <algorithm>
#include <numbers>
#include <string>

#include "elements.hpp"
#include "reading_links.hpp"

namespace cca_urdf {

inline std::optional<joint_type> type_of(const element& e, const reader& from) {
  const std::string type = from.text(e, "type");
  if (type == "fixed") return joint_type::fixed;
  if (type == "revolute") return joint_type::revolute;
  if (type == "continuous") return joint_type::continuous;
  if (type == "prismatic") return joint_type::prismatic;
  if (type == "floating") return joint_type::floating;
  if (type == "planar")
    from.error(e, "a planar joint can't be represented: make it two prismatic joints and a revolute one");
  else if (!type.empty())
    from.error(e, "the type '" + type + "' is unknown; there are revolute, continuous, prismatic and fixed");
  return {};
}

// The limits that a motor and the stops need. Numbers that stand for no number leave out what they limit.
inline std::optional<joint_limit> read_limit(const element& e, const joint& j, const reader& from) {
  const element* limit = child_of(e, "limit", from.said());
  const bool has_ends = j.type != joint_type::continuous;
  joint_limit l;
  if (!limit) {
    if (has_ends) from.error(e, "it needs a <limit> with `lower`, `upper`, `effort` and `velocity`");
    else from.said().note(j.line, named(j) + ": without a <limit> it has no motor, and no limit of velocity");
    return l;
  }
  const long before = from.said().errors();
  const auto note = [&](const std::string& text) { from.said().note(limit->GetLineNum(), named(j) + text); };
  l.effort = from.number(*limit, "effort");
  l.velocity = from.number(*limit, "velocity");
  if (from.said().errors() > before) return l;
  if (l.effort <= 0) note(": with an `effort` of " + text_of(l.effort) + " it has no motor");
  if (l.velocity <= 0)
    note(": a `velocity` of " + text_of(l.velocity) + " is taken as no limit" +
         (l.effort > 0 ? ", so its motor gives its torque at any speed" : ""));
  l.effort = std::max(0.0, l.effort), l.velocity = std::max(0.0, l.velocity);
  if (!has_ends) return l;
  const auto lower = from.optional_number(*limit, "lower"), upper = from.optional_number(*limit, "upper");
  const double low = lower.value_or(0), high = upper.value_or(0);  // 0 is URDF's default for one of them
  if (!limit->Attribute("lower") && !limit->Attribute("upper"))
    from.error(*limit, "<limit> needs `lower` and `upper`; a joint without a range is continuous");
  else if (from.said().errors() == before && !(low <= high))
    from.error(*limit, "`lower` is " + text_of(low) + " and `upper` is " + text_of(high) +
                           "; `lower` must be below `upper`; a joint without a range is continuous");
  if (from.said().errors() == before) l.lower = low, l.upper = high;
  if (j.type == joint_type::revolute && high - low >= 2 * std::numbers::pi)
    note(": its range is a whole turn or more, so the simulator gives it no stops");
  return l;
}

inline void read_dynamics(const element& e, joint& j, const reader& from) {
  const element* dynamics = child_of(e, "dynamics", from.said());
  if (!dynamics) return;
  j.damping = from.optional_number(*dynamics, "damping").value_or(0);
  const double friction = from.optional_number(*dynamics, "friction").value_or(0);
  if (j.damping < 0 || friction < 0) from.error(*dynamics, "damping and friction must not be negative");
  if (friction > 0)
    from.said().note(dynamics->GetLineNum(), named(j) + ": the dry friction of " + text_of(friction) +
                                                 " is left out: friction grows with speed here (`damping`)");
}

inline joint read_joint(const element& e, remarks& said) {
  joint j;
  j.name = reader("a joint", said).text(e, "name");
  j.line = e.GetLineNum();
  const reader from(named(j), said);
  const auto type = type_of(e, from);
  if (const element* parent = from.needed_child(e, "parent")) j.parent = from.text(*parent, "link");
  if (const element* child = from.needed_child(e, "child")) j.child = from.text(*child, "link");
  j.where = read_origin(e, from);
  if (!type) return j;
  j.type = *type;
  if (!j.moves()) return j;
  if (const element* axis = child_of(e, "axis", said)) {
    j.axis = from.list<3>(*axis, "xyz", j.axis);
    if (j.axis == std::array<double, 3>{}) from.error(*axis, "the axis has no direction");
  }
  read_dynamics(e, j, from);
  if (const element* mimic = child_of(e, "mimic", said)) {
    j.mimic =
        mimic_of{mimic->GetLineNum(), from.text(*mimic, "joint"),
                 from.optional_number(*mimic, "multiplier").value_or(1),
                 from.optional_number(*mimic, "offset").value_or(0), e.FirstChildElement("limit") != nullptr};
    if (j.mimic->multiplier == 0) from.error(*mimic, "a `multiplier` of 0: make it a fixed joint");
  } else {
    j.limit = read_limit(e, j, from);
  }
  return j;
}

}  // namespace cca_urdf
