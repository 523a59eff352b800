// Runs each law over all models that it applies to.
#include "spaces.hpp"

using namespace spaces;

TEST_SUITE("space laws") {
  TEST_CASE_TEMPLATE("a group", Model, orientation_model, pose_model) {
    laws::group<Model>();
    laws::action<Model>();
    laws::origins<Model>([](const auto& a, const auto& b) { return a * b; });
  }

  TEST_CASE_TEMPLATE("b plus the difference is a", Model, angle_model, phase_model, orientation_model,
                     plain_model<foot>) {
    laws::differences<Model>();
  }

  TEST_CASE_TEMPLATE("interpolation", Model, plain_model<leg_angles>, plain_model<leg_velocities>,
                     plain_model<leg_accelerations>, plain_model<leg_torques>, plain_model<leg_stiffness>,
                     plain_model<leg_damping>, plain_model<push>, plain_model<springs>, plain_model<dampers>,
                     plain_model<foot>, plain_model<motion>, plain_model<load>, plain_model<amplitudes>,
                     plain_model<frequencies>, plain_model<numbers>, phase_model, orientation_model,
                     pose_model) {
    laws::interpolation<Model>();
    laws::origins<Model>([](const auto& a, const auto& b) { return a.interpolated(b, 0.5); });
  }

  TEST_CASE_TEMPLATE("interpolation at constant speed", Model, plain_model<foot>, phase_model,
                     orientation_model) {
    laws::straight<Model>();
  }

  TEST_CASE_TEMPLATE("sums", Model, plain_model<leg_velocities>, plain_model<leg_accelerations>,
                     plain_model<leg_torques>, plain_model<leg_stiffness>, plain_model<leg_damping>,
                     plain_model<push>, plain_model<springs>, plain_model<dampers>, plain_model<motion>,
                     plain_model<load>, plain_model<amplitudes>, plain_model<frequencies>,
                     plain_model<numbers>) {
    laws::sums<Model>();
    laws::origins<Model>([](const auto& a, const auto& b) { return a + b; });
  }
}
