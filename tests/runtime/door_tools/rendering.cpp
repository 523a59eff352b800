// What cca-top shows, line by line, without a terminal and without a door.
#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

#include <cca/record/messages/cdr.hpp>

#include "../../../tools/door/top/draw.hpp"
#include "../../../tools/door/top/keys.hpp"
#include "../../../tools/door/top/press.hpp"
#include "../../../tools/door/top/screen.hpp"

namespace {

using namespace cca_door;

event text_event(json message) { return {.what = event::kind::text, .message = std::move(message)}; }
event sample_event(std::uint32_t id, std::uint64_t time, std::string bytes) {
  return {.what = event::kind::sample, .id = id, .time = time, .bytes = std::move(bytes)};
}

std::string sample_bytes(std::int64_t beat, std::initializer_list<double> values) {
  unsigned char memory[256];
  cca::recording::detail::cdr_writer to(memory);
  to.add(beat).add(beat * 1'000'000);
  for (const double one : values) to.add(one);
  return {reinterpret_cast<const char*>(to.view().data()), to.view().size()};
}

json channel_json(int id, const std::string& topic) {
  return {{"id", id},
          {"topic", topic},
          {"encoding", "cdr"},
          {"schemaName", "cca/msg/one"},
          {"schema", "int64 beat\nint64 origin  # ns\nfloat64 hip  # rad\nfloat64 knee\n"}};
}

json status_json() {
  return {{"state", "running"},
          {"beat", 2000},
          {"period", 1000000},
          {"overruns", 0},
          {"is_paused", false},
          {"speed", 1.0},
          {"mode", "walk"},
          {"fault", ""},
          {"fault_path", ""},
          {"recording", "trot.mcap"},
          {"clients", 2},
          {"stopped_parts", json::array()},
          {"environments",
           {{{"name", "robot"},
             {"beats", 2000},
             {"overruns", 3},
             {"lost_periods", 0},
             {"late", 1},
             {"beat_mean", 12.1e-6},
             {"beat_p99", 25e-6},
             {"beat_most", 101e-6},
             {"wake_up_mean", 4e-6},
             {"wake_up_p99", 12e-6},
             {"wake_up_most", 0.0812}}}}};
}

// A terminal whose program has greeted, with `count` outputs more than the two.
struct shown_program {
  top_model model{true};
  top_view view{};
  terminal_size size{};
  bool utf8 = true;

  explicit shown_program(int count = 0, const std::string& prefix = "/mind/part_") {
    model.take({.what = event::kind::opened});
    json channels{{{"id", 60001}, {"topic", "/cca/status"}, {"encoding", "json"}},
                  {{"id", 60002}, {"topic", "/cca/log"}, {"encoding", "json"}},
                  channel_json(1, "/gait/angles"),
                  channel_json(2, "/robot/angles")};
    channels.push_back(
        {{"id", 3}, {"topic", "/cca/state"}, {"encoding", "cdr"}, {"schema", "int64 beat\nstring state\n"}});
    for (int i = 0; i < count; ++i)
      channels.push_back(channel_json(4 + i, prefix + std::to_string(i) + "/status"));
    model.take(text_event({{"op", "advertise"}, {"channels", channels}}));
    rights(true, false, "");
    model.take(
        text_event({{"op", "cca.description"},
                    {"program", "trot"},
                    {"nodes", {"gait", "robot", "sink"}},
                    {"parameters",
                     {{{"path", "gait.frequency"},
                       {"kind", "number"},
                       {"value", 1.5},
                       {"unit", "Hz"},
                       {"lower", 0.1},
                       {"upper", 5.0},
                       {"choices", json::array()}},
                      {{"path", "gait.kind"},
                       {"kind", "text"},
                       {"value", "trot"},
                       {"unit", ""},
                       {"choices", {"trot", "walk"}}}}},
                    {"commands",
                     {{{"name", "push"},
                       {"help", "pushes the trunk"},
                       {"held", true},
                       {"arguments",
                        {{{"name", "forward"}, {"unit", "N"}, {"value", 10}, {"lower", -60}, {"upper", 60}},
                         {{"name", "left"}, {"unit", "N"}, {"value", 0}, {"lower", -60}, {"upper", 60}}}}},
                      {{"name", "wave"}, {"help", ""}, {"held", false}, {"arguments", json::array()}}}}}));
    status(status_json());
    lines();
    model.look_at(view.looked_at);
  }
  void rights(bool may, bool commands, const std::string& who) {
    model.take(text_event({{"op", "cca.rights"},
                           {"mayChange", may},
                           {"commands", commands},
                           {"commandedBy", who.empty() ? json() : json(who)}}));
  }
  void status(const json& all) { model.take(sample_event(1, 2'000'000'000, all.dump())); }
  std::vector<std::string> lines() {
    std::vector<std::string> all;
    for (const screen_line& one : draw(model, view, "127.0.0.1:8765", size, utf8)) {
      all.push_back(one.text());
      CHECK_LE(columns_of(one.text(), utf8), size.width);
    }
    CHECK_EQ(all.size(), size.height);
    return all;
  }
  // The first line with this text; empty: there is none.
  std::string line_with(std::string_view text) {
    for (const std::string& one : lines())
      if (one.find(text) != one.npos) return one;
    return {};
  }
  void press_keys(std::string_view bytes) {
    key_reader keys;
    keys.add(bytes);
    while (const auto one = keys.next(true)) press(*one, model, view);
  }
  // The door's answer to the calls that it wants to send; empty: it is done.
  void answer(const std::string& refusal = {}) {
    std::uint32_t call = 0;
    for (const to_door& one : std::exchange(model.outgoing, {})) {
      model.called(++call, one);
      model.take({.what = event::kind::answer,
                  .message = {{"success", refusal.empty()}, {"message", refusal}},
                  .id = call});
    }
  }
  // Services and messages that it wants to send, and forgets.
  std::string asked() {
    std::string all;
    for (const to_door& one : std::exchange(model.outgoing, {}))
      all += one.service.empty() ? text_in(one.message, "op") + ";" : one.service + one.message.dump() + ";";
    return all;
  }
  const watched_output& output(std::size_t i) const { return model.outputs[i]; }
};

}  // namespace

TEST_CASE("a whole screen of 80 by 24") {
  shown_program p;
  const auto lines = p.lines();
  CHECK_EQ(lines[0], " cca-top 127.0.0.1:8765  trot                                           running ");
  CHECK_EQ(lines[1], "time 2.000 s  beat 2000 of 1.00 ms  speed 1  mode walk");
  CHECK_EQ(lines[2], "you may take the command, nobody commands  2 clients  recording trot.mcap");
  CHECK_EQ(lines[3], "environment       beats overruns  lost  late beat mean/p99/max wake mean/p99/max");
  CHECK_EQ(lines[4], "robot              2000        3     0     1      12/25/101 us 0.004/0.012/81 ms");
  CHECK_EQ(lines[5].substr(0, 54), " 1 components   2 parameters   3 log   4 environments ");
  CHECK_EQ(lines[6], "output                              rate       age  values");
  CHECK_EQ(lines[7].substr(0, 50), "gait.angles                            -  none yet");
  CHECK_EQ(lines[9], "sink                                                no outputs");
  CHECK_EQ(lines[23], " SPACE STOP  c command p pause g go on n step w end recording / find q quit");
}

TEST_CASE("rates and ages are those of virtual time") {
  shown_program p;
  const std::uint32_t gait = p.output(0).subscription, robot = p.output(1).subscription;
  REQUIRE_GT(gait, 2);
  for (int k = 0; k <= 1000; ++k) {
    p.model.take(sample_event(gait, 2'000'000'000 + static_cast<std::uint64_t>(k) * 1'000'000,
                              sample_bytes(2000 + k, {0.25, -1.5})));
    if (k % 4 == 0)
      p.model.take(sample_event(robot, 2'000'000'000 + static_cast<std::uint64_t>(k) * 1'000'000,
                                sample_bytes(2000 + k, {1, 2})));
  }
  p.model.each_second();
  CHECK_EQ(p.output(0).rate(), doctest::Approx(1000));
  CHECK_EQ(p.output(1).rate(), doctest::Approx(250));
  CHECK_EQ(p.line_with("gait.angles"),
           "gait.angles                      1000 Hz      0 us  0.25 -1.5                   ");
  // Time goes on, the outputs do not.
  p.model.take({.what = event::kind::time, .time = 15'500'000'000});
  p.model.each_second();
  CHECK_EQ(p.line_with("gait.angles").substr(0, 61),
           "gait.angles                            -    12.5 s  0.25 -1.5");
}

TEST_CASE("an output that is slower than a second has its rate") {
  shown_program p;
  for (std::uint64_t k = 0; k < 6; ++k) {
    p.model.take(
        sample_event(p.output(0).subscription, 2'000'000'000 + k * 4'000'000'000, sample_bytes(1, {0, 0})));
    for (int i = 0; i < 4; ++i) p.model.each_second();
  }
  CHECK_EQ(p.output(0).rate(), doctest::Approx(0.25));
}

TEST_CASE("of 300 outputs only those on the screen are subscribed") {
  shown_program p(300);
  CHECK_EQ(p.view.looked_at.size(), 15);
  CHECK(p.view.looked_at.contains("gait.angles"));
  CHECK(!p.view.looked_at.contains("mind.part_299.status"));
  CHECK(p.line_with("1 components").ends_with("1-15 of 303"));
  p.asked();

  p.press_keys("\x1b[F");  // the last one
  CHECK_NE(p.line_with("mind.part_299.status"), "");
  CHECK_EQ(p.line_with("gait.angles"), "");
  p.model.look_at(p.view.looked_at);
  CHECK_EQ(p.asked(), "unsubscribe;subscribe;");
  CHECK_EQ(p.output(0).subscription, 0);
  CHECK_GT(p.output(301).subscription, 0);
  // A late sample of the old subscription changes nothing.
  p.model.take(sample_event(3, 5, sample_bytes(1, {0, 0})));
  CHECK(!p.output(0).age(p.model.now).has_value());

  p.press_keys("/part_17");
  CHECK(p.line_with("1 components").ends_with("/part_17"));
  CHECK_EQ(p.view.row_count(p.model), 11);  // 17 and 170 to 179
  p.press_keys("\x1b");
  CHECK_EQ(p.view.row_count(p.model), 303);
}

TEST_CASE("a recording that can't be written any more has a line of its own") {
  shown_program p;
  CHECK_EQ(p.line_with("INCOMPLETE"), "");
  json status = status_json();
  status["recording_problem"] = "trot.mcap can't be written: No space left on device";
  p.status(status);
  CHECK_EQ(p.line_with("INCOMPLETE"),
           "RECORDING INCOMPLETE trot.mcap can't be written: No space left on device");
}

TEST_CASE("names longer than their columns keep their end, and no line is too wide") {
  shown_program p(3, "/a_component_with_a_name/that_does_not_fit/into_any_column_of_a_terminal/number_");
  CHECK(p.line_with("number_1").starts_with("~"));
  CHECK_NE(p.line_with("number_1.status "), "");
  json status = status_json();
  status["mode"] = std::string(200, 'm');
  status["recording"] = std::string(200, 'r');
  status["environments"][0]["name"] = std::string(200, 'e');
  status["environments"][0]["beats"] = 123456789012345;
  p.status(status);
  CHECK_NE(p.line_with("eee~"), "");
  CHECK_NE(p.line_with("###########"), "");  // a number that was cut would be another one
  for (const std::size_t width : {1u, 7u, 20u, 40u, 79u, 80u, 200u})
    for (const std::size_t height : {1u, 2u, 5u, 9u, 24u, 60u})
      for (const page at : {page::components, page::parameters, page::log, page::environments}) {
        p.size = {width, height};
        p.view.at = at;
        p.lines();  // checks each line
      }
}

TEST_CASE("on the smallest terminal the last line is that of STOP") {
  shown_program p;
  p.size = {14, 3};
  CHECK_EQ(p.lines().back(), " SPACE STOP  c");
}

TEST_CASE("what the program sends can't control the terminal") {
  shown_program p;
  json status = status_json();
  status["fault"] = "\x1b[2J\x07gone\xc2\x9b\x7f", status["fault_path"] = "robot";
  p.status(status);
  CHECK_EQ(p.line_with("FAULT"), "FAULT robot: ?[2J?gone???");
  CHECK_NE(p.line_with("robot.angles").find("FAULT"), std::string::npos);
}

TEST_CASE("characters of two columns, and a terminal without UTF-8") {
  CHECK_EQ(left("\xe5\x8f\xb3\xe8\x85\xbf", 5, true), "\xe5\x8f\xb3\xe8\x85\xbf ");
  CHECK_EQ(left("\xe5\x8f\xb3\xe8\x85\xbf", 3, true), "\xe5\x8f\xb3~");
  CHECK_EQ(left("\xe5\x8f\xb3\xe8\x85\xbf", 2, true), "~ ");
  CHECK_EQ(left("e\xcc\x81t\xc3\xa9", 4, true), "e\xcc\x81t\xc3\xa9 ");
  CHECK_EQ(left("\xc2\xb5m", 3, false), "?m ");
  CHECK_EQ(left("\xff\xfe", 3, true), "?? ");
  CHECK_EQ(end_of("robot.left_front", 8, true), "~t_front");
  CHECK_EQ(right("1234", 3, true), "###");
}

TEST_CASE("a part that rests, a fault and a lost connection are shown") {
  shown_program p;
  json status = status_json();
  status["stopped_parts"] = {"gait"};
  p.status(status);
  CHECK_EQ(p.line_with("stopped:"), "stopped: gait");
  CHECK_NE(p.line_with("gait.angles").find(" stopped "), std::string::npos);
  p.model.take({.what = event::kind::closed, .bytes = "the connection is lost"});
  const auto lines = p.lines();
  CHECK(lines[0].ends_with("NOT CONNECTED "));
  CHECK_EQ(lines[1], "the connection is lost; trying again");
  p.asked();
  p.press_keys(" ");
  CHECK_EQ(p.asked(), "");
  CHECK_EQ(p.line_with("STOP WAS"), "NOT CONNECTED: STOP WAS NOT SENT");
}

TEST_CASE("STOP is one key, everywhere") {
  shown_program p;
  p.asked();
  p.press_keys(" ");
  CHECK_EQ(p.asked(), "/cca/stop{};");  // without the right to command
  p.rights(true, true, "127.0.0.1:1");
  p.press_keys("2\r1");  // a value is being typed
  CHECK_NE(p.line_with("gait.frequency (0.1 to 5 Hz) = 1.51"), "");
  CHECK(p.lines().back().starts_with(" SPACE STOP "));
  p.press_keys(" ");
  CHECK_EQ(p.asked(), "/cca/stop{};");
  p.press_keys("\x1b[200~2 5\x1b[201~");  // what is pasted is no key
  CHECK_EQ(p.asked(), "");
  CHECK_EQ(p.view.typed, "1.512 5");
}

TEST_CASE("without the token nothing is sent, and the screen says so") {
  shown_program p;
  p.model.has_token = false;
  p.rights(false, false, "127.0.0.1:9");
  p.asked();
  p.press_keys(" pgnuc2\r");
  CHECK_EQ(p.asked(), "");
  CHECK_NE(p.line_with("you only read, 127.0.0.1:9 commands"), "");
  CHECK_NE(p.line_with("SPACE STOP needs a token"), "");
  CHECK_EQ(p.view.types, top_view::typing::nothing);
}

TEST_CASE("without the right to command nothing is sent, and it says who has it") {
  shown_program p;
  p.rights(true, false, "127.0.0.1:9");
  p.asked();
  p.press_keys("pgnu");
  CHECK_EQ(p.asked(), "");
  CHECK_NE(p.line_with("127.0.0.1:9 commands, and must give the command back first"), "");
  p.press_keys("c");
  CHECK_EQ(p.asked(), "/cca/take_command{};");
  p.rights(true, true, "127.0.0.1:2");
  p.press_keys("pgnuc");
  CHECK_EQ(p.asked(), R"(/cca/pause{};/cca/go_on{};/cca/step{"beats":1};/cca/undo{};/cca/give_command{};)");
}

TEST_CASE("before the door has told its rights nothing is sent, and nobody is said to command") {
  shown_program p;
  p.model.take({.what = event::kind::opened});
  p.asked();
  p.press_keys("pgnucw");
  CHECK_EQ(p.asked(), "");
  CHECK_NE(p.line_with("asks the door what you may do"), "");
  CHECK_EQ(p.line_with("nobody commands"), "");
  CHECK_NE(p.line_with("the door has not said yet what you may do"), "");
  p.rights(true, false, "");
  p.press_keys("c");
  CHECK_NE(p.asked().find("/cca/take_command{};"), std::string::npos);
}

TEST_CASE("a value is typed, sent, taken or refused") {
  shown_program p;
  p.rights(true, true, "127.0.0.1:2");
  p.asked();
  p.press_keys("2\r\x15zwei\r");
  CHECK_EQ(p.asked(), "");
  CHECK_NE(p.line_with("gait.frequency = zwei: expected a number, 0.1 to 5 Hz"), "");
  p.press_keys(
      "\r\x15"
      "2.5\x1b[D\x1b[D\x7f"
      "3\r");  // left, left, back: 3.5
  REQUIRE_EQ(p.model.outgoing.size(), 1);
  CHECK_EQ(p.model.outgoing[0].message["parameters"].dump(), R"([{"name":"gait.frequency","value":3.5}])");
  p.model.take(text_event({{"op", "parameterValues"},
                           {"id", "top"},
                           {"parameters", {{{"name", "gait.frequency"}, {"value", 3.5}}}}}));
  CHECK_NE(p.line_with("gait.frequency is 3.5 Hz"), "");
  p.model.take(
      text_event({{"op", "status"},
                  {"level", 2},
                  {"message", "setParameters: gait.frequency = 9: expected a number from 0.1 to 5 Hz"}}));
  CHECK_NE(p.line_with("gait.frequency = 9: expected a number from 0.1 to 5 Hz"), "");
  p.press_keys("\r9\x1b");  // escape: as it was
  CHECK_EQ(p.view.types, top_view::typing::nothing);
  CHECK_NE(p.line_with("gait.frequency                  3.5"), "");
}

TEST_CASE("a command is held from one enter to the next") {
  shown_program p;
  p.press_keys("5");
  CHECK_NE(p.line_with("push              forward (-60 to 60 N), left (-60 to 60 N)  pushes the trunk"), "");
  p.asked();
  p.press_keys("\r");
  CHECK_EQ(p.asked(), "");
  CHECK_NE(p.line_with("press c to take the right to command first"), "");
  p.rights(true, true, "127.0.0.1:2");
  p.press_keys("\r");
  CHECK_NE(p.line_with("push forward=10,left=0"), "");
  p.press_keys("\x15left=-5\r");
  REQUIRE_EQ(p.model.outgoing.size(), 1);
  CHECK_EQ(p.model.outgoing[0].message.dump(), R"({"left":-5.0})");
  CHECK_EQ(p.line_with("HELD"), "");  // not before the door says so
  p.answer("it has fallen");
  CHECK_EQ(p.line_with("HELD"), "");
  CHECK_NE(p.line_with("it has fallen"), "");
  p.press_keys("\r\r");
  CHECK_EQ(p.model.outgoing[0].message.dump(), R"({"left":-5.0})");  // what was typed last
  p.answer();
  CHECK_NE(p.line_with("push              HELD, enter releases it"), "");
  CHECK_NE(p.line_with("enter release"), "");
  p.press_keys("\r");
  CHECK_EQ(p.model.outgoing[0].service, "/cca/release/push");
  p.answer();
  CHECK_EQ(p.line_with("HELD"), "");
  // The door releases it where the right to command, or the connection, is lost.
  p.press_keys("\r\r");
  p.answer();
  CHECK_NE(p.line_with("HELD"), "");
  p.rights(true, false, "127.0.0.1:9");
  CHECK_EQ(p.line_with("HELD"), "");
  p.rights(true, true, "127.0.0.1:2");
  p.press_keys("\r\r");
  p.answer();
  p.model.take({.what = event::kind::closed, .bytes = "gone"});
  CHECK_EQ(p.line_with("HELD"), "");
}

TEST_CASE("what is no argument of a command is not sent, and one without arguments is called at once") {
  shown_program p;
  p.rights(true, true, "127.0.0.1:2");
  p.asked();
  p.press_keys("5\r\x15up=3\r");
  CHECK_NE(p.line_with("push: up=3: expected an argument, as forward=1"), "");
  p.press_keys(
      "\r\x15"
      "forward\r");
  CHECK_NE(p.line_with("push: forward: expected an argument"), "");
  p.press_keys(
      "\r\x15"
      "forward=much\r");
  CHECK_NE(p.line_with("forward = much: expected a number, -60 to 60 N"), "");
  CHECK_EQ(p.asked(), "");
  p.press_keys("j\r");
  CHECK_EQ(p.asked(), "/cca/command/wave{};");
  p.press_keys("/pu\r");
  CHECK_EQ(p.line_with("wave"), "");
}

TEST_CASE("w records into a file, and ends it") {
  shown_program p;
  p.rights(true, true, "127.0.0.1:2");
  p.asked();
  p.press_keys("w");  // trot.mcap is being recorded
  CHECK_EQ(p.asked(), "/cca/end_recording{};");
  json idle = status_json();
  idle["recording"] = "";
  p.status(idle);
  p.press_keys("w");
  CHECK_NE(p.line_with("record into run.mcap"), "");
  p.press_keys("\x15walk.mcap\r");
  CHECK_EQ(p.asked(), R"(/cca/record{"file":"walk.mcap"};)");
  p.press_keys("w\x1b");
  CHECK_EQ(p.asked(), "");
  p.rights(true, false, "127.0.0.1:9");
  p.press_keys("w");
  CHECK_EQ(p.view.types, top_view::typing::nothing);
}

TEST_CASE("what the twins of others find is above the pages") {
  shown_program p;
  json told = status_json();
  told["twins"] = {{{"client", "127.0.0.1:7"}, {"says", "the same, bit for bit: 9 beats"}},
                   {{"client", "192.168.1.5:7"}, {"says", "first difference: component cpg"}}};
  p.status(told);
  CHECK_EQ(p.lines()[3], "twin of 127.0.0.1:7: the same, bit for bit: 9 beats");
  CHECK_EQ(p.lines()[4], "twin of 192.168.1.5:7: first difference: component cpg");
}

TEST_CASE("a long refusal has two lines") {
  shown_program p;
  p.model.remark_on(std::string(60, 'a') + " " + std::string(60, 'b'), true);
  const auto lines = p.lines();
  CHECK_EQ(lines[21], std::string(60, 'a') + " " + std::string(19, 'b'));
  CHECK_EQ(lines[22], std::string(41, 'b'));
}

TEST_CASE("the log has the newest line first") {
  shown_program p;
  p.model.take(sample_event(2, 1, R"({"time":0,"client":"127.0.0.1:7","what":"takes the command"})"));
  p.model.take(sample_event(2, 1, R"({"time":1,"client":"10.0.0.1:7","what":"refused: /cca/pause"})"));
  p.press_keys("3");
  const auto lines = p.lines();
  CHECK_NE(lines[7].find("10.0.0.1:7      refused: /cca/pause"), std::string::npos);
  CHECK_NE(lines[8].find(":7              takes the command"), std::string::npos);
}

TEST_CASE("only lines that differ are written") {
  screen image;
  const terminal_size size{10, 2};
  std::vector<screen_line> lines(2, screen_line(10, true));
  lines[0].add("one"), lines[1].add("two");
  CHECK_NE(image.show(lines, size).find("\x1b[2J"), std::string::npos);
  CHECK_EQ(image.show(lines, size), "");
  lines[1] = screen_line(10, true).add("three");
  CHECK_EQ(image.show(lines, size), "\x1b[?2026h\x1b[2;1H\x1b[0mthree\x1b[0m\x1b[K\x1b[?2026l");
  CHECK_NE(image.show(lines, {20, 2}).find("\x1b[2J"), std::string::npos);  // resized: everything
}

TEST_CASE("codes of keys come in pieces") {
  key_reader keys;
  keys.add("\x1b");
  CHECK(!keys.next(false).has_value());
  keys.add("[");
  CHECK(!keys.next(false).has_value());
  keys.add("A");
  CHECK_EQ(keys.next(false)->what, key::kind::up);
  keys.add("\x1b");
  CHECK_EQ(keys.next(true)->what, key::kind::escape);
  keys.add("\x1bOB\x1b[1;5C\x1b[200~a");
  CHECK_EQ(keys.next(false)->what, key::kind::down);
  CHECK_EQ(keys.next(false)->what, key::kind::unknown);
  CHECK(!keys.next(false).has_value());
  keys.add(" b\x1b[201~\x03");
  CHECK_EQ(keys.next(false)->text, "a b");
  CHECK_EQ(keys.next(false)->what, key::kind::interrupt);
}
