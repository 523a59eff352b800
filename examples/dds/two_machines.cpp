// Two environments on two machines, over Cyclone DDS: on one `dds_two_machines --only robot --dds 7`, on the
// other the same with `--only mind`, both with CYCLONEDDS_URI (docs/transports.md). Without that variable
// both run on this machine; without both options they are two threads of one process. The robot's process
// compares the leg with that of one loop, bit for bit. A signal to one ends both in order.
#include <cstdio>
#include <optional>
#include <vector>

#include <cca/dds.hpp>
#include <cca/main.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>  // offers --record
#endif
#if __has_include(<cca/door.hpp>)
#include <cca/door.hpp>  // offers --door
#endif

#include "../deployment/one_loop.hpp"

namespace {

struct program : cca::robot_program<split> {
  program() {
    purpose = "a leg and its thoughts, on one machine or on two, over Cyclone DDS";
    settings.seconds = 0.3;
    settings.speed.reset();  // a fast run
  }

  // [transport]
  void options(cca::command_line& line) override {
    transport<cca::dds::domain>(line, "--dds DOMAIN", "reaches the others by DDS, in this domain",
                                [this](const auto& chosen) { net = chosen; });
  }
  // [transport end]

  bool between(controller_type& c) override {
    if (runs("robot")) angles.push_back(c.get<"leg">().angle);
    return true;
  }

  int finish(controller_type& c) override {
    // [refusals]
    if (net)
      for (const auto& one : net->refusals())
        std::printf("refused from %s: %s (%lld times)\n", one.who.c_str(), one.why.c_str(),
                    static_cast<long long>(one.count));
    // [refusals end]
    return runs("robot") ? compare_with_one_loop(angles, c) : 0;
  }

  std::optional<cca::dds::domain> net;
  std::vector<double> angles;
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
