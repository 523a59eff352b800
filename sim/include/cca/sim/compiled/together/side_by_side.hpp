// Worlds that advance together, several in the lanes of a vector, and stay worlds of their own: each with its
// ground, its masses, its drives, its accounts and its trouble.
//
//   struct beside : cca::sim::robot<R, cca::sim::side_by_side<cca::sim::compiled>> {};
//   one.step(), other.step();                       two controllers with such a robot: each world waits
//   cca::sim::advance_together(worlds);             an array of pointers to both: their beats of physics
//
// `advance(laws)` of such a world only keeps the laws: the world waits until it advances with others, so a
// beat of its controller has no physics, and a fault comes a beat later: ask `trouble()` before. What you set
// while it waits (a push, a place) counts in that beat: set it before the controller's beat, or after
// `advance_alone()`, which makes the beat at once. If it waits already, `advance` makes that beat first, so
// none is lost; but the controller has sensed before it. Worlds that can't be
// lanes of one vector (beat_in_lanes.hpp says which can) advance one by one. Each world has the bits that it
// has alone, whatever advances with it (without contraction: lanes.hpp).
//
// `cca::sim::rollouts` does all this for runs that go in steps.
//
//   World   compiled_world<R>, or a type derived from it that has no state besides
//
// Neither allocates nor throws. Cost: docs/physics.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <ranges>
#include <span>
#include <type_traits>
#include <utility>

#include <cca/base/compiler.hpp>
#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/compiled/together/beat_in_lanes.hpp>
#include <cca/sim/robot/world_named.hpp>

namespace cca::sim {

template <class World>
class side_by_side : public World {
public:
  static constexpr std::size_t at_once = cca::detail::lane_count;  // 2, with AVX2 4: so many share a vector
  using together = detail::beat_in_lanes<typename World::description, static_cast<int>(at_once)>;

  using World::World;
  explicit side_by_side(World&& w) : World(std::move(w)) {}
  static side_by_side at_start() { return side_by_side(World::at_start()); }

  void advance(std::span<const joint_law> laws) {
    advance_alone();
    count_ = std::min(laws.size(), asked_.size());
    std::copy_n(laws.begin(), count_, asked_.begin());
    waits_ = !this->trouble();
  }
  // Whether it has laws that it has not followed yet.
  bool waits() const { return waits_; }
  std::span<const joint_law> asked() const { return {asked_.data(), count_}; }

  // What waits is not in a state that is saved; a world that gets one back does not wait.
  void restore(const typename World::state_type& s) {
    waits_ = false;
    World::restore(s);
  }

  void does_not_wait() { waits_ = false; }
  void advance_alone() {
    if (waits_) World::advance(asked());
    waits_ = false;
  }

private:
  std::array<joint_law, std::tuple_size_v<std::remove_cvref_t<decltype(std::declval<const World&>().laws())>>>
      asked_{};
  std::size_t count_ = 0;
  bool waits_ = false;
};

namespace detail {

template <class R, class World>
struct world_named<R, side_by_side<World>> {
  using type = side_by_side<typename world_named<R, World>::type>;
};

}  // namespace detail

// A beat of physics for each of them that waits.
template <class Worlds>
void advance_together(const Worlds& pointers) {
  using world = std::remove_pointer_t<std::ranges::range_value_t<Worlds>>;
  const std::span<world* const> worlds(pointers);
  constexpr std::size_t most = world::at_once;
  using together = typename world::together;
  for (std::size_t first = 0; first < worlds.size(); ++first) {
    std::array<typename together::lane, most> group{};
    std::size_t count = 0;
    for (std::size_t k = first; k < worlds.size() && count < most; ++k) {
      world& w = *worlds[k];
      if (!w.waits()) continue;
      const typename together::lane one{&w, w.asked()};
      if (count > 0 && !together::go_together(group[0], one)) continue;
      group[count++] = one;
      w.does_not_wait();
    }
    if (count == 1) group[0].of->advance(group[0].laws);
    if (count > 1) together::make(std::span(group.data(), count));
  }
}

}  // namespace cca::sim
