// The code of docs/programs.md.
#include <doctest/doctest.h>

#include <cstdio>
#include <optional>
#include <string>

// [least]
#include <cca/main.hpp>

#include "../deployment/robot_and_mind.hpp"  // the deployment `two`

using deployment_test::two;

int walk(int count, char** words) { return cca::robot_main<two>(count, words); }  // `main` of the program
// [least end]

#include "child.hpp"

namespace {

// [options]
struct walking : cca::robot_program<two> {
  void options(cca::command_line& line) override {
    line.number("--gain G", gain, 0, 1, "of the filter (as in the parameters)");
    line.text("--csv FILE", csv, "writes what was measured");
  }
  void loaded(controller_type& c) override {
    if (gain) c.set<"filter">({*gain});
  }
  int finish(controller_type& c) override {
    std::printf("gain %g", c.get<"filter">().p.gain);
    return 0;
  }
  std::optional<double> gain;
  std::string csv;
};
// [options end]

}  // namespace

TEST_SUITE("programs pages") {
  TEST_CASE("the least program, and one with options") {
    CHECK_EQ(programs_test::child(walk, {"--seconds", "0.01"}).code(), 0);
    programs_test::child one(cca::robot_main<walking>, {"--seconds", "0.01", "--gain", "0.25", "--quiet"});
    CHECK_EQ(one.code(), 0);
    CHECK_EQ(one.out, "gain 0.25");
  }
}
