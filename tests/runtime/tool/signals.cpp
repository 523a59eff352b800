// What ends a command of cca-can in order: it must still disable what it has enabled.
#include <doctest/doctest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../../../tools/cca_can/pace.hpp"

TEST_SUITE("tool signals") {
  TEST_CASE(
      "each signal that would kill a command asks for its end, also a reader of its output that is gone") {
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ}) {
      const pid_t child = ::fork();
      if (child == 0) {
        for (const int each : {SIGINT, SIGTERM}) ::signal(each, SIG_DFL);  // doctest catches them
        const cca_can::wall_pace time;
        if (time.end_wanted()) ::_exit(1);
        ::raise(number);
        ::_exit(time.end_wanted() ? 0 : 2);
      }
      int status = 0;
      ::waitpid(child, &status, 0);
      CAPTURE(number);
      CHECK_EQ(status, 0);
    }
  }
}
