// The words of a command line, and the lines of a log.
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "../../../tools/cca_can/log_line.hpp"
#include "../../../tools/cca_can/words.hpp"

namespace tool_test {

using namespace cca_can;

namespace {

template <class F>
std::string complaint(F f) {
  try {
    f();
  } catch (const std::runtime_error& e) { return e.what(); }
  return "";
}

}  // namespace

TEST_SUITE("command line") {
  TEST_CASE("options, flags and words in any order - the rest is reported") {
    words w({"--yes", "jog", "can0", "--speed", "0.5", "mit:ak80-9:3", "--to", "-0.1", "--wrong"});
    CHECK(w.command() == "jog");
    CHECK(w.flag("--yes"));
    CHECK(w.number("--speed", "rad/s", 0, 1) == 0.5);
    CHECK(w.number("--to", "rad", -1, 1) == -0.1);
    CHECK_FALSE(w.number("--torque", "N m", 0, 1));
    CHECK(w.peek() == "can0");
    CHECK(w.next() == "can0");
    CHECK(w.next() == "mit:ak80-9:3");
    CHECK_FALSE(w.next());
    CHECK(complaint([&] { w.nothing_left(); }) ==
          "`--wrong`: this command does not know it; see `cca-can help`");
  }
  TEST_CASE("a value may be negative, and may follow an equals sign") {
    words w({"jog", "can0", "--range=-1,1", "--to=-0.5", "--by", "-0.1"});
    CHECK(w.option("--range") == "-1,1");
    CHECK(w.number("--to", "rad", -1, 1) == -0.5);
    CHECK(w.number("--by", "rad", -1, 1) == -0.1);
    CHECK(words({"jog", "--range", "-1,1"}).option("--range") == "-1,1");
  }
  TEST_CASE("--help, -h and --version, of the program and of a command") {
    for (const char* help : {"--help", "-h"}) {
      CHECK(words({help}).wants_help());
      CHECK(words({help}).answer() == "");
      const words jog({"jog", help});
      CHECK(jog.answer().find("--torque") != std::string::npos);
      CHECK(jog.answer().find("--silent-at") == std::string::npos);
    }
    CHECK(words({"--version"}).answer().starts_with("cca-can "));
    CHECK(words({}).command() == "help");
  }
  TEST_CASE("a file may be named as a command - a command that does not exist is refused") {
    words w({"replay", "can0", "list"});
    CHECK(w.command() == "replay");
    CHECK(w.next() == "can0");
    CHECK(w.next() == "list");
    CHECK(complaint([] { words({"wtch"}); }) ==
          "there is no command `wtch`, did you mean `watch`? See `cca-can help`");
    CHECK(complaint([] { words({"xyz"}); }) == "there is no command `xyz`; see `cca-can help`");
  }
  TEST_CASE("for a wrong number the message says what was expected") {
    const auto speed = [](std::vector<std::string> line) {
      line.insert(line.begin(), "jog");
      return complaint([&] { words(line).needed_number("--speed", "rad/s, as 0.5", 0, 20); });
    };
    CHECK(speed({"--speed", "fast"}) == "--speed fast: expected rad/s, as 0.5, from 0 to 20");
    CHECK(speed({"--speed", "21"}) == "--speed 21: expected rad/s, as 0.5, from 0 to 20");
    CHECK(speed({"--speed", "nan"}) != "");
    CHECK(speed({"--speed"}) == "--speed: a value is expected after it");
    CHECK(speed({}) == "--speed is missing: rad/s, as 0.5");
    CHECK(speed({"--speed", "1", "--speed", "2"}) == "--speed: it stands there twice");
  }
  TEST_CASE("@file stands for its words") {
    const std::string file = "cca_can_words.limits";
    cca::detail::write_file(file, "# of the left hip\n--range -0.2,0.2   # rad\n--speed 0.5\n\n");
    words w({"jog", "@" + file, "can0"});
    CHECK(w.option("--range") == "-0.2,0.2");
    CHECK(w.option("--speed") == "0.5");
    CHECK(w.command() == "jog");
    CHECK(w.next() == "can0");
    std::remove(file.c_str());
    CHECK(complaint([] {
            words({"@nowhere/at.all"});
          }).starts_with("nowhere/at.all: cannot be read: No such file"));
  }
}

TEST_SUITE("log") {
  TEST_CASE("lines of candump -L") {
    struct known {
      const char* text;
      hw::can_frame frame;
    };
    hw::can_frame fast = hw::fd(hw::standard(0x123), std::array<std::uint8_t, 12>{1, 2, 3});
    hw::can_frame slow = hw::fd(hw::extended(0x8001), std::array<std::uint8_t, 1>{0xAB}, 0, false);
    const known lines[] = {
        {"(1436509052.249713) vcan0 044#2A366C2BBA",
         hw::classic(hw::standard(0x44), std::array<std::uint8_t, 5>{0x2A, 0x36, 0x6C, 0x2B, 0xBA})},
        {"(1436509052.449847) vcan0 00000F6E#", hw::classic(hw::extended(0xF6E), {})},
        {"(1436509052.449847) vcan0 7FF#R", hw::remote(hw::standard(0x7FF))},
        {"(1436509052.449847) can_7 1FFFFFFF#R8", hw::remote(hw::extended(0x1FFFFFFF), 8)},
        {"(0000000001.000001) vcan0 123##1010203000000000000000000", fast},
        {"(0000000001.000001) vcan0 00008001##0AB", slow},
    };
    for (const known& k : lines) {
      CAPTURE(k.text);
      log_line line;
      CHECK(read_line(k.text, line) == "");
      CHECK(line.frame == k.frame);
      CHECK_FALSE(line.error);
      CHECK(text_of(line) == k.text);
    }
  }
  TEST_CASE("additions of newer candumps are read too") {
    log_line line;
    CHECK(read_line(" (1.5) can0 123#1122334455667788_9 R\r", line) == "");
    CHECK(line.frame.length == 8);
    CHECK(line.time == 1'500'000'000);
    CHECK(read_line("(1.000000001) can0 123##3aB T", line) == "");  // BRS and ESI
    CHECK(line.frame.fast);
    CHECK(line.time == 1'000'000'001);
    CHECK(read_line("(1.0) can0 20000004#0008000000006000", line) == "");
    CHECK(line.error);
    CHECK(read_line("(1.0) can0 123#R8_9", line) == "");
    CHECK(line.frame == hw::remote(hw::standard(0x123), 8));
    CHECK(read_line("(1.0) can0 123#R8_F", line) == "");
    CHECK(read_line("(1.0) can0 123#R8_8", line) != "");
    CHECK(read_line("(1.0) can0 123#R8_", line) != "");
    CHECK(is_drop_count("DROPCOUNT: dropped 3 CAN frames on 'can0' socket (total drops 7)"));
    CHECK(dropped_in("DROPCOUNT: dropped 3 CAN frames on 'can0' socket (total drops 7)") == 3);
    CHECK_FALSE(is_drop_count("(1.0) can0 123#"));
  }
  TEST_CASE("dots between bytes are read - a frame of CAN XL is marked") {
    log_line line;
    CHECK(read_line("(1700000000.000009) can0 123#11.22.33", line) == "");
    CHECK(line.frame == hw::classic(hw::standard(0x123), std::array<std::uint8_t, 3>{0x11, 0x22, 0x33}));
    CHECK(read_line("(1.0) can0 00008001##111.2233.44556677.88", line) == "");
    CHECK(line.frame.length == 8);
    CHECK(line.frame.data[7] == 0x88);
    CHECK(read_line("(1.0) can0 123#11.22.33.44.55.66.77.88_9", line) == "");
    CHECK(read_line("(1.0) can0 123#11.", line) ==
          "a byte has two hexadecimal digits, and one of them is missing");
    CHECK(read_line("(1.0) can0 123#11..22", line) == "`.2` is not a byte in hexadecimal digits");
    CHECK(read_line("(1.0) can0 123#.11", line) == "`.1` is not a byte in hexadecimal digits");
    CHECK(read_line("(1.0) can0 45123#81:00:12345678#11223344.556677", line) == "");
    CHECK(line.xl);
    CHECK_FALSE(line.has_frame());
    CHECK(read_line("(1.0) can0 123#81:00:12345678#11", line) == "");
    CHECK(line.xl);
    CHECK(read_line("(1.0) can0 123#81:00:1234567#11", line) == "`:0` is not a byte in hexadecimal digits");
  }
  TEST_CASE("every frame survives writing and reading") {
    std::mt19937 random(3);
    for (int i = 0; i < 20000; ++i) {
      const bool extended = random() % 2, fd = random() % 2, remote = !fd && random() % 8 == 0;
      hw::can_frame f{
          .id = {static_cast<std::uint32_t>(random() & (extended ? 0x1FFFFFFFu : 0x7FFu)), extended},
          .length = fd ? hw::fd_length(random() % 65) : static_cast<std::uint8_t>(random() % 9),
          .fd = fd,
          .fast = fd && random() % 2,
          .remote = remote};
      for (auto& byte : f.data) byte = static_cast<std::uint8_t>(random());
      const log_line line{.time = static_cast<std::int64_t>(random()) * 1'000'000, .bus = "can0", .frame = f};
      log_line read;
      REQUIRE(read_line(text_of(line), read) == "");
      REQUIRE(read.frame == f);
      REQUIRE(read.time == line.time);
      REQUIRE(read.bus == "can0");
    }
  }
  TEST_CASE("a line that is no log line is refused, with the reason") {
    log_line line;
    CHECK(read_line("hello", line) == "a line begins with its time, (SECONDS.MICROSECONDS)");
    CHECK(read_line("(9223372035.999999999) can0 123#", line) == "");
    CHECK(line.time == 9'223'372'035'999'999'999);
    CHECK(read_line("(9223372036.0) can0 123#", line) ==
          "`(9223372036.0)` is too late: times end in the year 2262");
    CHECK(read_line("(now) can0 123#", line) == "`(now)` is not a time in seconds");
    CHECK(read_line("(1.0)", line) == "after the time comes the name of the interface");
    CHECK(read_line("(1.0) can0", line) == "after the name of the interface comes the frame");
    CHECK(read_line("(1.0) can0 123", line) == "a frame is written ID#DATA, and there is no `#` in it");
    CHECK(read_line("(1.0) can0 12#", line) == "an id has 3 hexadecimal digits, or 8 for 29 bits");
    CHECK(read_line("(1.0) can0 800#", line) == "an id of 11 bits is at most 7FF");
    CHECK(read_line("(1.0) can0 123#123", line) ==
          "a byte has two hexadecimal digits, and one of them is missing");
    CHECK(read_line("(1.0) can0 123#1G", line) == "`1G` is not a byte in hexadecimal digits");
    CHECK(read_line("(1.0) can0 123#112233445566778899", line) == "a frame of this kind has at most 8 bytes");
    CHECK(read_line("(1.0) can0 123##1112233445566778899", line) == "an FD frame can't have 9 bytes");
    CHECK(read_line("(1.0) can0 123##", line) == "after `##` of an FD frame comes a digit of flags");
    CHECK(read_line("(1.0) can0 123#R9", line) == "a remote frame is `#R`, or `#R` and a length of 0 to 8");
    CHECK(read_line("(1.0) can0 123#11 X", line) == "there is something after the frame");
  }
}

}  // namespace tool_test
