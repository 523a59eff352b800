// The shapes of a robot and of its scene in the engine, and the pairs of them that can touch.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include <ode/ode.h>

#include <cca/sim/engine/engine.hpp>
#include <cca/sim/engine/ground_strips.hpp>
#include <cca/sim/robot/model/robot_model.hpp>
#include <cca/sim/engine/scene.hpp>
#include <cca/sim/engine/touching.hpp>
#include <cca/sim/robot/tree/tree_in_engine.hpp>

namespace cca::sim {

class shapes_in_engine {
public:
  shapes_in_engine(dWorldID world,
                   const robot_model& model,
                   const scene& around,
                   const tree_in_engine& tree) {
    for (const placed_shape& s : model.shapes) add_robot_shape(s, model, tree);
    own_pairs_ = model.own_pairs;
    for (const ball& b : around.balls) add_ball(world, b);
    if (around.floor) floor_.reset(dCreatePlane(nullptr, 0, 0, 1, *around.floor));
    if (around.ground) ground_ = std::make_unique<ground_strips>(*around.ground);
    for (const fixed_box& b : around.boxes) {
      boxes_.emplace_back(dCreateBox(nullptr, b.size[0], b.size[1], b.size[2]));
      put_box(boxes_.size() - 1, b.where);
    }
  }

  // The robot's pairs first; of a robot whose base is fixed, the shapes on the base touch only balls.
  std::vector<touching::pair> pairs() const {
    std::vector<touching::pair> all;
    const auto with_what_stands = [&](dGeomID moves, int shape) {
      if (floor_) all.push_back({moves, floor_.get(), shape});
      if (ground_) all.push_back({moves, nullptr, shape, ground_.get()});
      for (const auto& b : boxes_) all.push_back({moves, b.get(), shape});
    };
    for (std::size_t i = 0; i < robot_.size(); ++i) {
      const dGeomID shape = robot_[i].get();
      const bool moves = dGeomGetBody(shape) != nullptr;
      if (moves) with_what_stands(shape, static_cast<int>(i));
      for (const auto& b : ball_shapes_)
        all.push_back(moves ? touching::pair{shape, b.get(), static_cast<int>(i)}
                            : touching::pair{b.get(), shape, -1});
    }
    for (const auto& [i, j] : own_pairs_) {
      const bool moves = dGeomGetBody(robot_[i].get()) != nullptr;
      const std::size_t first = moves ? i : j, second = moves ? j : i;
      all.push_back({robot_[first].get(), robot_[second].get(), static_cast<int>(first), nullptr,
                     static_cast<int>(second)});
    }
    for (std::size_t i = 0; i < ball_shapes_.size(); ++i) {
      with_what_stands(ball_shapes_[i].get(), -1);
      for (std::size_t k = 0; k < i; ++k) all.push_back({ball_shapes_[i].get(), ball_shapes_[k].get(), -1});
    }
    return all;
  }

  const std::vector<dBodyID>& balls() const { return balls_; }

  void put_box(std::size_t i, const placement& where) {
    const auto& [at, turn] = where;
    dGeomSetPosition(boxes_.at(i).get(), at[0], at[1], at[2]);
    const dQuaternion q{turn[3], turn[0], turn[1], turn[2]};
    dGeomSetQuaternion(boxes_[i].get(), q);
    box_places_.resize(boxes_.size());
    box_places_[i] = {at[0], at[1], at[2], turn[0], turn[1], turn[2], turn[3]};
  }
  const std::vector<std::array<double, 7>>& box_places() const { return box_places_; }
  void restore_boxes(const std::vector<std::array<double, 7>>& places) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto& p = places[i];
      put_box(i, {{p[0], p[1], p[2]}, {p[3], p[4], p[5], p[6]}});
    }
  }

private:
  static engine_handle<dxGeom> made(const robots::shape& s) {
    switch (s.kind) {
      case robots::shape_kind::box:
        return engine_handle<dxGeom>(dCreateBox(nullptr, s.size[0], s.size[1], s.size[2]));
      case robots::shape_kind::capsule:
        return engine_handle<dxGeom>(dCreateCapsule(nullptr, s.size[0], s.size[1]));
      case robots::shape_kind::sphere:
        break;
    }
    return engine_handle<dxGeom>(dCreateSphere(nullptr, s.size[0]));
  }

  // On a body of the engine a shape has its place relative to the centre of mass, along the link's axes.
  void add_robot_shape(const placed_shape& s, const robot_model& model, const tree_in_engine& tree) {
    const dGeomID g = robot_.emplace_back(made(s.form)).get();
    const dBodyID b = tree.body_of(s.link);
    const auto& turn = s.where.rotation;
    if (b) {
      const link_inertia& of =
          s.link < 0 ? model.base : model.links[static_cast<std::size_t>(s.link)].inertia;
      dGeomSetBody(g, b);
      dGeomSetOffsetPosition(g, s.where.translation[0] - of.centre[0], s.where.translation[1] - of.centre[1],
                             s.where.translation[2] - of.centre[2]);
      const dQuaternion q{turn[3], turn[0], turn[1], turn[2]};
      dGeomSetOffsetQuaternion(g, q);
      return;
    }
    const rigid f = tree.frame(-1).where * s.where;
    const auto q = cca::detail::quaternion_of(f.turn);
    const dQuaternion in_world{q[3], q[0], q[1], q[2]};
    dGeomSetPosition(g, f.at[0], f.at[1], f.at[2]);
    dGeomSetQuaternion(g, in_world);
  }

  void add_ball(dWorldID world, const ball& b) {
    const dBodyID body = balls_.emplace_back(dBodyCreate(world));
    dMass m;
    dMassSetSphereTotal(&m, b.mass, b.radius);
    dBodySetMass(body, &m);
    dBodySetPosition(body, b.position[0], b.position[1], b.position[2]);
    dBodySetLinearVel(body, b.velocity[0], b.velocity[1], b.velocity[2]);
    dGeomSetBody(ball_shapes_.emplace_back(dCreateSphere(nullptr, b.radius)).get(), body);
  }

  std::vector<engine_handle<dxGeom>> robot_, boxes_, ball_shapes_;
  std::vector<std::array<std::size_t, 2>> own_pairs_;
  std::vector<dBodyID> balls_;
  engine_handle<dxGeom> floor_;
  std::unique_ptr<ground_strips> ground_;  // at one address: pairs point to it
  std::vector<std::array<double, 7>> box_places_;
};

}  // namespace cca::sim
