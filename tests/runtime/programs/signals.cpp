// Signals to a robot's program: which of them end it in order, which end nothing, and when a second one ends
// it at once.
#include <doctest/doctest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include <cca/main.hpp>
#include <cca/space/domain.hpp>

#include "child.hpp"

using programs_test::child;

namespace {

struct number : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};

// It hangs in beat 20 if it is to.
struct device {
  bool hangs = false;
  auto sense(cca::beat now) -> cca::out<"y", number> {
    if (hangs && now.index() == 20) {
      std::puts("hangs;");
      std::fflush(stdout);
      for (;;) ::pause();
    }
    return 0.0;
  }
  void act(cca::in<"u", number>) {}
};
struct follow {
  auto process(cca::in<"x", number> x) -> cca::out<"y", number> { return x[cca::x{}]; }
};
struct loop : cca::graph<cca::rate<1000>,
                         cca::node<"device", device>,
                         cca::node<"follow", follow>,
                         cca::wire<"device.y", "follow.x">,
                         cca::wire<"follow.y", "device.u">> {};

// Says what is called.
struct telling : cca::robot_program<loop> {
  bool runs = false;
  telling() { settings.quiet = true; }
  static void tell(const char* what) {
    std::printf("%s;", what);
    std::fflush(stdout);
  }
  bool between(controller_type&) override {
    if (!std::exchange(runs, true)) tell("runs");
    return true;
  }
  void stop(controller_type& c) override {
    tell("stop");
    cca::robot_program<loop>::stop(c);
  }
  int finish(controller_type&) override { return tell("finish"), 42; }
};
struct hangs_in_a_beat : telling {
  void prepare(controller_type& c) override { c.get<"device">().hangs = true; }
};
struct hangs_in_stop : telling {
  void stop(controller_type&) override {
    tell("stop");
    for (;;) ::pause();
  }
};
std::uint32_t signals_noted() { return cca::detail::noted.count.load(); }
void sleep_for(double seconds) {
  const auto until = cca::detail::monotonic_clock::now() + static_cast<std::int64_t>(1e9 * seconds);
  cca::detail::monotonic_clock::sleep_until(until);
}
constexpr double standstill = 1e-9 * static_cast<double>(cca::detail::longest_standstill) + 0.1;

template <class Program>
child run(std::vector<std::string> words = {}) {
  return child(cca::robot_main<Program>, std::move(words));
}

}  // namespace

TEST_SUITE("signals") {
  TEST_CASE("an early second signal cuts no stop short, and SIGINT says what it would do") {
    struct stops_slowly : telling {
      void stop(controller_type& c) override {
        const auto noted = signals_noted();
        tell("stop");
        while (signals_noted() == noted) ::usleep(1000);
        telling::stop(c);
      }
    };
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      child one = run<stops_slowly>();
      one.wait_for("runs;");
      one.send(SIGINT);
      one.wait_for("stop;");
      one.send(number);
      CHECK_EQ(one.code(), 128 + number);
      CHECK(one.out.starts_with("runs;stop;stop;finish;"));
      CHECK_EQ(one.err.find("\nstopping in order; should that hang for 2 s, ctrl-c ends") != one.err.npos,
               number == SIGINT);
    }
  }

  TEST_CASE(
      "a second SIGINT ends what hangs for 2 s, in a beat or in its stop, and says what is left behind") {
    child in_a_beat = run<hangs_in_a_beat>(), in_stop = run<hangs_in_stop>(),
          by_others = run<hangs_in_stop>();
    in_a_beat.wait_for("hangs;");
    in_stop.wait_for("runs;");
    by_others.wait_for("runs;");
    for (const child* one : {&in_a_beat, &in_stop, &by_others}) one->send(SIGTERM);
    in_stop.wait_for("stop;");
    by_others.wait_for("stop;");
    sleep_for(standstill);
    for (const child* one : {&in_a_beat, &in_stop}) one->send(SIGINT);
    for (child* one : {&in_a_beat, &in_stop}) {
      CHECK_EQ(one->code(), 130);
      CHECK(one->out.find("finish;") == one->out.npos);
      CHECK_EQ(
          one->err,
          "\nwalk: ended at once by a second SIGINT, not in order: it did not go on with stopping for 2 s. "
          "Left behind: its robot was not stopped: drives hold the last command until their watchdogs "
          "stop them\n");
    }
    by_others.send(SIGTERM);  // the others never do
    by_others.send(SIGHUP);
    by_others.send(SIGQUIT);
    CHECK_EQ(by_others.code(), 128 + SIGQUIT);
    CHECK_EQ(by_others.err, "");
  }

  TEST_CASE("after the stop it leaves less behind") {
    struct hangs_at_the_end : telling {
      int finish(controller_type&) override {
        tell("finish");
        for (;;) ::pause();
      }
    };
    child one = run<hangs_at_the_end>();
    one.wait_for("runs;");
    one.send(SIGINT);
    one.wait_for("finish;");
    sleep_for(standstill);
    one.send(SIGINT);
    CHECK_EQ(one.code(), 130);
    CHECK(one.err.find("Left behind: its robot is stopped, what it had not yet written is lost\n") !=
          one.err.npos);
  }

  TEST_CASE("a stop that goes on is not cut short, however long it takes") {
    struct takes_long : telling {
      void stop(controller_type& c) override {
        for (double seconds = 0; seconds < standstill; seconds += 0.1)
          sleep_for(0.1), cca::stopping_goes_on();
        const auto noted = signals_noted();
        tell("goes on");
        while (signals_noted() == noted) ::usleep(1000), cca::stopping_goes_on();
        telling::stop(c);
      }
    };
    child one = run<takes_long>();
    one.wait_for("runs;");
    one.send(SIGINT);
    one.wait_for("goes on;");
    one.send(SIGINT);
    CHECK_EQ(one.code(), 130);
    CHECK(one.out.starts_with("runs;goes on;stop;finish;"));
  }

  TEST_CASE("an error output that is full or stopped holds nothing up") {
    struct full : hangs_in_stop {
      void stop(controller_type& c) override {
        const std::string some(1 << 16, 'x');
        ::alarm(60);
        static_cast<void>(!::write(2, some.data(), some.size()));  // as much as a pipe takes
        hangs_in_stop::stop(c);
      }
    };
    child one = run<full>();
    one.wait_for("runs;");
    one.send(SIGINT);
    // Nobody reads its errors meanwhile.
    sleep_for(standstill);
    one.send(SIGINT);
    CHECK_EQ(one.code(), 130);
  }

  TEST_CASE("a lost terminal ends it in order, but not under nohup") {
    child one = run<telling>();
    one.wait_for("runs;");
    one.send(SIGHUP);
    CHECK_EQ(one.code(), 129);
    CHECK(one.out.starts_with("runs;stop;finish;"));
    child under_nohup(
        [](int count, char** words) {
          std::signal(SIGHUP, SIG_IGN);
          return cca::robot_main<telling>(count, words);
        },
        {"--seconds", "0.2"});
    under_nohup.wait_for("runs;");
    under_nohup.send(SIGHUP);
    CHECK_EQ(under_nohup.code(), 42);
    CHECK_EQ(under_nohup.err, "");
  }

  TEST_CASE("a reader that is gone, as of `walk | head`, changes nothing but a message") {
    struct prints : telling {
      bool between(controller_type& c) override {
        std::printf("beat %lld\n", static_cast<long long>(c.beat_index()));
        std::fflush(stdout);
        return telling::between(c);
      }
      void stop(controller_type& c) override {
        std::fprintf(stderr, "stopped after %lld beats\n", static_cast<long long>(c.beat_index()));
        telling::stop(c);
      }
    };
    child one = run<prints>({"--seconds", "0.2"});
    one.wait_for("runs;");
    one.stop_reading();
    CHECK_EQ(one.code(), 42);
    CHECK_EQ(one.err,
             "stopped after 200 beats\n"
             "walk: what it printed is not complete: its standard output is closed or full\n");
  }

  TEST_CASE("a file that may not grow any more does not end it") {
    struct writes : telling {
      std::FILE* file = std::tmpfile();
      bool is_full = false;
      void started(controller_type&) override {
        const rlimit tight{100, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &tight);
      }
      bool between(controller_type& c) override {
        is_full = std::fputs("more than fits", file) < 0 || std::fflush(file) != 0;
        return telling::between(c);
      }
      int finish(controller_type&) override { return is_full ? 42 : 1; }
    };
    CHECK_EQ(run<writes>({"--seconds", "0.05"}).code(), 42);
  }
}
