// Where a described robot and the balls touch what is around them, in the middle of a step of a compiled
// world: the robot's points the ground (probes.hpp), its shapes boxes and balls, balls the ground, boxes and
// each other.
//
// Kept are `most` touches, of more the deepest. `key` says which things touch, and where: the touches of the
// next step with the same key begin with the impulse of this one.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/around/box_on_box.hpp>
#include <cca/sim/compiled/around/ground_edges.hpp>
#include <cca/sim/compiled/around/nearest_of_lines.hpp>
#include <cca/sim/compiled/around/surroundings.hpp>
#include <cca/sim/compiled/contacts/contact_solver.hpp>
#include <cca/sim/compiled/contacts/own_touches.hpp>
#include <cca/sim/compiled/contacts/shapes_in_step.hpp>
#include <cca/sim/compiled/slots.hpp>
#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/compiled/probes.hpp>
#include <cca/sim/compiled/tree_step.hpp>

namespace cca::sim::detail {

// The normal points into the robot or, of two things without it, into the ball `into`.
template <class Real>
struct touch_in_step {
  static constexpr int none = -1;

  const probe* of = nullptr;  // the robot's shape; of nothing that moves: `nothing`
  int key = 0;
  int box = none;                // what is touched: a box
  int into = none, from = none;  // balls
  bool on_ground = false;
  const probe* against = nullptr;  // what is touched: another shape of the robot, which moves
  int own = none;                  // that shape, or one on a base that is held
  Real depth{};
  triple<Real> normal{}, at{};  // in the world

  constexpr bool has_ball() const { return into >= 0 || from >= 0; }
};

template <class R, class Real>
class touches_in_step {
public:
  using tree = compiled_tree<R>;
  using probes = probes_of<R>;
  using step_type = tree_step<R, Real>;
  using shapes = shapes_in_step<R, Real>;
  using one = touch_in_step<Real>;
  static constexpr std::size_t on_edges = edge_touch<Real>::most * probes::long_shapes;
  static constexpr std::size_t most = most_contacts<Real>(
      2 * probes::count + on_edges + own_touches<R, Real>::most);  // a wall for each point
  static constexpr probe nothing{.link = -1, .shape = -1, .tip = 0, .at = {}, .radius = 0};

  std::size_t count = 0;
  slots<one, most> all;

  template <class Ground>
  void find(const step_type& step, const Ground& under) {
    count = shallow = 0;
    if constexpr (probes::count > 0)
      if (under.exists) {
        find_on_ground(step, under);
        if (probes::long_shapes > 0 && !under.is_level()) find_on_edges(step, under);
        if (under.has_walls()) find_on_walls(step, under);
      }
  }
  // Of the robot's shapes with each other.
  void find_own(const step_type& step) {
    for (std::size_t i = 0; i < probes::own_pairs.size(); ++i)
      own_touches<R, Real>::find(step, i,
                                 [&](std::size_t first, std::size_t second, int feature, const Real& depth,
                                     const triple<Real>& at, const triple<Real>& normal) {
                                   one t;
                                   const probe* const moved = moving(second);
                                   t.of = moved ? moved : &nothing;
                                   t.against = moving(first), t.own = static_cast<int>(first);
                                   t.key = key_of_own(i, static_cast<std::size_t>(feature));
                                   t.depth = depth, t.at = at, t.normal = normal;
                                   add(t);
                                 });
  }
  // Beside those on the ground. `after`: of the beat's begin, s.
  void find_around(const step_type& step,
                   const surroundings& around,
                   const motion_around<Real>& now,
                   double after) {
    std::array<box_form<Real>, boxes_around::most> boxes;
    for (std::size_t i = 0; i < around.boxes.count; ++i) {
      const placed_frame<double> f = now.boxes[i].frame(after);
      for (std::size_t k = 0; k < 3; ++k) boxes[i].frame.axes[k] = real(f.axes[k]);
      const auto& h = around.boxes.half[i];
      boxes[i].frame.at = real(f.at), boxes[i].half = {Real(h[0]), Real(h[1]), Real(h[2])};
    }
    for (std::size_t s = 0; s < probes::shape_count; ++s) find_of_shape(step, around, now, boxes, s);
    for (std::size_t i = 0; i < around.balls.count; ++i) find_of_ball(around, now, boxes, i);
  }

private:
  static constexpr triple<Real> real(const triple<double>& v) { return {Real(v[0]), Real(v[1]), Real(v[2])}; }

  // Null: of a base that is held.
  static const probe* moving(std::size_t shape) {
    return probes::moves(probes::shapes[shape]) ? &probes::all[probes::first[shape]] : nullptr;
  }

  // Numbers of things, for keys: robot's shapes and balls with boxes and balls. Smaller keys are points on
  // the ground, and negative ones its edges and walls.
  static constexpr std::size_t features = 8, balls_at = boxes_around::most,
                               things = balls_at + balls_around::most, beyond_ground = 1 << 20;
  static constexpr int key_of(std::size_t first, std::size_t second, std::size_t feature) {
    return static_cast<int>(beyond_ground + (first * things + second) * features + feature);
  }
  static constexpr int key_of_own(std::size_t pair, std::size_t feature) {
    return static_cast<int>((std::size_t{1} << 28) + pair * features + feature);
  }
  static constexpr std::size_t ball_key(std::size_t ball) { return probes::shape_count + ball; }

  // The place for a touch of this depth; null: there are `most` deeper ones.
  one* room_for(const Real& depth) {
    if (count < most) return &all.make(count++);
    return everywhere(!(depth > all[shallow].depth)) ? nullptr : &all[shallow];
  }
  void look_for_shallow() {
    if (count < most) return;
    for (std::size_t k = 0; k < count; ++k)
      if (everywhere(all[k].depth < all[shallow].depth)) shallow = k;
  }
  void add(const one& t) {
    one* const place = room_for(t.depth);
    if (!place) return;
    *place = t;
    look_for_shallow();
  }

  template <class Ground>
  void find_on_ground(const step_type& step, const Ground& under) {
    const bool is_level = under.is_level();
    const triple<Real> up{step.base.axes[0][2], step.base.axes[1][2], step.base.axes[2][2]};
    int link = -2;
    triple<Real> rise{};  // of the link's axes
    Real height{};        // of its origin, above the floor
    for (std::size_t i = 0; i < probes::count; ++i) {
      const probe& p = probes::all[i];
      if (is_level) {
        if (p.link != link) {
          link = p.link;
          height = height_above(under, step.base.at), rise = up;
          if (link >= 0) {
            const auto& f = step.now.places()[static_cast<std::size_t>(link)];
            height = height + dot(up, f.at), rise = along(f, up);
          }
        }
        const Real above =
            height + Real(p.at[0]) * rise[0] + Real(p.at[1]) * rise[1] + Real(p.at[2]) * rise[2];
        if (everywhere(above > Real(p.radius + 1e-9))) continue;
      }
      const triple<Real> at = on_links<R, Real>::point(step.now.places(), p.link, p.at),
                         world = step.base.at + step.base.direction(at);
      if (!is_level && everywhere(is_surely_above(under, world, p.radius))) continue;
      const ground_touch<Real> t = touch_of(under, world, p.radius);
      if (everywhere(!(t.depth > Real(0.0)))) continue;
      one* const place = room_for(t.depth);
      if (!place) continue;
      place->of = &p, place->key = static_cast<int>(i);
      place->on_ground = true;
      if (count == most) place->box = place->into = place->from = one::none;  // of the one that was there
      place->depth = t.depth, place->normal = t.normal, place->at = world - Real(p.radius) * t.normal;
      look_for_shallow();
    }
  }

  template <class Ground>
  void find_on_walls(const step_type& step, const Ground& under) {
    one t;
    t.on_ground = true;
    for (std::size_t i = 0; i < probes::count; ++i) {
      const probe& p = probes::all[i];
      const triple<Real> world =
          step.base.at + step.base.direction(on_links<R, Real>::point(step.now.places(), p.link, p.at));
      if (everywhere(is_surely_above(under, world, p.radius))) continue;
      const ground_touch<Real> on = touch_of_wall(under, world, p.radius);
      if (everywhere(!(on.depth > Real(0.0)))) continue;
      t.of = &p, t.key = -1 - static_cast<int>(edge_touch<Real>::most * probes::shape_count + i);
      t.depth = on.depth, t.normal = on.normal, t.at = world - Real(p.radius) * on.normal;
      add(t);
    }
  }

  template <class Ground>
  void find_on_edges(const step_type& step, const Ground& under) {
    for (std::size_t s = 0; s < probes::shape_count; ++s) {
      const placed_shape& shape = probes::shapes[s];
      const bool is_box = shape.form.kind == robots::shape_kind::box;
      if (!probes::moves(shape) || !probes::is_long(shape)) continue;
      const triple<Real> middle = shapes::middle(step, shape);
      const double reach = probes::reach(shape);
      if (everywhere(is_surely_above(under, middle, reach)) || !is_edge_near(under, middle, reach)) continue;
      const auto axes = shapes::axes(step, shape);
      const auto& size = shape.form.size;
      const auto span = [&](std::size_t k, double whole) { return Real(whole / 2) * axes[k]; };
      const auto found =
          is_box
              ? touches_of_edges(
                    under,
                    spanned_shape<Real, 3>{middle, {span(0, size[0]), span(1, size[1]), span(2, size[2])}, 0},
                    reach)
              : touches_of_edges(under, spanned_shape<Real, 1>{middle, {span(2, size[1])}, size[0]}, reach);
      one t;
      t.of = &probes::all[probes::first[s]], t.on_ground = true;
      for (std::size_t i = 0; i < found.size(); ++i) {
        if (everywhere(!(found[i].depth > Real(0.0)))) continue;
        t.key = -1 - static_cast<int>(s * found.size() + i);
        t.depth = found[i].depth, t.normal = found[i].normal, t.at = found[i].at;
        add(t);
      }
    }
  }

  void find_of_shape(const step_type& step,
                     const surroundings& around,
                     const motion_around<Real>& now,
                     const std::array<box_form<Real>, boxes_around::most>& boxes,
                     std::size_t s) {
    const placed_shape& shape = probes::shapes[s];
    const bool moves = probes::moves(shape);
    if (!moves && around.balls.count == 0) return;
    const auto& size = shape.form.size;
    const bool is_box = shape.form.kind == robots::shape_kind::box,
               is_sphere = shape.form.kind == robots::shape_kind::sphere;
    const Real radius(is_box ? 0.0 : size[0]), reach(probes::reach(shape));
    box_form<Real> own{{}, {Real(size[0] / 2), Real(size[1] / 2), Real(size[2] / 2)}};
    placed_frame<Real>& frame = own.frame;
    frame.at = shapes::middle(step, shape);
    bool is_turned = is_sphere;  // its axes are found where something is near
    const auto turn = [&] {
      if (is_turned) return;
      const auto axes = shapes::axes(step, shape);
      for (std::size_t k = 0; k < 3; ++k) frame.axes[k] = axes[k];
      is_turned = true;
    };
    const Real half_length(shape.form.kind == robots::shape_kind::capsule ? size[1] / 2 : 0.0);
    one t;
    t.of = moves ? &probes::all[probes::first[s]] : &nothing;
    for (std::size_t b = 0; moves && b < around.boxes.count; ++b) {
      const nearest_on_box<Real> n = boxes[b].nearest(boxes[b].inside(frame.at));
      if (n.distance > reach) continue;
      turn();
      t.box = static_cast<int>(b);
      const auto touches = [&](int feature, const Real& depth, const triple<Real>& at,
                               const triple<Real>& normal) {
        t.key = key_of(s, b, static_cast<std::size_t>(feature));
        t.depth = depth, t.at = at, t.normal = normal;
        add(t);
      };
      if (is_box) box_on_box<Real>(boxes[b], own).touch(touches);
      else if (shape.form.kind == robots::shape_kind::capsule)
        boxes[b].touch_capsule(frame.at - half_length * frame.axes[2], frame.at + half_length * frame.axes[2],
                               radius, touches);
      else boxes[b].touch_sphere(frame.at, radius, touches);
    }
    t.box = one::none;
    for (std::size_t i = 0; i < around.balls.count; ++i) {
      const triple<Real>& at = now.balls[i].at;
      const Real of_ball(around.balls.all[i].radius), far_off = reach + of_ball;
      const triple<Real> off = at - frame.at;
      if (dot(off, off) > far_off * far_off) continue;
      turn();
      triple<Real> out;  // from the shape to the ball
      Real apart{};
      if (is_box) {
        const nearest_on_box<Real> n = own.nearest(own.inside(at));
        out = frame.direction(n.normal), apart = n.distance;
      } else {
        const Real way = between(-half_length, dot(off, frame.axes[2]), half_length);
        const triple<Real> line = off - way * frame.axes[2];
        const Real far = root(dot(line, line));
        if (far > Real(0.0)) out = (Real(1.0) / far) * line;
        else out = across_lines(frame.axes[2], {});
        apart = far - radius;
      }
      t.depth = of_ball - apart;
      if (!(t.depth > Real(0.0))) continue;
      // Where the shape's surface is, below the ball's.
      t.at = at - apart * out;
      t.normal = moves ? Real(-1.0) * out : out;
      t.into = moves ? one::none : static_cast<int>(i), t.from = moves ? static_cast<int>(i) : one::none;
      t.key = key_of(s, balls_at + i, 0);
      add(t);
    }
  }

  void find_of_ball(const surroundings& around,
                    const motion_around<Real>& now,
                    const std::array<box_form<Real>, boxes_around::most>& boxes,
                    std::size_t i) {
    const triple<Real>& at = now.balls[i].at;
    const double radius = around.balls.all[i].radius;
    one t;
    t.of = &nothing, t.into = static_cast<int>(i);
    const auto on_ground = [&](const ground_touch<Real>& on, std::size_t feature) {
      if (!(on.depth > Real(0.0))) return;
      t.on_ground = true, t.depth = on.depth, t.normal = on.normal, t.at = at - Real(radius) * on.normal;
      t.key = key_of(ball_key(i), balls_at + i, feature);
      add(t);
      t.on_ground = false;
    };
    on_ground(touch_of(around.under, at, radius), 0);
    if (around.under.has_walls()) on_ground(touch_of_wall(around.under, at, radius), 1);
    for (std::size_t b = 0; b < around.boxes.count; ++b) {
      t.box = static_cast<int>(b), t.key = key_of(ball_key(i), b, 0);
      boxes[b].touch_sphere(
          at, Real(radius),
          [&](int, const Real& depth, const triple<Real>& where, const triple<Real>& normal) {
            t.depth = depth, t.at = where, t.normal = normal;
            add(t);
          });
    }
    t.box = one::none;
    for (std::size_t k = 0; k < i; ++k) {
      const triple<Real> off = at - now.balls[k].at;
      const Real far = root(dot(off, off));
      t.depth = Real(radius + around.balls.all[k].radius) - far;
      if (!(t.depth > Real(0.0))) continue;
      t.normal = far > Real(0.0) ? (Real(1.0) / far) * off : across_lines<Real>({}, {});
      t.at = at - Real(radius) * t.normal;
      t.from = static_cast<int>(k), t.key = key_of(ball_key(i), balls_at + k, 0);
      add(t);
      t.from = one::none;
    }
  }

  std::size_t shallow = 0;
};

}  // namespace cca::sim::detail
