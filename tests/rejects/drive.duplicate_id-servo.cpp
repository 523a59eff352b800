// EXPECT: drive\.duplicate_id: on the bus `left` the drives 1 \(n1\) and 2 \(n1\) both use the id 0x00008003
// A moteus hears every frame to its number, whoever sends it: another source does not make it another
// servo.
#include <cca/hardware/bus_plan.hpp>
#include <cca/hardware/moteus.hpp>

struct motor {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.05;
};
using hip = cca::hardware::moteus<motor, 3, 0>;
#if CCA_REJECT
using knee = cca::hardware::moteus<motor, 3, 1>;
#else
using knee = cca::hardware::moteus<motor, 4, 1>;
#endif

struct left
    : cca::hardware::can_bus_plan<"left", cca::hardware::bit_rates{1'000'000}, cca::rate<400>, hip, knee> {};

double used = left::load;
