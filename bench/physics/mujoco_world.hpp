#pragma once
// A world of MuJoCo with the Oncilla of its description, if BENCH_MUJOCO is defined (Debian: libmujoco-dev).
#ifdef BENCH_MUJOCO
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include <mujoco/mujoco.h>

#include <cca/sim/robot/model/cable_winch.hpp>

#include "commands_of_trot.hpp"
#include "mujoco_model.hpp"

namespace bench {

namespace sim = cca::sim;

// The names of robot_world, as far as they are asked for here.
class mujoco_world {
public:
  mujoco_world(const char* solver, const char* cone, int steps_per_beat = 2)
      : steps(steps_per_beat), text_(1e-3 / steps, solver, cone) {
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "robot.xml", static_cast<int>(text_.text.size()));
    std::memcpy(files->filedata[0], text_.text.data(), text_.text.size());
    char error[1000] = "";
    m = mj_loadXML("robot.xml", files.get(), error, sizeof error);
    mj_deleteVFS(files.get());
    if (!m) std::fprintf(stderr, "MuJoCo does not take the model: %s\n", error), std::exit(1);
    d = mj_makeData(m);
    for (std::size_t c = 0; c < 16; ++c) {
      joint_[c] = mj_name2id(m, mjOBJ_JOINT, text_.leader[c].c_str());
      drive_[c] = mj_name2id(m, mjOBJ_ACTUATOR, ("drive" + std::to_string(c)).c_str());
    }
  }
  mujoco_world(const mujoco_world&) = delete;
  mujoco_world& operator=(const mujoco_world&) = delete;
  ~mujoco_world() { mj_deleteData(d), mj_deleteModel(m); }

  void place(const std::array<double, 16>& q, double height) {
    for (int i = 0; i < static_cast<int>(links.size()); ++i)
      d->qpos[m->jnt_qposadr[joint_of(i)]] =
          links[static_cast<std::size_t>(i)].ratio *
          q[static_cast<std::size_t>(links[static_cast<std::size_t>(i)].coordinate)];
    d->qpos[2] = height;
    for (std::size_t c = 0; c < 16; ++c) winches_[c] = {.position = q[c]};
    mj_forward(m, d);
  }
  void advance(const laws_of_oncilla& laws) {
    for (std::size_t c = 0; c < 16; ++c) winches_[c].aim(laws[c].position, 1e-3);
    for (int s = 0; s < steps; ++s) {
      for (std::size_t c = 0; c < 16; ++c) {
        if (drive_[c] < 0) continue;
        if (walking::drives[c].cable.stiffness > 0) {
          winches_[c].torque = d->actuator_force[drive_[c]];
          winches_[c].wind(walking::drives[c].motor, 1e-3 / steps);
          d->ctrl[drive_[c]] = winches_[c].position;
        } else {
          d->ctrl[drive_[c]] = laws[c].position;
        }
      }
      mj_step(m, d);
    }
  }
  double height() const { return d->qpos[2]; }
  double forward() const { return d->qpos[0]; }
  double load() const {
    double sum = 0;
    for (int i = 0; i < d->ncon; ++i) {
      mjtNum f[6];
      mj_contactForce(m, d, i, f);
      sum += f[0];  // on level ground
    }
    return sum;
  }
  int joint_of(int link) const {
    return mj_name2id(m, mjOBJ_JOINT, ("joint" + std::to_string(link)).c_str());
  }

  int steps;  // per beat
  static constexpr const auto& links = sim::detail::compiled_tree<walking>::described.links;
  mjModel* m = nullptr;
  mjData* d = nullptr;

private:
  mjcf<walking> text_;
  std::array<int, 16> joint_{}, drive_{};
  std::array<sim::cable_winch, 16> winches_{};
};

}  // namespace bench
#endif
