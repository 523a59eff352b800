// A component of one's own asks a module to learn, and looks at the answer: the code of docs/learners.md.
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include <cca/motor/modules/gmr_module.hpp>

#include "rig.hpp"

using namespace adaptive_test;

namespace {

struct lesson_time : cca::space<cca::number, cca::axes<cca::x>> {};
struct button_port : cca::space<cca::status, cca::axes<cca::x>> {};
enum class key { released, pressed };

struct teacher {
  auto process(cca::beat now) -> std::tuple<cca::out<"time", lesson_time>, cca::out<"angles", leg>> {
    const double t = std::fmod(1e-9 * static_cast<double>(now.time()), 1);
    return {t, Eigen::Vector2d(0.3 * std::sin(3 * t), 0.2 * std::cos(2 * t))};
  }
};
struct button {
  auto process(cca::beat) -> cca::out<"pressed", button_port> {
    return cca::status_of(is_pressed ? key::pressed : key::released);
  }
  bool is_pressed = false;
};

// [own request]
// Collects while a button is pressed, and learns when it is released.
struct trainer {
  auto process(cca::in<"button", button_port> button, cca::in<"module", cca::module_status_port> module)
      -> cca::maybe<"learn", cca::learning_request> {
    state = module.as<cca::learning>(cca::learning_axis{});
    answer = module.as<cca::learning_answer>(cca::answer_axis{});
    const bool now = button.is(key::pressed);
    if (now == was_pressed) return {};  // asks once
    was_pressed = now;
    return cca::status_of(now ? cca::learning_call::collect : cca::learning_call::batch);
  }
  cca::learning state{};
  cca::learning_answer answer{};
  bool was_pressed = false;
};
// [own request end]

struct school : cca::graph<cca::rate<1000>,
                           cca::node<"teacher", teacher>,
                           cca::node<"button", button>,
                           cca::node<"trainer", trainer>,
                           cca::node<"movement", cca::gmr_module<lesson_time, leg, 4>>,
                           cca::wire<"teacher.time", "movement.input">,
                           cca::wire<"teacher.angles", "movement.reference">,
                           cca::wire<"teacher.angles", "movement.demonstration">,
                           cca::wire<"button.pressed", "trainer.button">,
                           cca::wire<"movement.module", "trainer.module", cca::delayed<1>>,
                           cca::wire<"trainer.learn", "movement.learn">> {};

}  // namespace

TEST_CASE("a component of one's own asks a module to learn, and hears the answer") {
  cca::controller<school> c;
  c.load();
  c.start();
  auto& trainer = c.get<"trainer">();
  const auto press = [&](bool is_pressed, int beats) {
    c.get<"button">().is_pressed = is_pressed;
    for (int k = 0; k < beats; ++k) c.step();
  };
  press(false, 5);
  CHECK(trainer.state == cca::learning::idle);
  CHECK(trainer.answer == cca::learning_answer::none);
  press(true, 200);
  CHECK(trainer.state == cca::learning::collecting);
  CHECK(trainer.answer == cca::learning_answer::accepted);
  press(false, 2);
  for (int k = 0; k < 20000 && trainer.state != cca::learning::trained; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    c.step();
  }
  CHECK(trainer.state == cca::learning::trained);
}
