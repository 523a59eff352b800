// Thousands of worlds of one task on all cores: what the Python module steps. It needs no Python itself.
//
//   cca::python::worlds<walk> all(64, {.episode_steps = 1000});
//   all.reset({}, {});                     seeds 0 to 63
//   all.step(actions);                     64 rows
//   all.now().observations                 64 rows, one world after the other
//
// A world depends on its seed and its actions alone, so the bits are the same on any number of threads. What
// happens when an episode ends says `autoreset`:
//
//   same_step   the world begins its next episode in the same step; `final_observations` has the last ones
//   next_step   it begins with the next step, which takes no action of it and brings no reward
//   disabled    it stands still until it is reset, and brings no reward
//
// The seed of a world's next episode comes from the one of its last.
//
// Results stand in two sets of arrays in turn: those of a call hold until the call after the next.
//
// Errors: std::invalid_argument for numbers that don't fit, std::logic_error for a step before the reset,
// cca::refused for parameters and for what the task throws; then every world has to be reset.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <cca/base/math/random_numbers.hpp>
#include <cca/base/refused.hpp>
#include <cca/config.hpp>
#include <cca/python/described_numbers.hpp>
#include <cca/python/episode.hpp>
#include <cca/python/found_firings.hpp>
#include <cca/python/given_parameter.hpp>
#include <cca/sim/rollouts.hpp>

namespace cca::python {

enum class autoreset : std::uint8_t { same_step, next_step, disabled };

struct world_options {
  unsigned threads = 0;            // 0: one for each core
  std::int64_t episode_steps = 0;  // of the policy, then an episode is cut; 0: never
  autoreset when_over = autoreset::same_step;
};

inline constexpr std::int64_t most_seed = std::int64_t{1} << 53;

// Of all worlds, one after the other. Flags are bytes, 0 or 1.
struct world_results {
  std::vector<double> observations, rewards, final_observations, returns;
  std::vector<std::uint8_t> terminations, truncations, ended;  // ended: an episode, in this step
  std::vector<std::int64_t> lengths, seeds;                    // steps so far; of the episode under way
  std::vector<std::string> faults;                             // texts, most of them empty
};

template <class Task>
class worlds {
  using one = episode<Task>;

public:
  using controller = typename Task::controller;
  using stand_in = typename one::stand_in;
  static constexpr auto observed = static_cast<std::size_t>(stand_in::observed);
  static constexpr auto commanded = static_cast<std::size_t>(stand_in::action_space::size);

  explicit worlds(std::size_t count, const world_options& options = {})
      : options_(options), described_(actions_of<stand_in>()) {
    if (count < 1) throw std::invalid_argument("num_envs is 0: there is at least one world");
    loaded_.load();
    times_ = found_firings<Task>(loaded_);
    places_.resize(count);
    for (world_results& r : results_) {
      r.observations.resize(count * observed), r.final_observations.resize(count * observed);
      r.rewards.resize(count), r.returns.resize(count), r.lengths.resize(count), r.seeds.resize(count);
      r.terminations.resize(count), r.truncations.resize(count), r.ended.resize(count);
      r.faults.resize(count);
    }
    for (std::size_t i = 0; i < count; ++i) {
      all_.push_back(std::make_unique<one>(loaded_));
      places_[i].random = random_numbers(i), places_[i].next_seed = i;
    }
  }

  // The named worlds (all, if `which` is empty) begin an episode; `seeds`: one for each world, negative: the
  // next one of its own. Parameters are kept for later episodes, too.
  void reset(std::span<const std::int64_t> seeds,
             std::span<const std::uint8_t> which = {},
             std::vector<given_parameter> parameters = {}) {
    need("seeds", seeds.size(), seeds.empty() ? 0 : count());
    need("flags of worlds to reset", which.size(), which.empty() ? 0 : count());
    for (const std::int64_t s : seeds)
      if (s >= most_seed)
        throw std::invalid_argument("a seed is below 2^53, and this one is " + std::to_string(s));
    auto changed = changed_with(std::move(parameters));
    if (!which.empty() && !has_begun_)
      for (const std::uint8_t w : which)
        if (!w) throw std::logic_error("the first reset has to reset all worlds");
    changes_ = std::move(changed);
    turn();
    has_begun_ = false;  // until all is done
    each([&](std::size_t i) {
      if (!which.empty() && !which[i]) return keep(i);
      if (!seeds.empty() && seeds[i] >= 0) seed(i, static_cast<std::uint64_t>(seeds[i]));
      begin(i);
    });
    has_begun_ = true;
  }

  // One row of actions for each world, in the order of the action space's axes.
  void step(std::span<const double> actions) {
    if (!has_begun_) throw std::logic_error("step() before reset(): reset all worlds first");
    need("actions", actions.size(), count() * commanded);
    check(actions);
    turn();
    has_begun_ = false;
    each([&](std::size_t i) { step(i, actions.subspan(i * commanded, commanded)); });
    has_begun_ = true;
  }

  void set_episode_steps(std::int64_t steps) { options_.episode_steps = steps; }
  std::size_t count() const { return places_.size(); }
  bool has_begun() const { return has_begun_; }
  const world_results& now() const { return results_[at_]; }
  int turn_of() const { return static_cast<int>(at_); }
  const world_options& options() const { return options_; }
  const firing_times& times() const { return times_; }
  double step_seconds() const { return 1e-9 * static_cast<double>(times_.period * controller::period()); }
  std::vector<std::string> parameter_paths() const { return loaded_.parameter_paths(); }

private:
  struct place {
    random_numbers random;
    std::uint64_t seed = 0, next_seed = 0;
    std::int64_t steps = 0;
    double sum = 0;
    bool is_over = false;
  };

  void need(const char* what, std::size_t there, std::size_t wanted) const {
    if (there == wanted) return;
    throw std::invalid_argument(std::to_string(there) + " " + what + " for " + std::to_string(count()) +
                                " worlds: " + std::to_string(wanted) + " are expected");
  }
  void check(std::span<const double> actions) const {
    for (std::size_t i = 0; i < actions.size(); ++i)
      if (!std::isfinite(actions[i]))
        throw std::invalid_argument("the action `" + described_.names[i % commanded] + "` of world " +
                                    std::to_string(i / commanded) + " is " + std::to_string(actions[i]) +
                                    ": actions are finite");
  }

  // Parameters are tried before anything changes.
  std::vector<given_parameter> changed_with(std::vector<given_parameter> given) const {
    std::vector<given_parameter> all = changes_;
    for (given_parameter& g : given) {
      need(g.path.c_str(), g.values.size(), g.values.size() == 1 ? 1 : count());
      controller trial = loaded_;
      for (std::size_t i = 0; i < g.values.size(); ++i) g.apply(trial, i);
      std::erase_if(all, [&](const given_parameter& old) { return old.path == g.path; });
      all.push_back(std::move(g));
    }
    return all;
  }

  template <class F>
  void each(F f) {
    sim::rollouts(count(),
                  [&](std::size_t i) {
                    try {
                      f(i);
                    } catch (const std::exception& e) {
                      throw refused("world " + std::to_string(i) + ": " + e.what());
                    }
                    return true;
                  },
                  {.threads = options_.threads});
  }

  void turn() { before_ = at_, at_ = 1 - at_; }
  world_results& results() { return results_[at_]; }

  void seed(std::size_t i, std::uint64_t s) {
    places_[i].random = random_numbers(s), places_[i].next_seed = s;
  }
  void begin(std::size_t i) {
    place& p = places_[i];
    p.seed = p.next_seed;
    p.next_seed = p.random.bits() >> 11;
    p.steps = 0, p.sum = 0, p.is_over = false;
    all_[i]->begin(loaded_, times_, p.seed, [&](controller& c) {
      for (const given_parameter& g : changes_) g.apply(c, i);
    });
    show(i, 0, false, false, false);
  }
  void step(std::size_t i, std::span<const double> action) {
    place& p = places_[i];
    if (p.is_over && options_.when_over == autoreset::next_step) return begin(i);
    if (p.is_over) return show(i, 0, now_before().terminations[i], now_before().truncations[i], false);
    all_[i]->step(action, times_);
    const bool is_over = all_[i]->is_over(),
               is_cut = !is_over && ++p.steps >= options_.episode_steps && options_.episode_steps > 0;
    if (is_over) ++p.steps;
    p.sum += all_[i]->reward();
    p.is_over = is_over || is_cut;
    show(i, all_[i]->reward(), is_over, is_cut, p.is_over);
    if (!p.is_over || options_.when_over != autoreset::same_step) return;
    world_results& r = results();
    const double sum = p.sum, reward = r.rewards[i];
    const std::int64_t steps = p.steps;
    const std::string fault = r.faults[i];
    std::copy_n(&r.observations[i * observed], observed, &r.final_observations[i * observed]);
    begin(i);
    r.rewards[i] = reward, r.terminations[i] = is_over, r.truncations[i] = is_cut, r.ended[i] = 1;
    r.returns[i] = sum, r.lengths[i] = steps, r.faults[i] = fault;
  }
  void show(std::size_t i, double reward, bool is_over, bool is_cut, bool ended) {
    world_results& r = results();
    const auto& seen = all_[i]->observations();
    std::copy_n(seen.data(), observed, &r.observations[i * observed]);
    r.rewards[i] = reward, r.terminations[i] = is_over, r.truncations[i] = is_cut, r.ended[i] = ended;
    r.returns[i] = places_[i].sum, r.lengths[i] = places_[i].steps;
    r.seeds[i] = static_cast<std::int64_t>(places_[i].seed);
    r.faults[i] = ended ? all_[i]->fault() : std::string();
  }
  // A world that is not reset shows what it showed.
  void keep(std::size_t i) { show(i, 0, now_before().terminations[i], now_before().truncations[i], false); }
  const world_results& now_before() const { return results_[before_]; }

  world_options options_;
  described_numbers described_;
  controller loaded_{};
  firing_times times_{};
  std::vector<std::unique_ptr<one>> all_;
  std::vector<place> places_;
  std::vector<given_parameter> changes_;
  std::array<world_results, 2> results_;
  std::size_t at_ = 0, before_ = 1;
  bool has_begun_ = false;
};

}  // namespace cca::python
