// Several clients of a door, without its network, in any order: they come with the token, without it and with
// wrong ones, go, take the command, give it back, set, call, test, and send anything; the program behind is
// busy, refuses, or takes what waits later. After each step: nobody has the token who has not shown it, the
// one commands who should, the program was asked for nothing by others, in ranges, and who may not read has
// read nothing. What a client held ends with its right to command.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/door/network/hub_functions.hpp>

#include "../runtime/door/client.hpp"
#include "../runtime/door/fake_controls.hpp"
#include "door_frames.hpp"
#include "must.hpp"

namespace {

namespace net = cca::detail::door_network;
using about = cca::detail::door_request::what;
using door_test::fake_controls;
const std::string token = "0123456789abcdef";
const std::string node = "test_servo_reference";

// Said at the end: how much the fuzzer judged.
struct messages_judged {
  unsigned long long count = 0;

  ~messages_judged() { std::fprintf(stderr, "%llu messages judged: nothing that was not allowed\n", count); }
};
messages_judged judged;

class several {
public:
  several(unsigned how, std::string_view all) : left(all) {
    controls.offer_test();
    settings.on_lost = std::array{cca::when_lost::go_on, cca::when_lost::hold, cca::when_lost::stop,
                                  cca::when_lost::go_on}[how & 3];
    guards_reading = (how & 4) != 0;
    door =
        std::make_unique<net::hub>(settings, limits, controls, token, keys, guards_reading, *wanted, twins);
    services = net::services_of(controls.description());
    for (const char* topic : {"/a", "/robot/angles", "/test_servo_reference/excitation"}) announce(topic);
  }

  void run() {
    while (!left.empty()) {
      const unsigned what = byte();
      const std::size_t who = what & 3;
      before = controls.asked().size();
      was_idle = !door->is_busy();
      stops = false;
      if (Client* c = clients[who] ? &*clients[who] : nullptr) act(*c, who, what >> 2);
      else enter(who, what >> 2);
      look();
    }
    for (std::size_t who = 0; who < clients.size(); ++who)
      if (clients[who]) leave(who);
    controls.answers(fake_controls::how::done);
    pass(1000);
    fuzz::must(!door->is_busy());
    look();
  }

private:
  struct Client {
    net::door_client* at;
    bool has_shown = false;  // the right token, or something that may be it
    bool may_have_commanded = false;
    std::optional<net::json> rights{};
    std::map<std::uint32_t, bool> answers{};  // of calls, since the last look
  };

  std::string_view left;
  fake_controls controls{};
  cca::door_settings settings{};
  const cca::detail::door_limits limits{};
  net::one_time_keys keys{};
  std::unique_ptr<net::wanted_channels> wanted = std::make_unique<net::wanted_channels>();
  net::kept_for_twins twins{1 << 10, {}};
  std::unique_ptr<net::hub> door{};
  std::vector<net::door_service> services{};
  std::array<std::optional<Client>, 4> clients{};
  net::time_point now{std::chrono::hours(1)};
  std::uint64_t run_time = 0, tested_until = 0;
  bool guards_reading = false, has_refused = false, was_idle = true, stops = false;
  std::optional<std::size_t> commands{};  // which client should
  std::size_t before = 0, seen = 0, lost = 0, given = 0, ends_of_lost = 0, last_channel = 0;
  std::size_t ends_of_steps = 0, ends_of_speed = 0;
  std::set<double> speeds{1};  // that it had
  std::uint32_t last_call = 0;
  std::map<about, std::size_t> allowed{}, taken{};
  // `begun`: one may still be taken of a client that is lost. `is_mixed`: some wait of one that has given
  // back.
  bool is_pushed = false, is_tested = false, begun = false, is_mixed = false;

  unsigned byte() {
    if (left.empty()) return 0;
    const unsigned char one = static_cast<unsigned char>(left.front());
    left.remove_prefix(1);
    return one;
  }
  std::string_view line() {
    const std::string_view all = left.substr(0, left.find('\n'));
    left.remove_prefix(std::min(left.size(), all.size() + 1));
    return all;
  }
  void announce(const std::string& topic) {
    last_channel = last_channel % 4 + 1;
    door->channel({.id = static_cast<std::uint16_t>(last_channel),
                   .topic = topic,
                   .type = "a",
                   .schema = "",
                   .metadata = {{"axes", "arm"}},
                   .is_kept = true});
  }

  // ---- steps ----

  void enter(std::size_t who, unsigned how) {
    net::greeting hello;
    hello.knows_cca = (how & 8) != 0;
    hello.takes_batches = (how & 16) != 0;
    hello.has_token = how % 4 == 1 || how % 4 == 2;
    hello.token_offered = how % 4 == 1 ? token : "0123456789abcdeg";
    if (how % 4 == 3) hello.once = (how & 4) != 0 ? keys.make() : "0123456789abcdef0123456789abcdef";
    const bool has_key = how % 4 == 3 && (how & 4) != 0;
    if (has_key && !commands) commands = who;
    clients[who] = Client{.at = &door->enter("127.0.0.1:" + std::to_string(who), hello, now),
                          .has_shown = how % 4 == 1 || has_key};
    fuzz::must(clients[who]->at->has_token == clients[who]->has_shown);
  }
  void leave(std::size_t who) {
    const bool commanded = commands == who;
    if (commanded) {
      look();
      commands.reset(), ++lost;
      // What it asked for and nobody has begun is forgotten.
      if (!is_mixed) {
        const std::size_t stopping = allowed[about::end_run];
        allowed = taken;
        allowed[about::end_run] = stopping;
        begun = door->is_busy();
      }
    }
    net::door_client& gone = *clients[who]->at;
    clients[who].reset();
    door->leave(gone, now);
  }
  void act(Client& c, std::size_t who, unsigned what) {
    const bool may = c.at->has_token && commands == who;
    switch (what % 14) {
      case 0:
        return leave(who);
      case 1:
      case 2: {
        const std::string_view text = line();
        if (text.find("444") != text.npos || text.find("\\u") != text.npos) return;  // marks
        return hear(c, who, what % 14 == 1 ? net::frame_kind::text : net::frame_kind::binary, text);
      }
      case 3:
        return call(c, who, 1 + byte() % services.size(), arguments(may));
      case 4:
        return call(c, who, 1, "{}");
      case 5:
        return call(c, who, 2, "{}");
      case 6:
      case 7:
        return hear(c, who, net::frame_kind::text, change(may));
      case 8:
        return hear(
            c, who, net::frame_kind::text,
            R"({"op":"cca.token","token":")" + std::string(byte() % 2 ? token : "0123456789abcdeg") + "\"}");
      case 9:
        return pass(byte() * 50);
      case 10: {
        const auto how = std::array{fake_controls::how::done, fake_controls::how::begun,
                                    fake_controls::how::busy, fake_controls::how::refused}[byte() % 4];
        has_refused = has_refused || how == fake_controls::how::refused;
        return controls.answers(how);
      }
      case 11:
        run_time += byte() * std::uint64_t{100'000'000};
        return door->time(run_time);
      case 12:
        if (byte() % 4 == 0) return announce("/robot/angles");
        return sample();
      default:
        return call(c, who, 1 + (services.size() - 3) + byte() % 3, arguments(may));
    }
  }
  // Of a client that may not, each has a mark, which must come nowhere.
  std::string arguments(bool may) {
    static const std::array all{
        R"({})",
        R"({"force":12,"angle":1})",
        R"({"beats":3})",
        R"({"factor":0.5})",
        R"({"mode":"stand"})",
        R"({"part":"arm"})",
        R"({"file":"a.toml"})",
        R"({"file":"a.mcap"})",
        R"({"input":"servo.reference","output":"robot.angles","signal":"sine","amplitude":0.1})",
        R"({"input":"servo.reference","output":"robot.angles","signal":"chirp","amplitude":1e300,"duration":1e300})",
        R"({"file":"../a.toml"})",
        R"({"force":1e300})",

        R"({"beats":1e18})"};
    static const std::array marked{
        R"({})",
        R"({"force":44.4,"angle":1})",
        R"({"beats":444})",
        R"({"factor":444})",
        R"({"mode":"444"})",
        R"({"part":"444"})",
        R"({"file":"444.toml"})",
        R"({"file":"444.mcap"})",
        R"({"input":"servo.reference","output":"robot.angles","signal":"sine","amplitude":0.444})",
        R"({"file":"../444.toml"})",
        R"({"force":444})",
        R"({"force":44.4})",
        R"({"scope":"444"})"};
    const std::size_t which = byte() % all.size();
    return may ? all[which] : marked[which];
  }
  std::string change(bool may) {
    static const std::array all{R"({"name":"gait.frequency","value":2.5})",
                                R"({"name":"gait.frequency","value":9})",
                                R"({"name":"gait.steps","value":4})",
                                R"({"name":"gait.gains","value":[1,2,3]})",
                                R"({"name":"gait.kind","value":"walk"})",
                                R"({"name":"gait.gains","value":["NaN",2,3]})",
                                R"({"name":"gait.is_on","value":false})",
                                R"({"name":"gait.steps","value":1e300})",
                                R"({"name":"test_servo_reference.signal","value":"step"})"};
    static const std::array marked{R"({"name":"gait.frequency","value":4.44})",
                                   R"({"name":"gait.gains","value":[4.44,2,3]})"};
    const unsigned which = byte();
    return std::string(R"({"op":"setParameters","parameters":[)") +
           (may ? all[which % all.size()] : marked[which % marked.size()]) + R"(],"id":"a"})";
  }
  void call(Client& c, std::size_t who, std::size_t service, const std::string& payload) {
    hear(c, who, net::frame_kind::binary,
         door_test::client::bytes_of_call(static_cast<std::uint32_t>(service), ++last_call + 1'000'000,
                                          payload));
  }
  void sample() {
    const std::uint64_t beat = run_time / 1'000'000;
    std::string data(4, '\0');
    for (const std::uint64_t number : {beat, run_time, std::uint64_t{0x3ff0000000000000}})
      net::add_number(data, number);
    for (std::uint16_t id = 1; id <= 4; ++id) door->sample(id, run_time, data);
  }
  void pass(std::size_t milliseconds) {
    for (std::size_t t = 0; t <= milliseconds; t += 100) {
      now += std::chrono::milliseconds(100);
      door->tick(now);
      door->regularly(now);
      for (std::size_t who = 0; who < clients.size(); ++who)  // as the server does
        if (clients[who] && clients[who]->at->closing != net::no_fault) leave(who);
    }
  }

  // A message, and what it may do.
  void hear(Client& c, std::size_t who, net::frame_kind kind, std::string_view payload) {
    ++judged.count;
    now += std::chrono::milliseconds(2);
    const bool is_heard = c.at->closing == net::no_fault, had_token = c.at->has_token;
    const bool may = had_token && commands == who;
    if (kind == net::frame_kind::text) {
      const auto m = net::json::parse(payload, nullptr, false);
      if (is_heard && m.is_object() && net::text_member(m, "token") == token) c.has_shown = true;
      if (is_heard && may) ++allowed[about::set];
    }
    const auto one = kind == net::frame_kind::binary ? net::read_call(payload) : std::nullopt;
    std::optional<bool> succeeds;  // of the rights
    if (is_heard && one && one->service > 0 && one->service <= services.size() && c.at->may_read() &&
        one->encoding == "json" && net::read_json(one->payload.empty() ? "{}" : one->payload, limits.depth)) {
      const net::door_service& of = services[one->service - 1];
      using does = net::door_service::does;
      if (of.what == does::take_command) {
        succeeds = had_token && (!commands || commands == who);
        if (*succeeds) commands = who;
      } else if (of.what == does::give_command) {
        succeeds = may;
        if (*succeeds) commands.reset(), ++given, is_mixed = is_mixed || door->is_busy();
      } else if (of.about == about::end_run && of.what == does::request) {
        stops = had_token;
        allowed[about::end_run] += had_token;
      } else if (may) {
        ++allowed[of.what == does::request ? of.about : about::set];
      }
      c.may_have_commanded = c.may_have_commanded || may;
    }
    if (door->hears(*c.at, payload.size() + 6, now)) door->message(*c.at, kind, payload, now);
    read(c);
    if (succeeds && c.at->closing == net::no_fault) {
      fuzz::must(c.answers.contains(one->call));
      fuzz::must(c.answers[one->call] == *succeeds);
    }
    if (is_heard && was_idle && !may) unasked_in_idle();
  }

  // ---- what must hold ----

  // By a client that does not command: what it may, and what the door does to end what was held.
  void unasked_in_idle() {
    const auto asked = controls.asked();
    for (std::size_t i = before; i < asked.size(); ++i)
      fuzz::must((asked[i].about == about::end_run && stops) || is_end_of_effect(asked[i]));
  }
  static bool is_end_of_effect(const cca::detail::door_request& one) {
    return one.about == about::release ||
           (one.about == about::set && one.values.size() == 1 && one.values[0].first == node + ".signal" &&
            one.values[0].second.text == "off");
  }
  void read(Client& c) {
    const bool has_shown = c.has_shown;
    fuzz::read_frames(*c.at, [&](int kind, std::string_view payload) {
      if (!has_shown) fuzz::must(payload.find(token) == payload.npos || !guards_reading);
      if (kind == 1) {
        const auto is = [&](const char* op) {
          return payload.find("\"op\":\"" + std::string(op) + '"') != payload.npos;
        };
        if (guards_reading && !has_shown) fuzz::must(is("serverInfo") || is("status") || is("cca.rights"));
        if (is("cca.rights") && !is("status")) c.rights = net::json::parse(payload);
      } else if (kind == 2) {
        fuzz::must(!guards_reading || has_shown);
        if (payload[0] != 3) return;
        std::uint32_t call;
        std::memcpy(&call, payload.data() + 5, 4);
        c.answers[call] = net::json::parse(payload.substr(17))["success"] == true;
      }
    });
    fuzz::must(!c.at->has_token || c.has_shown);
  }
  void look() {
    const auto asked = controls.asked();
    for (; seen < asked.size(); ++seen) {
      const auto& one = asked[seen];
      fuzz::must_be_within(one);
      fuzz::must(one.text.find("444") == std::string::npos && one.scope.find("444") == std::string::npos);
      fuzz::must(one.number != 444);
      for (const auto& [name, value] : one.values) {
        fuzz::must(value.number != 4.44 && value.number != 44.4 && value.number != 0.444);
        fuzz::must(std::find(value.numbers.begin(), value.numbers.end(), 4.44) == value.numbers.end());
        if (name != node + ".signal") continue;
        is_tested = value.text != "off";
        tested_until = std::numeric_limits<std::uint64_t>::max();  // by /cca/test it ends by itself
        for (const auto& [other, of] : one.values)
          if (other == node + ".duration")
            tested_until = run_time + static_cast<std::uint64_t>(1e9 * of.number);
      }
      if (one.about == about::end_run) is_pushed = is_tested = false;  // with the run all ends that was held
      if (one.about == about::call && one.text == "push") is_pushed = true;
      if (one.about == about::release && one.text == "push") is_pushed = false;
      // With a lost commander single beats end, and the speed is again one that it was.
      const bool is_of_door =
          is_end_of_effect(one) ||
          (one.about == of_lost() && ends_of_lost < lost && (++ends_of_lost, true)) ||
          (one.about == about::end_steps && ends_of_steps < lost && (++ends_of_steps, true)) ||
          (one.about == about::speed && speeds.contains(one.number) && ends_of_speed < lost + given &&
           (++ends_of_speed, true));
      if (is_of_door) continue;
      if (one.about == about::speed) speeds.insert(one.number);
      if (++taken[one.about] > allowed[one.about] && std::exchange(begun, false)) ++allowed[one.about];
      fuzz::must(taken[one.about] <= allowed[one.about]);
    }
    for (std::size_t who = 0; who < clients.size(); ++who) {
      if (!clients[who]) continue;
      Client& c = *clients[who];
      read(c);
      c.answers.clear();
      if (!c.rights || c.at->closing != net::no_fault) continue;
      fuzz::must((*c.rights)["mayChange"] == c.at->has_token);
      fuzz::must((*c.rights)["commands"] == (commands == who));
      fuzz::must((*c.rights)["commandedBy"].is_null() == !commands);
      if (commands) fuzz::must((*c.rights)["commandedBy"] == clients[*commands]->at->name);
    }
    is_mixed = is_mixed && door->is_busy();
    if (door->is_busy() || commands || has_refused) return;
    fuzz::must(!is_pushed);
    fuzz::must(!is_tested || run_time >= tested_until);
  }
  about of_lost() const {
    return settings.on_lost == cca::when_lost::hold   ? about::pause
           : settings.on_lost == cca::when_lost::stop ? about::end_run
                                                      : about::release;
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  several(data[0], {reinterpret_cast<const char*>(data) + 1, size - 1}).run();
  return 0;
}
