// A program behind a door that takes requests when the test says so, and remembers what it was asked.
#pragma once

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <cca/door/controls.hpp>

namespace door_test {

class fake_controls final : public cca::detail::door_controls {
public:
  using how = cca::detail::door_outcome::how;
  using about = cca::detail::door_request::what;
  using value = cca::detail::door_value;

  fake_controls() {
    text.program = "fake";
    text.architecture = "loop\n";
    text.modes = {"walk", "stand"};
    text.parts = {"arm"};
    text.nodes = {"gait", "robot"};
    text.wires = {{"gait.angles", "robot.commands"}};
    text.commands = {
        {"push", "pushes the body", {{"force", "N", 0, -50, 50}, {"angle", "rad", 0, -3, 3}}, true},
        {"wave", "waves once", {}, false}};
    known = {{"gait.frequency", value{.number = 1.5}, "Hz", 0.1, 5.0},
             {"gait.steps", value{.what = value::kind::integer, .integer = 3}, "", 1.0, 9.0},
             {"gait.is_on", value{.what = value::kind::boolean, .integer = 1}},
             {"gait.kind", value{.what = value::kind::text, .text = "trot"}, "", {}, {}, {"trot", "walk"}},
             {"gait.gains", value{.what = value::kind::numbers, .numbers = {1, 2, 3}}, "", 0.0, 10.0}};
  }

  // Before the door is made: an input that may be tested.
  void offer_test() {
    text.nodes.emplace_back("test_servo_reference");
    text.tests = {{"servo.reference", "test_servo_reference", "rad", {"0"}, 0.5}};
    const std::string node = "test_servo_reference.";
    const auto whole = value{.what = value::kind::integer};
    const std::vector<cca::detail::door_parameter> more{
        {node + "signal",
         value{.what = value::kind::text, .text = "off"},
         "",
         {},
         {},
         {"off", "step", "sine", "chirp", "linear_chirp"}},
        {node + "axis", whole, "", 0.0, 0.0},
        {node + "amplitude", value{.number = 0}, "rad", -0.5, 0.5},
        {node + "frequency", value{.number = 1}, "Hz", 1e-3, 1e5},
        {node + "to", value{.number = 10}, "Hz", 1e-3, 1e5},
        {node + "duration", value{.number = 10}, "s", 1e-3, 600.0},
        {node + "run", whole, "", 0.0, 1e9}};
    known.insert(known.end(), more.begin(), more.end());
  }

  const cca::detail::door_description& description() const override { return text; }
  cca::detail::door_status status() const override {
    if (throws) throw std::runtime_error("the fake throws");
    const std::scoped_lock lock(guard);
    auto now = state;
    now.beat = ++beats;
    return now;
  }
  std::vector<cca::detail::door_environment> environments() const override {
    return {{.name = "main", .beats = 7}};
  }
  std::string recording_problem() const override {
    const std::scoped_lock lock(guard);
    return state.recording_problem;
  }
  std::optional<std::vector<cca::detail::door_parameter>> parameters() override {
    const std::scoped_lock lock(guard);
    if (answer == how::busy) return {};
    return known;
  }
  cca::detail::door_outcome begin(const cca::detail::door_request& one) override {
    const std::scoped_lock lock(guard);
    if (one.about != about::end_run) {
      if (answer == how::busy || waiting) return {how::busy};
      if (answer == how::refused) return {how::refused, "the fake refuses"};
    }
    if (answer == how::begun && one.about != about::end_run) {
      waiting = one;
      return {how::begun};
    }
    take(one);
    return {how::done};
  }
  cca::detail::door_outcome outcome() override {
    const std::scoped_lock lock(guard);
    if (!waiting) return {how::done};
    if (answer == how::begun) return {how::begun};
    const auto one = *waiting;
    waiting.reset();
    if (answer == how::refused) return {how::refused, "the fake refuses"};
    take(one);
    return {how::done};
  }
  void note(std::string_view client, std::string_view what) override {
    const std::scoped_lock lock(guard);
    notes.push_back(std::string(client) + " " + std::string(what));
  }

  // For the thread of the test.
  std::atomic<bool> throws{false};
  void answers(how now) {
    const std::scoped_lock lock(guard);
    answer = now;
  }
  std::vector<cca::detail::door_request> asked() const {
    const std::scoped_lock lock(guard);
    return taken;
  }
  std::vector<std::string> noted() const {
    const std::scoped_lock lock(guard);
    return notes;
  }
  void recording_fails(const std::string& why) {
    const std::scoped_lock lock(guard);
    state.recording_problem = why;
  }
  bool was_asked(about what, const std::string& name = "") const {
    const auto all = asked();
    return std::any_of(all.begin(), all.end(), [&](const auto& one) {
      return one.about == what && (name.empty() || one.text == name);
    });
  }
  void change(const std::string& path, value now) {
    const std::scoped_lock lock(guard);
    for (auto& one : known)
      if (one.path == path) one.value = std::move(now);
  }

private:
  cca::detail::door_description text{};
  mutable std::mutex guard{};
  mutable std::int64_t beats = 0;
  how answer = how::done;
  cca::detail::door_status state{.state = "running", .period = 1000000};
  std::vector<cca::detail::door_parameter> known{};
  std::optional<cca::detail::door_request> waiting{};
  std::vector<cca::detail::door_request> taken{};
  std::vector<std::string> notes{};

  void take(const cca::detail::door_request& one) {
    taken.push_back(one);
    if (one.about == about::pause) state.is_paused = true;
    if (one.about == about::go_on) state.is_paused = false;
    if (one.about == about::speed) state.speed = one.number;
    if (one.about == about::switch_mode) state.mode = one.text;
    if (one.about == about::end_run) state.state = "loaded", waiting.reset();  // no beat takes it any more
    if (one.about == about::load)                                              // a file that says so
      for (auto& p : known)
        if (p.path == "gait.frequency") p.value.number = 0.7;
    if (one.about == about::set)
      for (const auto& [path, now] : one.values)
        for (auto& p : known)
          if (p.path == path) p.value = now;
  }
};

}  // namespace door_test
