// A transport that is not the library's: the code of docs/transports.md, "An own transport".
#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include <cca/deployment.hpp>

#include "../../laws/transport_laws.hpp"

using namespace deployment_test;

namespace {

// [own transport]
// What all see: the numbers and samples of the deployment, and which environments somebody runs.
template <class D>
struct table {
  cca::exchange<D> exchanged;
  std::array<std::atomic<bool>, std::tuple_size_v<cca::environments_here<D>>> is_run{};
};

// One place at it, for as long as a cca::deployed has it.
template <class D>
class place : public cca::peers {
public:
  place(std::shared_ptr<table<D>> at, const cca::environments_here<D>& is_here)
      : here(is_here), all(std::move(at)) {
    for (std::size_t e = 0; e < here.size(); ++e)
      if (here[e] && all->is_run[e].exchange(true)) {
        while (e-- > 0)
          if (here[e]) all->is_run[e] = false;
        throw cca::refused("somebody runs it already");
      }
  }
  ~place() override {
    for (std::size_t e = 0; e < here.size(); ++e)
      if (here[e]) all->is_run[e] = false;
  }
  cca::exchange<D>* exchanged() { return &all->exchanged; }
  bool is_gone(int environment) const override { return !all->is_run[static_cast<std::size_t>(environment)]; }

private:
  cca::environments_here<D> here;
  std::shared_ptr<table<D>> all;
};

// The transport: it joins threads of one program which have a cca::deployed each.
template <class D>
struct at_one_table {
  std::shared_ptr<table<D>> all = std::make_shared<table<D>>();

  template <std::same_as<D> Asked>  // of another deployment it is none
  std::shared_ptr<place<D>> open(const cca::environments_here<D>& here) const {
    return std::make_shared<place<D>>(all, here);
  }
};
static_assert(cca::Transport<at_one_table<two>, two>);
// [own transport end]

struct other : cca::deployment<architecture,
                               cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                               cca::environment<"mind", cca::other_nodes>> {};

// One thing that is missing, in each.
struct no_open {};
struct raw_pointer {
  template <class D>
  place<D>* open(const cca::environments_here<D>&) const;
};
struct not_const {
  template <class D>
  std::shared_ptr<place<D>> open(const cca::environments_here<D>&);
};
template <class D>
struct without_exchange : cca::peers {
  bool is_gone(int) const override { return false; }
};
template <class D>
struct without_peers {
  cca::exchange<D>* exchanged();
};
template <class D>
struct of_another : cca::peers {
  cca::exchange<other>* exchanged();
  bool is_gone(int) const override { return false; }
};
template <template <class> class Medium>
struct opens {
  template <class D>
  std::shared_ptr<Medium<D>> open(const cca::environments_here<D>&) const;
};

static_assert(cca::Transport<cca::shared_memory, two>);
static_assert(cca::Transport<opens<place>, two>);
static_assert(!cca::Transport<at_one_table<two>, other>);
static_assert(!cca::Transport<no_open, two>);
static_assert(!cca::Transport<raw_pointer, two>);
static_assert(!cca::Transport<not_const, two>);
static_assert(!cca::Transport<opens<without_exchange>, two>);
static_assert(!cca::Transport<opens<without_peers>, two>);
static_assert(!cca::Transport<opens<of_another>, two>);
static_assert(!cca::Transport<const char*, two>);
static_assert(!cca::Transport<int, two>);

}  // namespace

TEST_SUITE("own transport") {
  TEST_CASE("over it a deployment has the bits of the one loop") {
    const at_one_table<two> joined;
    std::string of_mind;
    std::thread mind([&] {
      cca::deployed<two> d(cca::only{"mind"}, joined);
      of_mind = transport_laws::story(d, transport_laws::tell_mind);
    });
    cca::deployed<two> d(cca::only{"robot"}, joined);
    const std::string of_robot = transport_laws::story(d, transport_laws::tell_robot);
    mind.join();
    cca::controller<architecture> one, other;
    CHECK_EQ(of_robot, transport_laws::story(one, transport_laws::tell_robot));
    CHECK_EQ(of_mind, transport_laws::story(other, transport_laws::tell_mind));
    CHECK(of_robot.find("faulted too much") != std::string::npos);
  }

  // A transport that sends these numbers asks whether anybody waits for them (cca/dds/deployment/sender.hpp).
  TEST_CASE("the numbers of an environment say how the run is, not what its process had wished for") {
    const at_one_table<two> joined;
    std::thread mind([&] {
      cca::deployed<two> d(cca::only{"mind"}, joined);
      d.load();
      d.start();
      d.run(cca::without_end{});  // at the pace of the robot
      d.run(cca::without_end{});
    });
    cca::deployed<two> d(cca::only{"robot"}, joined);
    d.load();
    d.start();
    const auto& of_mind = joined.all->exchanged.environments[1];
    std::vector<std::string> said;
    const auto look = [&](auto&) {
      said.push_back(std::string(of_mind.is_exact ? "a fast run" : "a wall-clock run") +
                     (of_mind.all_meet ? ", all meet" : ""));
    };
    d.run(cca::for_beats<1>{}, cca::at_speed(0.1), look);
    d.run(cca::for_beats<1>{}, {}, look);
    mind.join();
    CHECK(said == std::vector<std::string>{"a wall-clock run, all meet", "a fast run, all meet"});
  }

  TEST_CASE("what it refuses, the constructor refuses") {
    const at_one_table<two> joined;
    {
      cca::deployed<two> d(cca::only{"mind"}, joined);
      CHECK_THROWS_AS(cca::deployed<two>(cca::only{"mind"}, joined), cca::refused);
      CHECK_THROWS_AS(cca::deployed<two>(cca::only({"robot", "mind"}), joined), cca::refused);
      CHECK_NOTHROW(cca::deployed<two>(cca::only{"robot"}, joined));
    }
    CHECK_NOTHROW(cca::deployed<two>(cca::only{"mind"}, joined));
  }
}
