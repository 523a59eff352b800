// The mode of a deployment, for the thread that runs it. A deployment of one graph has nothing of it. `Self`
// is the deployment.
//
// Between two runs, and in `between` of a fast run in one process, a switch has effect at once, as in one
// loop. In a wall-clock run it has effect some beats later, in all environments in the same beat
// (environments/links/agreed_changes.hpp); so it has, before the next beat, in a fast run of several
// processes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <cca/base/fixed_string.hpp>
#include <cca/base/refused.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/runtime/environments/loop/environment_loops.hpp>
#include <cca/runtime/modes/mode_names.hpp>

namespace cca::detail {

template <class Self, class D, bool HasModes = DeploymentOfModes<D>>
class mode_of_deployed {
protected:
  struct hooks_of_active_mode {
    explicit hooks_of_active_mode(Self&) {}
  };
  static constexpr bool has_hooks(int) { return true; }
  static void check_part_of_mode(const char*, int) {}
  template <class Terms>
  static void tell_mode(Terms&) {}
  template <class Terms>
  static void join_mode(const Terms&) {}
  static void choose_teller() {}
};

template <class Self, class D>
class mode_of_deployed<Self, D, true> : protected mode_names<D> {
public:
  template <fixed_string Mode>
  void switch_to() {
    change_to(mode_names<D>::template mode_named<Mode>());
  }
  void switch_to(std::string_view mode) { change_to(mode_names<D>::number_of(mode)); }

  // The active one, of the first environment of this process.
  std::string_view mode() const noexcept { return mode_names<D>::all.modes[number()].name; }

  // To a recorder that begins.
  void tell_mode_of_now() noexcept {
    for_each_here([&](auto& loop) { loop.tell_mode(self().beat_index()); });
  }

protected:
  // The hooks on_start and on_stop are those of the active mode.
  struct hooks_of_active_mode {
    mode_of_deployed& of;
    explicit hooks_of_active_mode(Self& d) : of(d) { of.is_for_active_mode = true; }
    ~hooks_of_active_mode() { of.is_for_active_mode = false; }
    hooks_of_active_mode(const hooks_of_active_mode&) = delete;
    hooks_of_active_mode& operator=(const hooks_of_active_mode&) = delete;
  };
  bool has_hooks(int node) const {
    return !is_for_active_mode || has_mode(plan_of<D>.nodes[array_size(node)].members, number());
  }
  bool has_part_in_mode(int part) const {
    return has_mode(plan_of<D>.parts[array_size(part)].members, number());
  }
  void check_part_of_mode(const char* call, int part) const {
    if (!has_part_in_mode(part)) mode_names<D>::refuse_part(call, part, mode());
  }

  // At the beginning of a run: the mode of all environments is that of the one which has switched most often.
  template <class Terms>
  void tell_mode(Terms& wanted) const {
    wanted.mode = number();
    for_first_here([&](const auto& loop) { wanted.switches = loop.switches(); });
  }
  template <class Terms>
  void join_mode(const Terms& agreed) {
    for_each_here([&](auto& loop) { loop.join_mode(agreed.mode, agreed.switches, agreed.beat, true); });
  }

  // The first environment here tells a recorder of the mode.
  void choose_teller() {
    bool is_first = true;
    for_each_here([&](auto& loop) { loop.tells_mode = std::exchange(is_first, false); });
  }

  int number() const noexcept {
    int found = 0;
    for_first_here([&](const auto& loop) { found = loop.mode(); });
    return found;
  }
  // At once: all environments are at rest.
  void move_to(int next, [[maybe_unused]] bool is_requested = false) {
    const state now = self().state();
    const bool is_started = now == state::started || now == state::running;
    for_each_here([&](auto& loop) { loop.switch_mode(next, self().beat_index(), false, is_started); });
  }

private:
  void change_to(int next) {
    if (self().state() == state::faulted)
      throw refused("cca::controller: switch_to() is refused in the state `faulted`: " +
                    std::string(remedy(transition::run, self().state())));
    if (self().is_at_rest()) move_to(next);
    else self().order(ordered::mode, next);
  }

  template <class F>
  void for_each_here(F f) {
    self().loops.for_each([&]<int E>(auto& loop) {
      if (self().here[E]) f(loop);
    });
  }
  template <class F>
  void for_first_here(F f) const {
    bool is_done = false;
    self().loops.for_each([&]<int E>(const auto& loop) {
      if (self().here[E] && !is_done) f(loop);
      is_done = is_done || self().here[E];
    });
  }

  Self& self() { return static_cast<Self&>(*this); }
  const Self& self() const { return static_cast<const Self&>(*this); }

  bool is_for_active_mode = false;
};

}  // namespace cca::detail
