// The recording of a fault in the field as a test: it finds the fault again, and shows what the repair
// changes.
//
//   recordings_replay field.mcap     (by `recordings_field --record field.mcap`)
//
// Exit code 0: the fault is reproduced, and the repaired controller does not have it. docs/recordings.md
#include <exception>
#include <iostream>
#include <string>

#include <cca/record.hpp>

#include "leg.hpp"

namespace {

int test(const std::string& file) {
  // [test]
  const auto field = cca::recording::replay<leg_loop<difference>>(file);
  std::cout << "as in the field: " << field << '\n';
  const bool is_reproduced = field && field.fault == "`guard`: the hip is faster than 10 rad/s";

  const auto repaired = cca::recording::replay<leg_loop<checked_difference>>(file);
  std::cout << "repaired: " << repaired << '\n';
  const bool is_repaired =
      repaired.component == "velocity" && repaired.beat == 1234 && repaired.fault.empty();
  // [test end]
  return is_reproduced && is_repaired ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 2) return test(words[1]);
    std::cerr << "usage: recordings_replay FILE.mcap\n";
  } catch (const std::exception& e) { std::cerr << "recordings_replay: " << e.what() << '\n'; }
  return 2;
}
