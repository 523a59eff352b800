#pragma once
// The trot as the teacher of the policy: both see the same robot and the same clock. One of them drives, the
// notebook keeps what the policy observes and what the teacher would do.
#include <cstddef>
#include <vector>

#include <cca/cca.hpp>
#include <cca/sim/oncilla.hpp>

#include "architecture.hpp"
#include "teacher.hpp"

namespace walking {

struct lesson {
  BOOST_HANA_DEFINE_STRUCT(lesson, (policy::network::input, observed), (policy::network::output, answer));
};

// Lets the command of the teacher or of the policy pass.
struct driver {
  auto process(cca::in<"taught", oncilla::leg_angles> taught, cca::in<"learned", oncilla::leg_angles> learned)
      -> cca::out<"angles", oncilla::leg_angles> {
    return by_teacher ? taught.vector() : learned.vector();
  }
  bool by_teacher = true;
};

template <class Observations>
struct notebook_of;

// The command of the policy is reached 9 beats after it has observed (smooth), so what the teacher wants then
// is the answer.
template <class... In>
struct notebook_of<cca::policy_inputs<In...>> {
  void process(In... inputs, cca::in<"taught", oncilla::leg_angles> taught, cca::beat now) {
    const auto part = now.index() % period;
    if (part == 0) {
      int at = 0;
      (void)((next.observed.template segment<In::space::size>(at) = inputs.vector(), at += In::space::size),
             ...);
    }
    if (part != period - 1 || lessons.size() == lessons.capacity()) return;
    next.answer = taught.vector();
    lessons.push_back(next);
  }
  std::vector<lesson> lessons;  // full at its capacity: it does not allocate in a beat

private:
  lesson next{};
};

struct notebook : notebook_of<observations> {};

// [school]
template <class Robot>
struct school : cca::graph<cca::rate<1000>,
                           cca::node<"gait", learned_gait>,
                           cca::node<"posture", teachers_posture, cca::timed<period>>,
                           cca::node<"teacher", teacher, cca::port_triggered<"phase">>,
                           cca::node<"driver", driver, cca::timed<1>>,
                           cca::node<"limits", cca::limiter<oncilla::leg_angles>>,
                           cca::node<"notebook", notebook, cca::timed<1>>,
                           cca::node<"robot", Robot>,

                           cca::wire<"robot.orientation", "gait.orientation", cca::latest>,
                           cca::wire<"robot.angular_velocity", "gait.rates", cca::latest>,
                           cca::wire<"robot.angles", "gait.angles", cca::latest>,
                           cca::wire<"gait.relative", "posture.orientation", cca::latest>,
                           cca::wire<"posture.turn", "teacher.turn", cca::latest>,
                           cca::wire<"posture.lean", "teacher.lean", cca::latest>,
                           cca::wire<"gait.phase", "teacher.phase">,
                           cca::wire<"gait.amplitude", "teacher.amplitude">,
                           cca::wire<"teacher.angles", "driver.taught">,
                           cca::wire<"gait.command", "driver.learned">,
                           cca::wire<"driver.angles", "limits.command">,
                           cca::wire<"robot.angles", "limits.measured">,
                           cca::wire<"limits.safe", "robot.command">,

                           cca::wire<"gait.clock", "notebook.clock", cca::latest>,
                           cca::wire<"gait.down", "notebook.down", cca::latest>,
                           cca::wire<"robot.angular_velocity", "notebook.rates", cca::latest>,
                           cca::wire<"gait.course", "notebook.course", cca::latest>,
                           cca::wire<"robot.angles", "notebook.angles", cca::latest>,
                           cca::wire<"teacher.angles", "notebook.taught", cca::latest>> {};
// [school end]

}  // namespace walking
