// The same arm as a whole program: command line, recording, replay, page.
#include <cca/main.hpp>
#include <cca/record.hpp>
#include <cca/record/replay_option.hpp>

#include "arm.hpp"

namespace {

struct program_of_arm : circling::simulated, cca::recordable {};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program_of_arm>(count, words); }
