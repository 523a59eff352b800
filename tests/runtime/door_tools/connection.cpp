// The client against a real door, and against what is none.
#include <doctest/doctest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "../../../tools/door/call/input_test.hpp"
#include "../../../tools/door/client.hpp"
#include "../../../tools/door/known_door.hpp"
#include "../../../tools/door/parameter.hpp"
#include "../../../tools/door/sample_fields.hpp"
#include "played_program.hpp"

namespace {

using namespace cca_door;
using namespace std::chrono_literals;
using door_test::soon;

// A socket that is taken and never answered.
struct silent_listener {
  silent_listener() : file(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof at;
    REQUIRE_EQ(::bind(file, reinterpret_cast<const sockaddr*>(&at), sizeof at), 0);
    REQUIRE_EQ(::listen(file, 4), 0);
    ::getsockname(file, reinterpret_cast<sockaddr*>(&at), &size);
    port = std::to_string(ntohs(at.sin_port));
  }
  ~silent_listener() { ::close(file); }
  silent_listener(const silent_listener&) = delete;
  silent_listener& operator=(const silent_listener&) = delete;
  int file;
  std::string port{};
};

struct talk {
  explicit talk(const door_address& to, const std::string& token = "", patience p = {})
      : line(to, token, p) {}
  client line;
  known_door door{};
  std::string closed{};
  std::uint64_t samples = 0;
  std::string last{};

  void listen() {
    line.wait(10ms);
    while (const auto one = line.next()) {
      if (one->what == event::kind::closed) closed = one->bytes;
      if (one->what == event::kind::text) door.take(one->message);
      if (one->what == event::kind::sample) ++samples, last = one->bytes;
    }
  }
  template <class Holds>
  bool until(Holds holds) {
    return soon([&] { return listen(), holds(); });
  }
};

}  // namespace

TEST_CASE("a door greets, and its channels and rights are known") {
  door_tools_test::played_program p;
  talk t(address_in(p.address()), door_test::token);
  REQUIRE(t.until([&] { return t.door.has_rights; }));
  CHECK_EQ(program_of(t.door), "oncilla_trot");
  CHECK(t.door.may_read);
  CHECK(t.door.may_change);
  CHECK(!t.door.commands);
  REQUIRE(t.door.channel_named("gait.angles"));
  CHECK_EQ(t.door.channel_named("/gait/angles"), t.door.channel_named("gait.angles"));
  CHECK_GT(t.door.services.at("/cca/stop"), 0);
  t.line.close();
  CHECK(!t.line.is_open());
}

TEST_CASE("samples arrive, and are read by their schema") {
  door_tools_test::played_program p;
  talk t(address_in("localhost:" + p.address()));
  REQUIRE(t.until([&] { return t.door.has_rights; }));
  const channel of = *t.door.channel_named("gait.angles");
  t.line.send({{"op", "subscribe"}, {"subscriptions", {{{"id", 7}, {"channelId", of.id}}}}});
  REQUIRE(t.until([&] { return p.beat(), t.samples > 20; }));
  const message_schema schema(of.schema);
  CHECK(schema.is_of_output());
  CHECK_EQ(schema.fields()[2].unit, "rad");
  const auto read = schema.read(t.last);
  REQUIRE(read);
  CHECK_EQ((*read)["knee"], 0.5);
  CHECK_EQ((*read)["origin"].get<std::int64_t>(), (*read)["beat"].get<std::int64_t>() * 1'000'000);
}

TEST_CASE("a wrong token only reads") {
  door_tools_test::played_program p;
  talk t(address_in(p.address()), "0123456789abcdef0123456789abcdee");
  REQUIRE(t.until([&] { return t.door.has_rights; }));
  CHECK(t.door.may_read);
  CHECK(!t.door.may_change);
}

TEST_CASE("nobody listens, nobody answers, nobody speaks the protocol") {
  std::string free_port;
  {
    const silent_listener l;
    free_port = l.port;
    talk silent(address_in(l.port), "", {.connecting = 200ms});
    REQUIRE(silent.until([&] { return silent.line.is_closed(); }));
    CHECK_EQ(silent.closed, "no answer within 200 ms");
  }
  talk nobody(address_in(free_port));
  REQUIRE(nobody.until([&] { return nobody.line.is_closed(); }));
  CHECK_EQ(nobody.closed, "nobody listens there");
  // It may be destroyed before anything has happened.
  { const client at_once(address_in(free_port), ""); }
  talk unknown(address_in("no-such-name.invalid:1"));
  REQUIRE(unknown.until([&] { return unknown.line.is_closed(); }));
  CHECK(unknown.closed.starts_with("the address is not known"));
}

TEST_CASE("a door that closes is noticed at once, one that falls silent within its time") {
  auto p = std::make_unique<door_tools_test::played_program>();
  talk t(address_in(p->address()));
  REQUIRE(t.until([&] { return t.door.has_rights; }));
  p.reset();
  REQUIRE(t.until([&] { return t.line.is_closed(); }));
  CHECK_NE(t.closed, "");
  t.line.send({{"op", "cca.describe"}});  // changes nothing
  CHECK_EQ(t.line.next().has_value(), false);
}

TEST_CASE("who does not take its samples has a bounded queue, and reads on later") {
  door_tools_test::played_program p;
  talk t(address_in(p.address()));
  REQUIRE(t.until([&] { return t.door.has_rights; }));
  t.line.send({{"op", "subscribe"}, {"subscriptions", {{{"id", 7}, {"channelId", 1}}}}});
  REQUIRE(t.until([&] { return p.beat(), t.samples > 0; }));
  for (int i = 0; i < 20'000; ++i) p.beat();
  for (int i = 0; i < 300; ++i) t.line.wait(1ms);  // nobody calls next()
  std::size_t waiting = 0;
  while (t.line.next()) ++waiting;
  CHECK_GT(waiting, 1000);
  CHECK_LE(waiting, 4200);
  const auto before = t.samples;
  CHECK(t.until([&] { return p.beat(), t.samples > before; }));
}

TEST_CASE("an address is a port, or an address and a port") {
  CHECK_EQ(address_in("8765").text(), "127.0.0.1:8765");
  CHECK_EQ(address_in("robot.local:80").text(), "robot.local:80");
  CHECK_EQ(address_in("[::1]:80").host, "::1");
  CHECK_EQ(address_in("[::1]:80").text(), "[::1]:80");
  for (const char* const wrong : {"", "x", "0", "65536", "123456", "::1:80", ":80", "host:", "host:8x", "-1"})
    CHECK_THROWS_AS(address_in(wrong), cca::command_line_error);
}

TEST_CASE("a token comes from an option, a file or the environment") {
  CHECK_EQ(token_option{.token = "abc"}.value(), "abc");
  CHECK_THROWS_AS(token_option({.token = "a b"}).value(), cca::command_line_error);
  CHECK_THROWS_AS(token_option({.token = "a\r\nX: y"}).value(), cca::command_line_error);
  CHECK_THROWS_AS(token_option({.token = "a", .file = "b"}).value(), cca::command_line_error);
  CHECK_THROWS_AS(token_option({.file = "/no/such/file"}).value(), cca::refused);
  const std::string name = "door_tools_token";
  std::ofstream(name) << "abcdef\n";
  CHECK_EQ(token_option{.file = name}.value(), "abcdef");
  std::remove(name.c_str());
  ::setenv("CCA_TOKEN", "xyz", 1);
  CHECK_EQ(token_option{}.value(), "xyz");
  ::unsetenv("CCA_TOKEN");
  CHECK_EQ(token_option{}.value(), "");
}

TEST_CASE("the arguments of a test are numbers, paths, and axes by name or number") {
  const auto arguments = [](std::vector<std::string> words) {
    words.insert(words.begin(), {"servo.reference", "drive.angle", "sine"});
    return arguments_of_test(call_options{.words = std::move(words)});
  };
  CHECK_EQ(arguments({"axis=elbow", "output_axis=7", "from=limits.safe", "from_axis=", "amplitude=-1e-320"}),
           json{{"input", "servo.reference"},
                {"output", "drive.angle"},
                {"signal", "sine"},
                {"axis", "elbow"},
                {"output_axis", 7},  // the door knows how many there are
                {"from", "limits.safe"},
                {"from_axis", ""},
                {"amplitude", -1e-320}});
  for (const char* wrong :
       {"amplitude=nan", "amplitude=inf", "amplitude=1e999", "amplitude=", "amplitude", "=1", "to=1 Hz"})
    CHECK_THROWS_AS(arguments({wrong}), cca::command_line_error);
}

TEST_CASE("what is typed becomes a value, or is refused with unit and range") {
  const parameter number{"a", "number", "Hz", 1.0, 0.1, 5.0, {}}, whole{"b", "integer", "", 1, {}, {}, {}},
      yes{"c", "boolean", "", true, {}, {}, {}}, text{"d", "text", "", "x", {}, {}, {"x", "y"}},
      numbers{"e", "numbers", "rad", {1.0, 2.0}, {}, {}, {}};
  CHECK_EQ(value_in(number, "-2.5e1"), json(-25.0));
  CHECK_EQ(value_in(whole, "-7"), json(-7));
  CHECK_EQ(value_in(yes, "false"), json(false));
  CHECK_EQ(value_in(text, "5"), json("5"));
  CHECK_EQ(value_in(numbers, "0.5,-1"), json({0.5, -1.0}));
  CHECK_EQ(value_in(number, "200 mHz"), json(200 * 1e-3));
  CHECK_EQ(value_in(number, "2kHz"), json(2000.0));
  CHECK_EQ(value_in(number, "2  Hz"), json(2.0));
  CHECK_THROWS_WITH(value_in(number, "2 deg"), "a = 2 deg: expected a number, 0.1 to 5 Hz");
  CHECK_EQ(value_in(numbers, "30 deg,1 rad"), json({30 * cca::detail::degree, 1.0}));
  CHECK_THROWS_AS(value_in(number, "Hz"), cca::refused);
  CHECK_THROWS_AS(value_in({.path = "a", .kind = "number"}, "2 Hz"), cca::refused);
  CHECK_THROWS_WITH(value_in(number, "2x"), "a = 2x: expected a number, 0.1 to 5 Hz");
  CHECK_THROWS_AS(value_in(number, "nan"), cca::refused);
  CHECK_THROWS_AS(value_in(number, ""), cca::refused);
  CHECK_THROWS_AS(value_in(whole, "1.5"), cca::refused);
  CHECK_THROWS_AS(value_in(whole, "-"), cca::refused);
  CHECK_THROWS_AS(value_in(whole, "99999999999999999999"), cca::refused);
  CHECK_THROWS_WITH(value_in(yes, "maybe"), "c = maybe: expected true or false");
  CHECK_THROWS_WITH(value_in(numbers, "1"), "e = 1: expected 2 numbers with commas between them in rad");
  CHECK_THROWS_AS(value_in(numbers, "1,,2"), cca::refused);
  CHECK_EQ(text_of_value({1.0, 0.1, 1e-9}), "1,0.1,1e-09");
}

TEST_CASE("a schema with inner messages, arrays and texts, and bytes that do not fit it") {
  const message_schema schema(
      "std_msgs/Header header\nstring[] name\nfloat64[2] pair\nbool on\nint64 kind  # 0 walk, 1 trot\nuint8 "
      "MOST=7\n"
      "================\nMSG: std_msgs/Header\nbuiltin_interfaces/msg/Time stamp\nstring frame_id\n"
      "================\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n");
  unsigned char memory[256];
  cca::recording::detail::cdr_writer to(memory);
  to.add(std::int32_t{5})
      .add(std::uint32_t{7})
      .add(std::string_view("hip"))
      .add(std::uint32_t{2})
      .add(std::string_view("a"))
      .add(std::string_view("bc"));
  to.add(1.5).add(-2.0).add(std::uint8_t{1}).add(std::int64_t{1});
  const std::string bytes(reinterpret_cast<const char*>(to.view().data()), to.view().size());
  const auto read = schema.read(bytes);
  REQUIRE(read);
  CHECK_EQ(
      read->dump(),
      R"({"header":{"stamp":{"sec":5,"nanosec":7},"frame_id":"hip"},"name":["a","bc"],"pair":[1.5,-2.0],"on":true,"kind":1})");
  CHECK_EQ(schema.fields()[4].unit, "");
  for (std::size_t size = 0; size < bytes.size(); ++size) CHECK(!schema.read(bytes.substr(0, size)));
  CHECK(!message_schema("other/Type x\n").read(bytes));
  CHECK(!message_schema("").read(bytes));
  // A message within itself, and an array of more than the message has.
  CHECK(!message_schema("a/B b\n===\nMSG: a/B\na/B b\n").read(bytes));
  CHECK(!message_schema("a/B[] b\n===\nMSG: a/B\n").read(std::string("\0\1\0\0\xff\xff\xff\xff", 8)));
  CHECK(!message_schema("float64[] x\n").read(std::string("\0\1\0\0\xff\xff\xff\x7f", 8)));
}
