// What the contacts of a robot's shape have done since the start: what they carried, how far they slipped,
// and the work that friction took.
//
//   const cca::sim::contact_account foot = world.contact_at_end("left_front_leg") - before;
//   foot.slip / foot.load     the mean speed of the slip, each moment weighted by its load, m/s
//
// A contact's speed is that of the shape at the point of contact at the end of a step, along the surface,
// relative to what it touches. The work of friction is force times speed: in the engine, which moves bodies
// at the speeds of the step's end, that speed; in compiled physics, which moves them at the mean of the
// speeds before and after, that mean. Of two shapes of one robot the first has it. Plain numbers, part of a
// world's state; they cost some operations for each contact.
#pragma once

#include <algorithm>
#include <cstddef>

#include <cca/base/math/reductions.hpp>
#include <cca/sim/robot/model/robot_model.hpp>

namespace cca::sim {

struct contact_account {
  double pressing = 0;       // N, the force into the surface in the last physics step
  double load = 0;           // N s, that force over time
  double slip = 0;           // N m, that force times the speed of the contact, over time
  double friction_work = 0;  // J, lost to friction
  double touching = 0;       // s, with a contact
  double contacts = 0;       // in the last physics step

  void begin_step() { pressing = contacts = 0; }
  // `into`: N, into the surface; `speed`: m/s, along it; `lost`: J, to friction, in this step.
  void add(double into, double speed, double lost, double step) {
    if (contacts++ == 0) touching += step;
    pressing += into;
    load += into * step;
    slip += into * speed * step;
    friction_work += lost;
  }
  template <class Touch>  // touching.hpp
  void add(const Touch& t, double step) {
    add(std::max(0.0, math::dot(t.force, t.normal)), math::norm(t.slip), -math::dot(t.force, t.slip) * step,
        step);
  }

  // Of several shapes; `touching` is that of the one that touched longest.
  contact_account operator+(const contact_account& other) const {
    return {pressing + other.pressing,
            load + other.load,
            slip + other.slip,
            friction_work + other.friction_work,
            std::max(touching, other.touching),
            contacts + other.contacts};
  }
  // Since an earlier moment.
  contact_account operator-(const contact_account& before) const {
    return {pressing,
            load - before.load,
            slip - before.slip,
            friction_work - before.friction_work,
            touching - before.touching,
            contacts};
  }
};

// The sum over the shapes for which `which` says so.
template <class Contacts, class Which>
contact_account contact_of(const robot_model& model, const Contacts& contacts, Which which) {
  contact_account sum;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (which(model.shapes[i])) sum = sum + contacts[i];
  return sum;
}

}  // namespace cca::sim
