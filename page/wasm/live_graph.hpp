// The program of a page, from the type of its graph alone. What only a robot has is in a `Scene`, a value:
//
//   static constexpr const char* title;
//   static constexpr int extra_count, pose_count;   numbers of the robot in each row, and of its poses
//   void put_down(controller&)                      before it is loaded
//   void before_beat(controller&), after_beat(controller&)   what the world around the robot does
//   void add_shapes(json_text&)                     the bodies, as JSON
//   void extra(const controller&, double*)
//   void poses(const controller&, double*)
//   void push(controller&, double x, double y, double z, double seconds)
//
// and, where the program has buttons for its operator, and a plan:
//
//   static constexpr std::array buttons             their names
//   void press(controller&, int button, bool down)
//   bool is_pressed(const controller&, int button)
//   using plan                                      a cca::steps; the step is the port "sequencer.step"
//   static constexpr std::array plots               first_curve: what is plotted at first
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <cca/runtime/controller.hpp>

#include "architecture_json.hpp"
#include "live_program.hpp"
#include "parameter_fields.hpp"
#include "rows.hpp"

namespace cca::page {

struct first_curve {
  int plot;
  const char* port;
  int coordinate;
};

template <class Graph, class Scene>
class live_graph final : public live_program {
  using controller_type = controller<Graph>;
  static constexpr std::size_t most_snapshots = 120;
  static constexpr bool has_buttons = requires { Scene::buttons.size(); };
  struct snapshot {
    std::unique_ptr<controller_type> value;
    Scene scene;
    std::vector<double> newest, origins, published;
  };

public:
  live_graph() { begin_anew(); }

  std::string description() override {
    json_text json;
    json.open('{');
    add_architecture<Graph>(json, Scene::title);
    json.key("coordinates").add(page_tap<Graph>::coordinates).key("kept").add(row_ring::beats);
    add_parameters(json, *c);
    scene.add_shapes(json);
    json.key("buttons").open('[');
    if constexpr (has_buttons)
      for (const char* name : Scene::buttons) json.add(name);
    json.close(']');
    json.key("plots").open('[');
    if constexpr (requires { Scene::plots.size(); })
      for (const first_curve& one : Scene::plots)
        json.open('[').add(one.plot).add(one.port).add(one.coordinate).close(']');
    json.close(']');
    if constexpr (requires { typename Scene::plan; }) {
      json.key("plan").open('{').key("port").add("sequencer.step").key("steps").open('[');
      for (int i = 0; i < Scene::plan::count; ++i)
        json.add(Scene::plan::table[static_cast<std::size_t>(i)].name);
      json.close(']').close('}');
    }
    return json.close('}').text;
  }

  std::string parameters() override {
    json_text json;
    json.open('[');
    for (const double value : parameter_values(*c)) json.add(value);
    return json.close(']').text;
  }

  int advance(int beats) override {
    int done = 0;
    while (done < beats && is_started()) {
      const std::int64_t k = c->beat_index();
      // One that is there stays: what was changed since then is not in it.
      if (k % beats_a_second == 0 && (snapshots.empty() || snapshots.back().value->beat_index() < k))
        take_snapshot();
      if constexpr (requires { scene.before_beat(*c); }) scene.before_beat(*c);
      if (!c->step()) break;
      tap->take();
      scene.after_beat(*c);
      double* const row = ring.row(k);
      std::ranges::copy(tap->newest, row);
      scene.extra(*c, row + page_tap<Graph>::coordinates);
      ++done;
    }
    scene.poses(*c, poses_now.data());
    return done;
  }

  void begin_anew() override {
    const std::vector<double> old = c ? parameter_values(*c) : std::vector<double>();
    snapshots.clear();
    detach();
    c = std::make_unique<controller_type>();
    for (std::size_t i = 0; i < old.size(); ++i) set_field(*c, static_cast<int>(i), old[i]);
    scene = Scene();
    scene.put_down(*c);
    attach();
    scene.poses(*c, poses_now.data());
  }

  void change(int transition) override {
    switch (transition) {
      case 0:
        return c->load();
      case 1:
        return c->start();
      case 2:
        return c->stop();
      case 3:
        return c->resume();
      default:
        return c->save();
    }
  }

  std::string set(int field, double value) override {
    std::string refusal = set_field(*c, field, value);
    if (refusal.empty()) c->parameters_changed();
    return refusal;
  }

  void push(double x, double y, double z, double seconds) override { scene.push(*c, x, y, z, seconds); }

  void press([[maybe_unused]] int button, [[maybe_unused]] bool down) override {
    if constexpr (has_buttons)
      if (button >= 0 && button < static_cast<int>(Scene::buttons.size())) scene.press(*c, button, down);
  }

  void take_snapshot() override {
    const std::int64_t k = c->beat_index();
    std::erase_if(snapshots, [&](const snapshot& s) { return s.value->beat_index() >= k; });
    if (snapshots.size() == most_snapshots) snapshots.erase(snapshots.begin());
    snapshots.push_back(
        {std::make_unique<controller_type>(*c), scene, tap->newest, tap->origins, tap->published});
  }

  bool go_back(std::int64_t beat) override {
    const auto found =
        std::ranges::find(snapshots, beat, [](const snapshot& s) { return s.value->beat_index(); });
    if (found == snapshots.end()) return false;
    detach();
    *c = *found->value;
    scene = found->scene;
    attach();
    tap->newest = found->newest;
    tap->origins = found->origins;
    tap->published = found->published;
    std::erase_if(snapshots, [&](const snapshot& s) { return s.value->beat_index() > beat; });
    scene.poses(*c, poses_now.data());
    return true;
  }

  std::string status() override {
    json_text json;
    json.open('{').key("beat").add(c->beat_index()).key("state").add(to_string(c->state()));
    const cca::fault why = c->fault();
    json.key("fault").add(why ? why.reason() : "").key("faultPath").add(c->fault_path());
    json.key("snapshots").open('[');
    for (const snapshot& s : snapshots) json.add(s.value->beat_index());
    json.close(']').key("pressed").open('[');
    if constexpr (has_buttons)
      for (int i = 0; i < static_cast<int>(Scene::buttons.size()); ++i) json.add(scene.is_pressed(*c, i));
    return json.close(']').close('}').text;
  }

  double* rows() override { return ring.all(); }
  int row_width() override { return ring.width; }
  double* origins() override { return tap->origins.data(); }
  double* published() override { return tap->published.data(); }
  double* poses() override { return poses_now.data(); }

private:
  static constexpr std::int64_t beats_a_second =
      std::max<std::int64_t>(1, 1'000'000'000 / controller_type::period());

  bool is_started() const { return c->state() == state::started || c->state() == state::running; }
  void detach() {
    if (c) c->record_into(nullptr);
  }
  void attach() {
    tap = std::make_unique<page_tap<Graph>>();
    c->record_into(tap.get());
  }

  std::unique_ptr<page_tap<Graph>> tap;  // lives longer than what it looks at
  std::unique_ptr<controller_type> c;
  Scene scene;
  std::vector<snapshot> snapshots;
  row_ring ring{page_tap<Graph>::coordinates + Scene::extra_count};
  std::vector<double> poses_now = std::vector<double>(Scene::pose_count + 1);
};

}  // namespace cca::page
