// What a body weighs decides, not what a single link does: a placeholder on a camera does no harm. Bodies
// that can't be are refused, or get the nearest inertia that can; bodies without a mass leave a robot without
// dynamics.
#pragma once

#include <string>

#include "bodies.hpp"

namespace cca_urdf {

namespace detail {

inline std::string name_of_body(const bodies& all, const body& b) {
  const std::string first = named(all.link_at(b.first));
  if (b.links.size() == 1) return first;
  const auto more = std::to_string(b.links.size() - 1);
  return first + " with " + (b.links.size() == 2 ? "the link" : "the " + more + " links") + " fixed to it";
}

// A link that can't be, as a part of a body that can.
inline void tell_placeholders(const bodies& all, const body& b, remarks& said) {
  for (const int l : b.links)
    if (const auto& i = all.link_at(l).inertia)
      if (const std::string fault = fault_of(i->own.about_centre); !fault.empty())
        said.note(i->line, named(all.link_at(l)) + ": no body has this inertia: " + fault +
                               "; it is taken as it is, since " + name_of_body(all, b) + " has a sound one");
}

inline void check_inertia(const bodies& all, body& b, bool accepts, remarks& said) {
  const bool is_held = !b.moved_by && !all.floats();
  const link& first = all.link_at(b.first);
  const std::string name = name_of_body(all, b), fault = fault_of(b.mass.about_centre);
  const bool has_none = is_next_to_nothing(b.mass.about_centre, b.mass.mass);
  if (fault.empty() && (is_held || (is_positive_definite(b.mass.about_centre) && !has_none)))
    return tell_placeholders(all, b, said);
  const std::string moved =
      ", but " + (b.moved_by ? with_line(*b.moved_by) + " moves it" : "the base floats");
  const std::string has = has_none ? " has next to no inertia for its " + rounded(b.mass.mass) + " kg"
                                   : " has an inertia that is not positive definite";
  const std::string wrong = name + (fault.empty() ? has + moved : ": no body has this inertia: " + fault);
  const Eigen::Matrix3d sound = nearest_sound(b.mass.about_centre, b.mass.mass);
  const std::string offered = (has_none ? "that of a ball as dense as water, with principal moments of "
                                        : "the nearest sound one, with principal moments of ") +
                              moments_text(principal_moments(sound));
  if (!accepts && !is_held)
    return said.error(first.line, wrong + "; correct it, or let --accept-inertia take " + offered);
  said.note(first.line, wrong + "; it becomes " + offered + (is_held ? ", and nothing moves it" : ""));
  b.mass.about_centre = sound;
}

}  // namespace detail

inline void check_masses(bodies& all, bool accepts, remarks& said) {
  std::size_t with_mass = 0;
  for (const body& b : all.all()) with_mass += b.moved_by && b.mass.mass > 0;
  for (body& b : all.all()) {
    const link& first = all.link_at(b.first);
    if (b.mass.mass > 0) detail::check_inertia(all, b, accepts, said);
    else if (!b.moved_by && all.floats())
      said.error(first.line,
                 named(first) + " has no mass, but the base floats: give it an <inertial>, or hold the base");
    else if (b.moved_by && with_mass > 0)
      said.note(first.line, named(first) + " has no mass, but " + with_line(*b.moved_by) +
                                " moves it: it weighs nothing, and the simulator refuses this robot; give it "
                                "an <inertial>");
  }
  if (with_mass == 0 && all.all().size() > 1)
    said.note(0,
              "no link that moves has a mass: the description has axes, limits, chains and frames, and "
              "whatever needs dynamics refuses it; give each link an <inertial> for that");
}

}  // namespace cca_urdf
