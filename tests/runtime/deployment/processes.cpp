// The environments of a deployment in processes of their own, over POSIX shared memory.
#include <doctest/doctest.h>

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <cca/config.hpp>
#include <cca/runtime/transports/shared_memory.hpp>

#include "../../laws/free_running_laws.hpp"
#include "../../laws/free_running_queue_laws.hpp"
#include "../../laws/transport_laws.hpp"

using namespace deployment_test;

namespace {

struct over_shared_memory {
  static auto transport(const std::string& name) { return cca::shared_memory(name); }
  static std::string other_name() {
    static int number = 0;
    return "/cca_test_" + std::to_string(::getpid()) + "_" + std::to_string(number++);
  }
};

struct tick {
  auto process() -> cca::out<"y", level> { return 1.0; }
};
struct rare {
  void process(cca::in<"x", level>) {}
};
struct sleepy : cca::deployment<cca::graph<cca::rate<1000>,
                                           cca::node<"tick", tick>,
                                           cca::node<"rare", rare, cca::timed<20>>,
                                           cca::wire<"tick.y", "rare.x", cca::delayed<20>>>,
                                cca::environment<"robot", cca::nodes<"tick">>,
                                cca::environment<"mind", cca::other_nodes>> {};

// While it waits for the others to call `run`, its process stops.
struct stands_still_while_it_waits {
  bool is_over() const {
    if (std::exchange(is_first, false)) ::raise(SIGSTOP);
    return false;
  }
  bool operator()(auto&) const { return true; }
  mutable bool is_first = true;
};

// The memory of a process of another program, which says that it runs `mind`.
class other_memory {
public:
  other_memory(const std::string& name, const std::string& bytes) : file(name) {
    file.make_anew(bytes.size());
    void* const at = file.map(bytes.size());
    std::memcpy(at, bytes.data(), bytes.size());
    ::munmap(at, bytes.size());
    file.lock(byte_of_mind);
  }
  void end() const { file.unlock(byte_of_mind); }
  ~other_memory() { file.remove(); }
  other_memory(const other_memory&) = delete;
  other_memory& operator=(const other_memory&) = delete;

private:
  static constexpr long byte_of_mind = 2;
  cca::detail::shared_file file;
};

std::string memory_of(const std::string& magic, std::uint64_t manifest_size, const std::string& manifest) {
  const char* const size = reinterpret_cast<const char*>(&manifest_size);
  return magic + std::string(size, sizeof manifest_size) + manifest + std::string(4096, '\0');
}

std::string refusal_beside(const std::string& memory) {
  const std::string name = over_shared_memory::other_name();
  const other_memory other(name, memory);
  std::string said = "nothing";
  try {
    cca::deployed<two> d(cca::only{"robot"}, cca::shared_memory(name));
  } catch (const cca::refused& e) { said = e.what(); }
  other.end();
  cca::deployed<two> begins_anew(cca::only{"robot"}, cca::shared_memory(name));
  return said.substr(std::min(said.find(name) + name.size() + 1, said.size()));
}

}  // namespace

TEST_SUITE("deployed in processes") {
  TEST_CASE("each process has the bits of the one loop") {
    transport_laws::has_the_bits_of_one_loop<over_shared_memory>();
    transport_laws::has_the_same_bits_at_wall_clock_speed<over_shared_memory>();
  }
  TEST_CASE("a killed process is lost contact for the others, at any pace") {
    transport_laws::loses_contact_with_the_killed<over_shared_memory>();
  }
  TEST_CASE("a fault in a follower stops every resource node within two beats") {
    transport_laws::stops_all_within_two_beats_of_a_fault<over_shared_memory>();
  }
  TEST_CASE("a process may come late, and come again") {
    transport_laws::waits_for_who_comes_late_or_again<over_shared_memory>();
  }
  TEST_CASE("stop in one process is stop in the other, which waits in run") {
    transport_laws::stops_with_the_others<over_shared_memory>();
  }
  TEST_CASE("the robot's side idles while another process stands still") {
    transport_laws::idles_while_another_stands<over_shared_memory>();
  }
  TEST_CASE("`between` is called after each beat, also of an environment that has nothing to do in most") {
    const std::string name = over_shared_memory::other_name();
    const auto looks_in = [&](const char* environment) {
      cca::deployed<sleepy> d(cca::only{environment}, over_shared_memory::transport(name));
      d.load();
      d.start();
      int looks = 0;
      d.run(cca::for_beats<45>{}, cca::as_fast_as_possible(), [&](auto&) { ++looks; });
      return std::to_string(looks);
    };
    process mind([&] { return looks_in("mind"); });
    CHECK_EQ(looks_in("robot"), "45");
    CHECK_EQ(mind.said(), "45");
  }
  TEST_CASE("who stands still since it has called run is waited for as long as one that has not") {
    const std::string name = over_shared_memory::other_name();
    process mind([&] {
      auto d = transport_laws::opened<over_shared_memory>("mind", name);
      d.load();
      d.start();
      try {
        d.run(cca::for_beats<20>{}, cca::as_fast_as_possible(), stands_still_while_it_waits());
        if (d.beat_index() != 0) return std::string("ran alone");
      } catch (const cca::refused&) {}  // it has waited too long as well
      d.run(cca::for_beats<20>{});
      return transport_laws::state_of(d);
    });
    mind.wait_until_it_stands();
    process robot([&] {
      auto d = transport_laws::opened<over_shared_memory>("robot", name);
      d.load();
      d.start();
      std::string said;
      try {
        d.run(cca::for_beats<20>{});
      } catch (const cca::refused& e) { said = e.what(); }
      said += "; " + transport_laws::state_of(d);
      mind.go_on();
      d.run(cca::for_beats<20>{});
      return said + "; " + transport_laws::state_of(d);
    });
    CHECK_EQ(
        robot.said(),
        "cca::deployed: environment `mind` has called run, but has not begun it within 10 s: its process "
        "stands still (SIGSTOP, a debugger): let it go on, or end it; 0 started  ; 20 started  ");
    CHECK_EQ(mind.said(), "20 started  ");
  }
  TEST_CASE("a reader that stops costs the writer nothing") {
    transport_laws::is_not_held_up_by_a_stopped_reader<over_shared_memory>();
  }
  TEST_CASE("who stood still for 3 s goes on") {
    transport_laws::goes_on_after_a_standstill<over_shared_memory>();
  }
  TEST_CASE("a second process and one of another deployment are refused") {
    transport_laws::refuses_whom_it_must<over_shared_memory>();
  }

  TEST_CASE("free-running: the bits of one loop, results in a wall-clock run, lost contact with the killed") {
    free_running_laws::has_the_bits_of_one_loop<over_shared_memory>();
    free_running_laws::runs_freely_at_wall_clock_speed<over_shared_memory>();
    free_running_laws::loses_contact_with_the_killed<over_shared_memory>();
  }
  TEST_CASE("free-running queues: the bits of one loop, and what is lost in a wall-clock run is counted") {
    free_running_laws::queues_have_the_bits_of_one_loop<over_shared_memory>();
    free_running_laws::queues_count_what_they_lose<over_shared_memory>();
  }

  TEST_CASE("the memory is private, and the last process removes it") {
    const std::string name = over_shared_memory::other_name();
    {
      cca::deployed<two> d(cca::only{"robot"}, cca::shared_memory(name));
      struct stat of{};
      REQUIRE_EQ(::stat(("/dev/shm" + name).c_str(), &of), 0);
      CHECK_EQ(of.st_mode & 0777, 0600);
    }
    CHECK_NE(::access(("/dev/shm" + name).c_str(), F_OK), 0);
  }

  TEST_CASE("a process of another version is refused, both versions are named") {
    const std::string own = cca::detail::manifest_of<two>();
    const std::string version = own.substr(0, own.find('\n'));
    const std::string other = "cca 9.8.7" + own.substr(version.size());
    CHECK_EQ(refusal_beside(memory_of("cca shm2", other.size(), other)),
             ": the other process runs another deployment; here `" + version + "`, there `cca 9.8.7`");
    CHECK_EQ(refusal_beside(memory_of("cca shm9", own.size(), own)), " is no memory of this version of cca");
    CHECK_EQ(refusal_beside(memory_of("cca shm2", std::uint64_t{1} << 40, own)),
             " is no memory of this version of cca");
    CHECK_EQ(refusal_beside(memory_of("cca shm2", own.size(), own)), " has another size");
    CHECK_EQ(refusal_beside("cca shm1"), " is no memory of cca");
  }

  TEST_CASE("what is refused: a name that is none, an environment that is none, a component elsewhere") {
    const std::string name = over_shared_memory::other_name();
    cca::deployed<two> d(cca::only{"robot"}, cca::shared_memory(name));
    const auto refusal = [](auto f) {
      try {
        f();
      } catch (const cca::refused& e) { return std::string(e.what()); }
      return std::string("nothing");
    };
    CHECK_EQ(refusal([&] { cca::deployed<two> second(cca::only{"robot"}, cca::shared_memory(name)); }),
             "cca::shared_memory: `" + name +
                 "`: another process runs environment `robot` already: process " +
                 cca::detail::described_process(::getpid()));
    CHECK_EQ(refusal([&] { cca::deployed<two> second(cca::only{"head"}, cca::shared_memory(name)); }),
             "cca::only: the deployment has no environment `head`");
    CHECK(refusal([&] {
            cca::deployed<two> second(cca::only{"mind"}, cca::shared_memory("trot"));
          }).find("`trot` is no name") != std::string::npos);
    CHECK_EQ(refusal([&] { static_cast<void>(d.get<"thinker">()); }),
             "cca::deployed: `thinker` runs in environment `mind`, which another process runs");
  }

  TEST_CASE("parameters of a component elsewhere are refused by any path, a file is the same for all") {
    cca::deployed<two> d(cca::only{"mind"}, cca::shared_memory(over_shared_memory::other_name()));
    const auto is_refused = [](auto f) {
      try {
        f();
      } catch (const cca::refused& e) {
        CHECK_EQ(std::string(e.what()),
                 "cca::deployed: `filter` runs in environment `robot`, which another process runs");
        return true;
      }
      return false;
    };
    CHECK(is_refused([&] { d.set<"filter">({0.2}); }));
    CHECK(is_refused([&] { d.set("filter.gain", 0.2); }));
    CHECK(is_refused([&] { static_cast<void>(d.parameter("filter.gain")); }));
    CHECK(is_refused([&] { static_cast<void>(d.parameter<double>("filter.gain")); }));
    CHECK_EQ(d.parameter_paths(), std::vector<std::string>{"filter.gain", "guard.most"});

    const std::string file = "processes_" + std::to_string(::getpid()) + ".toml";
    std::ofstream(file) << "[filter]\ngain = 0.3\n[guard]\nmost = 7.0\n";
    d.load(file);
    d.save(file);
    cca::deployed<two> all;
    all.load(file);
    CHECK_EQ(all.parameter("filter.gain"), "0.3");
    std::remove(file.c_str());
  }
}
