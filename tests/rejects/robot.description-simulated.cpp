// EXPECT: robot\.description: `drives` of other has 1 entry, and its body has 2 axes \(swing, bend\): give one for each axis
// A program of a simulated robot whose description is refused: the sentence alone, although the program asks
// for the world of the robot.
#include <cca/cca.hpp>
#include <cca/main.hpp>
#include <cca/sim/robot.hpp>

#include "pendulum.hpp"

#if CCA_REJECT
struct other : described<chain_of_two, 1> {};
#else
struct other : described<chain_of_two, 2> {};
#endif

struct falling : cca::graph<cca::node<"robot", cca::sim::robot<other>>> {};
struct falls : cca::robot_program<falling> {
  bool between(controller_type& c) override {
    return c.get<"robot.simulator">().world().end("arm").where.at[2] > 0;
  }
};

int main(int count, char** words) { return cca::robot_main<falls>(count, words); }
