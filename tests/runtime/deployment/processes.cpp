// The environments of a deployment in processes of their own, over POSIX shared memory.
#include <doctest/doctest.h>

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <sstream>
#include <string>
#include <thread>

#include "robot_and_mind.hpp"

using namespace deployment_test;

namespace {

using namespace std::chrono_literals;

std::string fresh_name() {
  static int number = 0;
  return "/cca_test_" + std::to_string(::getpid()) + "_" + std::to_string(number++);
}

// Runs f in another process, and gives what it writes.
class process {
public:
  template <class F>
  explicit process(F f) {
    int ends[2];
    REQUIRE_EQ(::pipe(ends), 0);
    child = ::fork();
    if (child == 0) {
      std::string text;
      try {
        text = f();
      } catch (const std::exception& e) { text = std::string("refused: ") + e.what(); }
      const auto size = ::write(ends[1], text.data(), text.size());
      ::_exit(size == static_cast<ssize_t>(text.size()) ? 0 : 1);
    }
    ::close(ends[1]);
    from = ends[0];
  }
  std::string said() {
    std::string all;
    char some[4096];
    for (ssize_t size; (size = ::read(from, some, sizeof some)) > 0;)
      all.append(some, static_cast<std::size_t>(size));
    int status = 0;
    ::waitpid(child, &status, 0);
    child = 0;
    return all;
  }
  void kill() const { ::kill(child, SIGKILL); }
  ~process() {
    if (child > 0) {
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
    }
    ::close(from);
  }
  process(const process&) = delete;
  process& operator=(const process&) = delete;

private:
  pid_t child = 0;
  int from = -1;
};

template <class Played>
std::string robot_of(const Played& c) {
  std::ostringstream text;
  text << std::hexfloat << c.beat_index() << ' ' << cca::to_string(c.state()) << ' ' << c.fault().reason()
       << ' ' << c.template get<"filter">().kept << ' ' << c.template get<"device">().command << ' '
       << c.template get<"device">().faults << '\n';
  return text.str();
}
template <class Played>
std::string mind_of(const Played& c) {
  std::ostringstream text;
  text << std::hexfloat << c.beat_index() << ' ' << cca::to_string(c.state()) << ' ' << c.fault().reason()
       << ' ' << c.template get<"thinker">().sum << '\n';
  return text.str();
}

// Runs of several lengths.
template <class Played, class F>
std::string story(Played& c, F tell) {
  std::string all;
  c.load();
  c.start();
  for (const int beats : {1, 7, 100, 33}) {
    c.run(cca::for_some_beats{beats});
    all += tell(c);
  }
  return all;
}

}  // namespace

TEST_SUITE("deployed in processes") {
  TEST_CASE("each process has the bits of the one loop") {
    const std::string name = fresh_name();
    process mind([&] {
      cca::deployed<two> d(cca::only{"mind"}, cca::shared_memory(name));
      return story(d, [](const auto& c) { return mind_of(c); });
    });
    process robot([&] {
      cca::deployed<two> d(cca::only{"robot"}, cca::shared_memory(name));
      return story(d, [](const auto& c) { return robot_of(c); });
    });
    cca::controller<architecture> c;
    const std::string all = story(c, [](const auto& one) { return robot_of(one) + "|" + mind_of(one); });
    std::string of_robot, of_mind;
    std::istringstream lines(all);
    for (std::string line; std::getline(lines, line);)
      (line[0] == '|' ? of_mind : of_robot) += (line[0] == '|' ? line.substr(1) : line) + "\n";
    CHECK_EQ(robot.said(), of_robot);
    CHECK_EQ(mind.said(), of_mind);
    CHECK_NE(::access(("/dev/shm" + name).c_str(), F_OK), 0);  // the last one removes it
  }

  TEST_CASE("a killed process is lost contact for the others, at any pace") {
    for (const bool is_exact : {true, false}) {
      const std::string name = fresh_name();
      process mind([&] {
        cca::deployed<two> d(cca::only{"mind"}, cca::shared_memory(name));
        d.load();
        d.start();
        if (is_exact) d.run(cca::without_end{});
        else d.run(cca::without_end{}, cca::at_wall_clock());
        return std::string();
      });
      process robot([&] {
        cca::deployed<two> d(cca::only{"robot"}, cca::shared_memory(name));
        d.load();
        d.start();
        if (is_exact) d.run(cca::without_end{});
        else d.run(cca::without_end{}, cca::at_wall_clock());
        return robot_of(d);
      });
      std::this_thread::sleep_for(300ms);
      mind.kill();
      const std::string said = robot.said();
      CAPTURE(said);
      CHECK(said.find("faulted lost contact with `mind`") != std::string::npos);
      CHECK(said.ends_with(" 1\n"));  // on_fault
    }
  }

  TEST_CASE("a fault in one process is that of all, in the same beat") {
    const std::string name = fresh_name();
    const auto faults = [&](const char* environment, bool has_guard, auto tell) {
      cca::deployed<two> d(cca::only{environment}, cca::shared_memory(name));
      d.load();
      if (has_guard) d.set<"guard">({2.0});
      d.start();
      d.run(cca::for_<10>{});
      return tell(d);
    };
    process mind([&] { return faults("mind", false, [](const auto& d) { return mind_of(d); }); });
    process robot([&] { return faults("robot", true, [](const auto& d) { return robot_of(d); }); });
    cca::controller<architecture> c;
    c.load();
    c.set<"guard">({2.0});
    c.start();
    c.run(cca::for_<10>{});
    REQUIRE(c.fault());
    CHECK_EQ(robot.said(), robot_of(c));
    CHECK_EQ(mind.said(), mind_of(c));
  }

  TEST_CASE("stop in one process is stop in the other, which waits in run") {
    const std::string name = fresh_name();
    process mind([&] {
      cca::deployed<two> d(cca::only{"mind"}, cca::shared_memory(name));
      d.load();
      d.start();
      int runs = 0;
      while (d.state() == cca::state::started) {
        d.run(cca::for_some_beats{50});
        ++runs;
      }
      return std::to_string(runs) + std::string(cca::to_string(d.state()));
    });
    process robot([&] {
      cca::deployed<two> d(cca::only{"robot"}, cca::shared_memory(name));
      d.load();
      d.start();
      d.run(cca::for_some_beats{50});
      d.run(cca::for_some_beats{50});
      d.stop();
      std::this_thread::sleep_for(1s);
      return std::string();
    });
    CHECK_EQ(mind.said(), "3loaded");
    CHECK_EQ(robot.said(), "");
  }

  TEST_CASE("a process that comes again goes on in the beat of the others") {
    const std::string name = fresh_name();
    const auto run_mind = [&] {
      cca::deployed<two> d(cca::only{"mind"}, cca::shared_memory(name));
      d.load();
      d.start();
      d.run(cca::without_end{});
      return std::to_string(d.beat_index());
    };
    process first(run_mind);
    process robot([&] {
      cca::deployed<two> d(cca::only{"robot"}, cca::shared_memory(name));
      d.load();
      d.start();
      d.run(cca::without_end{});
      std::string all = std::string(cca::to_string(d.state()));
      d.resume();
      const auto beat = d.beat_index();
      d.run(cca::for_some_beats{100});  // waits until it has come
      return all + " " + std::string(cca::to_string(d.state())) + " " +
             std::to_string(d.beat_index() - beat) + " " + std::to_string(d.beat_index());
    });
    std::this_thread::sleep_for(200ms);
    first.kill();
    first.said();  // it has ended
    process second(run_mind);
    const std::string of_robot = robot.said(), of_mind = second.said();
    CAPTURE(of_robot);
    CAPTURE(of_mind);
    CHECK(of_robot.starts_with("faulted started 100 "));
    CHECK(of_robot.ends_with(" " + of_mind));
  }

  TEST_CASE(
      "what is refused: a second process, another deployment, an environment that isn't, one that never "
      "comes") {
    const std::string name = fresh_name();
    cca::deployed<two> d(cca::only{"robot"}, cca::shared_memory(name));
    struct stat of{};
    REQUIRE_EQ(::stat(("/dev/shm" + name).c_str(), &of), 0);
    CHECK_EQ(of.st_mode & 0777, 0600);
    const auto refusal = [](auto f) {
      try {
        f();
      } catch (const cca::refused& e) { return std::string(e.what()); }
      return std::string("nothing");
    };
    CHECK_EQ(refusal([&] { cca::deployed<two> second(cca::only{"robot"}, cca::shared_memory(name)); }),
             "cca::shared_memory: `" + name + "`: another process runs environment `robot` already");
    struct patient_two
        : cca::deployment<architecture, cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                          cca::environment<"mind", cca::other_nodes>, cca::tolerate<9>> {};
    const auto other =
        refusal([&] { cca::deployed<patient_two> second(cca::only{"mind"}, cca::shared_memory(name)); });
    CHECK(other.find("runs another deployment; here `deployment") != std::string::npos);
    CHECK(other.find("9 late beats tolerated") != std::string::npos);
    CHECK_EQ(refusal([&] { cca::deployed<two> second(cca::only{"head"}, cca::shared_memory(name)); }),
             "cca::only: the deployment has no environment `head`");
    CHECK(refusal([&] {
            cca::deployed<two> second(cca::only{"mind"}, cca::shared_memory("trot"));
          }).find("`trot` is no name") != std::string::npos);
    CHECK_EQ(refusal([&] { static_cast<void>(d.get<"thinker">()); }),
             "cca::deployed: `thinker` runs in environment `mind`, which another process runs");
  }
}
