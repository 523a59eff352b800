// Calls of rollouts on several ranks, in which what the words name goes wrong. Each rank that comes to its
// end writes all that it got to FOLDER/<rank>; ranks.py compares the files.
//
//   cca_mpi_rollouts FOLDER SECONDS-OF-SILENCE SCENARIO [RANK SIGNAL]
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <cca/base/math.hpp>
#include <cca/cca.hpp>
#include <cca/mpi/ranks.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/runtime/interruption.hpp>
#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/compiled/together/side_by_side.hpp>

namespace {

using std::chrono::milliseconds;

struct kept {
  BOOST_HANA_DEFINE_STRUCT(kept, (std::vector<double>, path), (std::string, name), (bool, fell));
};

using arm = cca::robots::arm::description;

// A run in steps: the arm falls under weak springs that follow the last reading. `best`, of the generation
// before, says from where. Each run has another number of beats.
struct falling {
  std::size_t number, left;
  cca::sim::side_by_side<cca::sim::compiled_world<arm>> w{};
  std::function<void(std::size_t beat)> meanwhile;

  falling(std::size_t i, double best, std::function<void(std::size_t)> act)
      : number(i), left(20 + 7 * i % 30), meanwhile(std::move(act)) {
    auto q = arm::start;
    q[1] += 0.1 * best + 0.003 * static_cast<double>(i);
    w.place(q, {});
  }
  auto& world() { return w; }
  bool step() {
    if (left == 0 || w.trouble()) return false;
    meanwhile(left--);
    std::array<cca::sim::joint_law, 7> laws{};
    for (std::size_t c = 0; c < 7; ++c)
      laws[c] = {.torque = 5 * (arm::start[c] - w.joints()[c].angle), .damping = 0.5};
    w.advance(laws);
    return true;
  }
  kept result() {
    const auto end = w.end("arm");
    return {{w.joints()[1].angle, end.velocity[0], end.velocity.norm()},
            "run " + std::to_string(number),
            end.velocity[2] < 0};
  }
};

void wait(int ms) { std::this_thread::sleep_for(milliseconds(ms)); }

class scenario {
public:
  scenario(int count, char** words, double silence)
      : all(count, words, {.silence = std::chrono::duration<double>(silence)}),
        file(std::string(words[1]) + "/" + std::to_string(all.rank()) + ".part"),
        name(words[3]),
        rank(count > 4 ? std::atoi(words[4]) : -1),
        signal(count > 5 ? std::atoi(words[5]) : 0),
        at(words[1]) {}

  int act() {
    const bool is_chosen = all.rank() == rank;
    if (name == "bits") search([](std::size_t, std::size_t) {});
    else if (name == "few") few();
    else if (name == "steps") in_steps([](std::size_t, std::size_t, std::size_t) {});
    else if (name == "steps_die")
      in_steps([&](std::size_t generation, std::size_t, std::size_t beat) {
        if (generation == 1 && is_chosen && beat == 10) std::raise(signal);
        if (beat == 5) wait(5);
      });
    else if (name == "steps_fail") steps_fail();
    else if (name == "steps_stop") steps_stop();
    else if (name == "dies")
      search([&](std::size_t generation, std::size_t) {
        if (generation == 1 && is_chosen) std::raise(signal);
        wait(2);
      });
    else if (name == "slow")
      search([&](std::size_t generation, std::size_t i) {
        if (generation == 1 && i == 0) {
          std::printf("at work\n");
          std::fflush(stdout);
        }
        wait(25);
      });
    else if (name == "wakes")
      search([&](std::size_t generation, std::size_t) {
        if (generation == 1 && is_chosen) stand_still();
        wait(generation == 3 ? 100 : 2);
      });
    else if (name == "leaves")
      search([&](std::size_t generation, std::size_t) {
        if (generation == 1 && is_chosen) std::exit(5);
        wait(2);
      });
    else if (name == "long") long_runs();
    else if (name == "fails") fails();
    else if (name == "stops") stops();
    else if (name == "interrupted") return interrupted();
    else if (name == "differ") differ();
    else if (name == "settings") settings();
    else return 2;
    finish();
    return 0;
  }

private:
  void say(const std::string& text) { file << text << '\n'; }
  void say(double value) { say(std::to_string(std::bit_cast<std::uint64_t>(value))); }
  void finish() {
    file.close();
    const std::string path = at + "/" + std::to_string(all.rank());
    std::rename((path + ".part").c_str(), path.c_str());
  }

  // Each generation begins where the best of the one before has ended, as in a search: an error in one
  // result on one rank changes all that follows there.
  void search(const std::function<void(std::size_t, std::size_t)>& meanwhile) {
    double best = 0.3;
    for (std::size_t generation = 0; generation < 4; ++generation) {
      const auto values = all.rollouts(97, [&](std::size_t i) {
        meanwhile(generation, i);
        double x = best + 1e-3 * static_cast<double>(i);
        for (int k = 0; k < 500; ++k) x = 3.9 * x * (1 - x) + 1e-3 * cca::math::sin(x);
        return std::clamp(x, 0.01, 0.99);
      });
      for (const double value : values) say(value);
      best = *std::ranges::max_element(values);
    }
  }

  // Runs in steps, each generation from where the best of the one before has ended.
  void in_steps(const std::function<void(std::size_t, std::size_t, std::size_t)>& meanwhile) {
    double best = 1;
    for (std::size_t generation = 0; generation < 3; ++generation)
      for (const std::size_t count : {1u, 3u, 45u}) {
        std::vector<std::size_t> told;
        const auto run = [&](std::size_t i) {
          return falling(i, best, [&, generation, i](std::size_t beat) { meanwhile(generation, i, beat); });
        };
        const auto results = all.rollouts(count, run, {.over = [&](std::size_t n) { told.push_back(n); }});
        for (const kept& one : results) {
          say(one.name + (one.fell ? " fell" : ""));
          for (const double value : one.path) say(value);
          best = std::min(std::max(best, one.path.at(2)), 2.0);
        }
        say_whether_told_of_each(told, count);
      }
  }

  template <class Run>
  void say_failure_of(const Run& run) {
    for (int k = 0; k < 2; ++k) {
      all.rollouts(4, [](std::size_t i) { return i; });  // now all ranks are there
      try {
        all.rollouts(12, run, {.threads = 1});
        say("nothing was thrown");
      } catch (const cca::mpi::failed_run& e) {
        say(e.what() + std::string(" of ") + std::to_string(e.number));
      }
    }
    say(std::to_string(all.rollouts(3, [](std::size_t i) { return i; }).size()) + " results afterwards");
  }
  void say_whether_told_of_each(const std::vector<std::size_t>& told, std::size_t count) {
    bool each = all.is_first() ? told.size() == count : told.empty();
    for (std::size_t i = 0; i < told.size(); ++i) each = each && told[i] == i + 1;
    say(each ? "told of each on rank 0" : "not told of each");
  }

  // Run 3 fails first; run 1, which is under way then, fails later.
  void steps_fail() {
    const auto run = [](std::size_t i) {
      return falling(i, 0, [i, beats = 0](std::size_t) mutable {
        wait(i == 1 ? 30 : 2);
        if (++beats == 15 && (i == 1 || i == 3)) throw std::runtime_error("run " + std::to_string(i));
      });
    };
    say_failure_of(run);
  }

  void steps_stop() {
    std::atomic<bool> stop = false;
    std::atomic<int> begun = 0;
    const auto run = [&](std::size_t i) {
      if (all.rank() == rank && ++begun == 9) stop = true;
      return falling(i, 0, [](std::size_t beat) { beat == 5 ? wait(4) : void(); });
    };
    const auto results = all.rollouts(4000, run, {.stops = [&] { return stop.load(); }});
    say(results.empty() || results.size() >= 4000 ? "none or all" : "some");
    for (const kept& each : results) say(each.name);
  }

  void few() {
    for (const std::size_t count : {0u, 1u, 2u, 5u, 1000u}) {
      std::vector<std::size_t> told;
      const auto results = all.rollouts(count,
                                        [](std::size_t i) {
                                          kept one;
                                          one.path.assign(i % 7, 0.1 * static_cast<double>(i));
                                          one.name = "run " + std::to_string(i);
                                          one.fell = i % 2 == 1;
                                          return one;
                                        },
                                        {.over = [&](std::size_t n) { told.push_back(n); }});
      say(std::to_string(results.size()) + " results");
      for (const kept& one : results) {
        say(one.name + (one.fell ? " fell" : ""));
        for (const double value : one.path) say(value);
      }
      say_whether_told_of_each(told, count);
    }
    // More than a piece of a message.
    const auto large = all.rollouts(2, [](std::size_t i) {
      std::string one(i * 40'000'000, 'a');
      for (std::size_t k = 0; k < one.size(); k += 997) one[k] = static_cast<char>('b' + k % 20);
      return one;
    });
    say(std::to_string(large.at(1).size()) + " bytes " + std::to_string(sum_of(large.at(1))));
  }

  static std::uint64_t sum_of(const std::string& bytes) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 997) sum = 31 * sum + static_cast<unsigned char>(bytes[i]);
    return sum;
  }

  // Longer than the silence that is allowed, within runs and between calls.
  void long_runs() {
    for (int k = 0; k < 2; ++k) {
      if (all.rank() == 2) wait(3000);
      for (const auto i : all.rollouts(5, [](std::size_t i) {
             wait(i == 1 ? 3000 : 1);
             return i;
           }))
        say(std::to_string(i));
    }
  }

  void fails() {
    // Each rank gets one of so few runs. Run 3 fails first; run 1, which is under way then, fails later.
    const auto run = [](std::size_t i) {
      wait(i == 1 ? 600 : 100);
      if (i == 3) throw std::runtime_error("run 3");
      if (i == 1) throw std::logic_error("run 1");
      return i;
    };
    say_failure_of(run);
  }

  void stops() {
    std::atomic<bool> stop = false;
    std::atomic<int> begun = 0;
    const auto run = [&](std::size_t i) {
      if (all.rank() == rank && ++begun == 5) stop = true;
      wait(10);
      return 3 * i;
    };
    const auto results = all.rollouts(4000, run, {.stops = [&] { return stop.load(); }});
    say(results.empty() || results.size() >= 4000 ? "none or all" : "some");
    for (const auto each : results) say(std::to_string(each));
  }

  // What settings throw is thrown on all ranks, too.
  void settings() {
    const auto run = [](std::size_t i) {
      wait(2);
      return i;
    };
    const auto over = [](std::size_t n) { n > 5 ? throw std::runtime_error("told") : void(); };
    const auto asked = [&]() -> bool { return all.rank() == 2 ? throw std::runtime_error("asked") : false; };
    const auto tried = [&](const cca::sim::rollout_settings& s) {
      try {
        all.rollouts(400, run, s);
        say("nothing was thrown");
      } catch (const cca::mpi::failed_run& e) {
        say(e.what() + std::string(" of ") + std::to_string(e.number));
      }
    };
    tried({.over = over});
    tried({.stops = asked});
    try {
      all.rollouts(4, [&](std::size_t) { return all.rollouts(2, run).size(); });
      say("nothing was thrown");
    } catch (const cca::mpi::failed_run& e) { say(e.what()); }
    say(std::to_string(all.rollouts(3, run).size()) + " results afterwards");
  }

  void differ() {
    try {
      all.rollouts(all.rank() == 1 ? 12 : 13, [](std::size_t i) {
        wait(20);
        return static_cast<int>(i);
      });
      say("nothing was thrown");
    } catch (const cca::mpi::failed_run& e) { say(e.what()); }
  }

  int interrupted() {
    const cca::interruption now;
    std::printf("at work\n");
    std::fflush(stdout);
    const auto results = all.rollouts(100'000,
                                      [&](std::size_t i) {
                                        for (int k = 0; k < 20 && !now; ++k) wait(1);
                                        return i;
                                      },
                                      {.stops = [&] { return bool(now); }});
    say(std::to_string(results.size()) + " results");
    finish();
    return now.exit_code();
  }

  // Another process wakes this one long after it was left out.
  static void stand_still() {
    static std::atomic<bool> once = false;
    if (once.exchange(true)) return;
    const pid_t self = ::getpid();
    if (::fork() == 0) {
      ::usleep(4'500'000);
      ::kill(self, SIGCONT);
      ::_exit(0);
    }
    std::raise(SIGSTOP);
  }

  cca::mpi::ranks all;
  std::ofstream file;
  const std::string name;
  const int rank, signal;
  const std::string at;
};

}  // namespace

int main(int count, char** words) {
  if (count < 4) return 2;
  try {
    return scenario(count, words, std::atof(words[2])).act();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 3;
  }
}
