// The code of docs/environments.md.
#include <doctest/doctest.h>

#include <unistd.h>

#include <sstream>
#include <string>

#include <cca/config.hpp>

#include "../../laws/temporary_file.hpp"
#include "robot_and_mind.hpp"

using namespace deployment_test;

namespace {

// [realtime]
struct on_cores : cca::deployment<architecture,
                                  cca::environment<"robot",
                                                   cca::nodes<"device", "filter", "guard">,
                                                   cca::realtime_if_allowed<80, cca::on_core<0>>>,
                                  cca::environment<"mind", cca::other_nodes>> {};
// [realtime end]
static_assert(cca::check<on_cores>());
static_assert(cca::detail::wish_of_environment<on_cores, 0>.priority == 80);

}  // namespace

TEST_SUITE("deployment pages") {
  TEST_CASE("figures, read at any time") {
    std::ostringstream out;
    // [figures]
    cca::deployed<two> d;
    d.load();
    d.start();
    d.run(cca::for_<0.1>{}, cca::at_wall_clock());
    for (const cca::environment_figures& e : d.figures())
      out << e.name << ": wakes within " << e.wake_up.quantile(0.99) / 1000 << " us in 99 of 100 beats\n";
    // [figures end]
    CHECK(out.str().starts_with("robot: wakes within "));
  }

  TEST_CASE("a process takes its part") {
    const std::string name = "/cca_pages_" + std::to_string(::getpid());
    // [processes]
    cca::deployed<two> d(cca::only{"robot"}, cca::shared_memory(name));  // another process runs `mind`
    // [processes end]
    CHECK_EQ(d.state(), cca::state::created);
  }

  TEST_CASE("parameters and components by the paths of the architecture") {
    const laws::temporary_file deployed_file("deployment.toml"), one_loop_file("one_loop.toml");
    const auto &file = deployed_file.path, &again = one_loop_file.path;
    // [access]
    cca::deployed<two> d;
    d.load();
    d.set<"filter">({0.2});  // runs in `robot`
    d.set("guard.most", 50.0);
    d.start();
    d.run(cca::for_<0.1>{});
    const double sum = d.get<"thinker">().sum;  // runs in `mind`
    d.save(file);

    cca::controller<architecture> c;  // one loop
    c.load(file);                     // the same file
    // [access end]
    c.start();
    c.run(cca::for_<0.1>{});
    CHECK_EQ(c.get<"thinker">().sum, sum);
    CHECK_NE(sum, 0);
    CHECK_EQ(c.get<"filter">().p.gain, 0.2);
    CHECK_EQ(c.parameter<double>("guard.most"), 50.0);
    c.save(again);
  }

  TEST_CASE("a deployment is a graph: one loop runs it too") {
    // [as graph]
    static_assert(cca::check<two>());
    static_assert(cca::diagnosis<two>.rule.empty());
    cca::controller<two> c;  // in one loop, with the same results
    // [as graph end]
    c.load();
    c.start();
    CHECK_EQ(c.run(cca::for_<0.1>{}), cca::state::started);
    cca::deployed<two> d;
    d.load();
    d.start();
    d.run(cca::for_<0.1>{});
    CHECK_EQ(c.get<"thinker">().sum, d.get<"thinker">().sum);
  }
}
