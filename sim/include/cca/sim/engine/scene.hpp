// What stands around a robot: a floor or a terrain, boxes that don't move by themselves (tables, walls), and
// balls.
//
//   cca::sim::scene room;
//   room.floor = 0;                                                      // its height, m
//   room.ground = cca::sim::terrain::steps(0.006);                       // or terrain, with its own friction
//   const auto table = room.add(cca::sim::fixed_box{{0.6, 0.8, 0.04}, cca::at(0.5, 0, 0.3)});
//   room.add(cca::sim::ball{.radius = 0.05, .mass = 0.2, .position = {0.5, 0, 0.5}});
//
// A value; its numbers are judged when a world is made of it (checked_scene.hpp). Contacts are springs and
// dampers in SI units; friction is a pyramid. All defaults are CHOSEN.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <cca/mapping/placement.hpp>
#include <cca/sim/engine/terrain.hpp>

namespace cca::sim {

struct fixed_box {
  std::array<double, 3> size;  // its edges, m
  placement where;             // of its centre, in the world
};

struct ball {
  double radius = 0.05;  // m
  double mass = 0.1;     // kg
  std::array<double, 3> position{}, velocity{};
};

struct contact_numbers {
  double stiffness = 40e3;  // N/m
  double damping = 200;     // N s/m
  double friction = 0.75;   // of the load
  // Of a compiled world, whose friction is a cone: a pyramid, as in the engine, to compare the two.
  bool pyramid = false;
};

struct scene {
  std::optional<double> floor;
  std::optional<terrain> ground;
  std::vector<fixed_box> boxes;
  std::vector<ball> balls;
  contact_numbers contact{};

  std::size_t add(const fixed_box& b) {
    boxes.push_back(b);
    return boxes.size() - 1;
  }
  std::size_t add(const ball& b) {
    balls.push_back(b);
    return balls.size() - 1;
  }
};

}  // namespace cca::sim
