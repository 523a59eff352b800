// The generated wiring of a robot's joints, for a robot of seven joints that has nothing else.
#include <tuple>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/robots/joints.hpp>
#include <cca/robots/record.hpp>
#include <cca/space/record.hpp>

namespace {

namespace robots = cca::robots;

template <cca::fixed_string Name>
struct arm_axis : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 2}, cca::velocity{-3, 3}, cca::torque{-9, 9}};
};
struct a1 : arm_axis<"a1"> {};
struct a2 : arm_axis<"a2"> {};
struct a3 : arm_axis<"a3"> {};
struct a4 : arm_axis<"a4"> {};
struct a5 : arm_axis<"a5"> {};
struct a6 : arm_axis<"a6"> {};
struct a7 : arm_axis<"a7"> {};
using arm_axes = cca::axes<a1, a2, a3, a4, a5, a6, a7>;

struct arm_angles : cca::space<cca::joint_angles, arm_axes, cca::rate<500>> {};
struct arm_velocities : cca::space<cca::joint_velocities, arm_axes, cca::rate<500>> {};
struct arm_torques : cca::space<cca::joint_torques, arm_axes, cca::rate<500>> {};

template <class Axis>
struct angle : cca::space<cca::joint_angles, cca::axes<Axis>, cca::rate<500>> {};
template <class Axis>
struct velocity : cca::space<cca::joint_velocities, cca::axes<Axis>, cca::rate<500>> {};
template <class Axis>
struct torque : cca::space<cca::joint_torques, cca::axes<Axis>, cca::rate<500>> {};

template <class Axis>
struct joint_record : robots::record_of<robots::field<"angle", angle<Axis>>,
                                        robots::field<"velocity", velocity<Axis>>,
                                        robots::field<"torque", torque<Axis>>> {};
template <class Axis>
struct measured : cca::space<cca::record<joint_record<Axis>::size>, cca::axes<Axis>, cca::rate<500>> {};

template <class Axis>
struct joint {
  using record = joint_record<Axis>;
  auto sense(cca::in<"measured", measured<Axis>> now) -> std::tuple<cca::out<"angle", angle<Axis>>,
                                                                    cca::out<"velocity", velocity<Axis>>,
                                                                    cca::out<"torque", torque<Axis>>> {
    const auto& v = now.vector();
    return {record::template part<"angle">(v), record::template part<"velocity">(v),
            record::template part<"torque">(v)};
  }
  auto act(cca::in<"command", angle<Axis>> wanted) -> cca::out<"target", angle<Axis>> {
    return wanted.vector();
  }
};

// Each joint stands at its target; its velocity and torque are 10 and 100 times its angle.
template <class Axes>
struct echo_of;
template <class... Axes>
struct echo_of<cca::axes<Axes...>> {
  auto sense() -> std::tuple<cca::out<Axes::label, measured<Axes>>...> {
    return {Eigen::Vector3d(1, 10, 100) * at[arm_axes::index_of<Axes>]...};
  }
  void act(cca::in<Axes::label, angle<Axes>>... targets) {
    ((at[arm_axes::index_of<Axes>] = targets[Axes{}]), ...);
  }
  arm_angles::vector_type at = arm_angles::vector_type::Zero();
};
struct echo : echo_of<arm_axes> {};

struct arm : robots::graph_of<robots::items<cca::rate<500>, cca::node<"bus", echo>>,
                              robots::joint_nodes<joint, arm_axes>,
                              robots::whole_robot_nodes<arm_angles, arm_velocities, arm_torques>,
                              robots::joint_wires<"bus", "bus", arm_axes>,
                              robots::joint_ports> {};

struct wave {
  auto process(cca::beat now) -> cca::out<"angles", arm_angles> {
    arm_angles::vector_type v;
    for (int i = 0; i < arm_angles::size; ++i) v[i] = 0.1 * i + 0.001 * static_cast<double>(now.index());
    return v;
  }
};
struct listener {
  void process(cca::in<"angles", arm_angles> q,
               cca::in<"velocities", arm_velocities> v,
               cca::in<"torques", arm_torques> t) {
    angles = q.vector(), velocities = v.vector(), torques = t.vector();
  }
  arm_angles::vector_type angles, velocities, torques;
};

struct waving : cca::graph<cca::rate<500>,
                           cca::node<"wave", wave>,
                           cca::node<"limits", cca::limiter<arm_angles>>,
                           cca::node<"arm", arm>,
                           cca::node<"listener", listener>,
                           cca::wire<"wave.angles", "limits.command">,
                           cca::wire<"limits.safe", "arm.command">,
                           cca::wire<"arm.angles", "listener.angles">,
                           cca::wire<"arm.velocities", "listener.velocities">,
                           cca::wire<"arm.torques", "listener.torques">> {};

static_assert(cca::well_formed<waving>);

}  // namespace

TEST_SUITE("robots") {
  TEST_CASE("seven joints, wired from the list of axes: each command comes back as the angle of its axis") {
    cca::controller<waving> c;
    c.load();
    c.start();
    for (int k = 0; k < 20; ++k) {
      const arm_angles::vector_type before = c.get<"arm.bus">().at;
      REQUIRE(c.step());
      const listener& heard = c.get<"listener">();
      REQUIRE(heard.angles == before);
      REQUIRE(heard.velocities == 10 * before);
      REQUIRE(heard.torques == 100 * before);
      for (int i = 0; i < arm_angles::size; ++i)
        REQUIRE(c.get<"arm.bus">().at[i] == doctest::Approx(0.1 * i + 0.001 * k));
    }
  }

  TEST_CASE("a record's fields lie one after another, in the order of the list") {
    using record = robots::record_of<robots::field<"all", arm_angles>, robots::field<"one", angle<a2>>>;
    static_assert(record::size == 8);
    Eigen::Matrix<double, 8, 1> v = Eigen::Matrix<double, 8, 1>::Zero();
    record::part<"one">(v)[0] = 5;
    record::part<"all">(v)[6] = 4;
    CHECK(v[7] == 5);
    CHECK(v[6] == 4);
  }
}
