// Programs that send what can't be, under the right names: they are refused, named and counted.
#include <doctest/doctest.h>

#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <thread>

#include "../../laws/transport_laws.hpp"
#include "over_dds.hpp"

using namespace deployment_test;
using namespace std::chrono_literals;
using namespace cca::dds::detail;

namespace {

constexpr std::int64_t calls = cca::detail::exchange<two>::calls_and_one;
const std::string sample_type = "cca::sample_" + deployment_facts::as_text(cca::schema_of<level>.hash());

std::string status_type() {
  return "cca::status_" + deployment_facts::as_text(cca::detail::hash(cca::detail::manifest_of<two>()));
}

// What `mind` says of itself: that it takes part in run 1, and is far ahead.
status good_status(std::uint64_t robot) {
  status s(2, 1);
  s[status::arrived] = s[status::ready] = 1;
  s[status::begun] = -1;
  s[status::fault_position] = s[status::stop_at] = s[status::length] = no_position;
  s[status::fault_node] = -1;
  s[status::position] = 50000 * calls;
  s.accepted[0] = robot;
  return s;
}

words sample_of(std::int64_t number, std::int64_t beat, double value) {
  return {static_cast<std::uint64_t>(number), static_cast<std::uint64_t>(beat), 0,
          std::bit_cast<std::uint64_t>(value)};
}

struct lie {
  std::function<void(const participant&, channel_writer& samples)> about_samples = [](auto&, auto&) {};
  std::function<void(status&)> about_status = [](status&) {};
};

// Claims `mind`, and takes part in a run. After a while it lies once.
std::string play_mind(const std::string& name, const lie& told) {
  const participant in(over_dds::number(), name);
  presence known(in, 2, cca::detail::manifest_of<two>());
  refusals unused;
  known.settle();
  const channel_writer statuses(in, "cca/mind/status", status_type(), status::size(2, 1), 1);
  channel_writer samples(in, "cca/slow/y", sample_type, 4, 32);
  const auto begin = std::chrono::steady_clock::now();
  bool has_lied = false;
  for (auto time = 0ms; time < 2400ms; time = std::chrono::duration_cast<std::chrono::milliseconds>(
                                           std::chrono::steady_clock::now() - begin)) {
    known.look(unused, [](int) { return std::string_view("mind"); });
    if (!known.peers().empty()) {
      status s = good_status(known.peers()[0].id.token);
      if (time > 1900ms) s[status::finished] = 1;
      if (time > 800ms && !has_lied) {
        has_lied = true;
        told.about_samples(in, samples);
        told.about_status(s);
      }
      words message;
      s.write_to(message);
      statuses.write(message);
    }
    std::this_thread::sleep_for(20ms);
  }
  return {};
}

// What the robot's process says after a run with this mind.
std::string robot_beside(const lie& told) {
  const std::string name = over_dds::other_name();
  process mind([&] { return play_mind(name, told); });
  process robot([&] {
    const auto net = over_dds::transport(name);
    cca::deployed<two> d(cca::only{"robot"}, net);
    d.load();
    d.start();
    d.run(cca::for_<1.5>{}, cca::at_wall_clock());
    std::string all = transport_laws::state_of(d) + "not finite " + std::to_string(net.not_finite());
    for (const auto& one : net.refusals())
      all += "; refused " + one.who + ": " + one.why + " " + std::to_string(one.count);
    return all;
  });
  const std::string said = robot.said();
  mind.kill();
  return said;
}

// The same program in another version.
std::string manifest_of_other_version() {
  const std::string own = cca::detail::manifest_of<two>();
  return "cca 9.8.7" + own.substr(own.find('\n'));
}
std::string versions() {
  const std::string own = cca::detail::manifest_of<two>();
  return "the other process runs another deployment; here `" + own.substr(0, own.find('\n')) +
         "`, there `cca 9.8.7`";
}
// Says that it runs `mind` in another version. `settles_at_once`: it is there first.
std::string play_other_version(const std::string& name, bool settles_at_once) {
  const participant in(over_dds::number(), name);
  presence known(in, 2, manifest_of_other_version());
  refusals unused;
  if (settles_at_once) known.settle();
  for (int i = 0; i < 300; ++i) {
    known.look(unused, [](int) { return std::string_view("mind"); });
    std::this_thread::sleep_for(10ms);
  }
  return {};
}

bool is_refused(const std::string& said, const std::string& why) {
  return said.find("faulted lost contact with `mind`") != std::string::npos &&
         said.find("; refused process ") != std::string::npos && said.find(why + " 1") != std::string::npos;
}

}  // namespace

TEST_SUITE("liars over dds") {
  TEST_CASE("who takes part and tells the truth is heard, and NaN passes and is counted") {
    const std::string said = robot_beside({.about_samples = [](auto&, auto& samples) {
      samples.write(sample_of(0, 700, 1));
      samples.write(sample_of(1, 701, std::numeric_limits<double>::quiet_NaN()));
    }});
    CAPTURE(said);
    CHECK(said.starts_with("1500 started "));
    CHECK(said.ends_with("not finite 1"));
  }

  TEST_CASE("a sample of another length, number or beat ends the contact") {
    const auto longer = robot_beside({.about_samples = [](const participant& in, auto&) {
      const channel_writer other(in, "cca/slow/y", sample_type, 40, 1);
      for (int i = 0; i < 20; ++i) {
        other.write(words(40, 1));
        std::this_thread::sleep_for(10ms);
      }
    }});
    CAPTURE(longer);
    CHECK(longer.find("faulted lost contact with `mind`") != std::string::npos);
    CHECK(longer.find("a sample of another length") != std::string::npos);

    const auto twice = robot_beside({.about_samples = [](auto&, auto& samples) {
      samples.write(sample_of(5, 700, 1));
      samples.write(sample_of(5, 701, 1));
    }});
    CAPTURE(twice);
    CHECK(is_refused(twice, "a number that does not follow"));

    for (const std::int64_t beat : {std::int64_t{-1}, std::int64_t{1} << 40, no_position}) {
      const auto absurd = robot_beside(
          {.about_samples = [&](auto&, auto& samples) { samples.write(sample_of(0, beat, 1)); }});
      CAPTURE(absurd);
      CHECK(is_refused(absurd, "a beat that can't be"));
    }
  }

  TEST_CASE("a shorter sample never arrives") {
    const auto said = robot_beside({.about_samples = [](const participant& in, auto&) {
      const channel_writer other(in, "cca/slow/y", sample_type, 2, 1);
      for (int i = 0; i < 5; ++i) {
        other.write(words(2, 1));
        std::this_thread::sleep_for(10ms);
      }
    }});
    CAPTURE(said);
    CHECK(said.starts_with("1500 started "));
  }

  TEST_CASE("a status that can't be ends the contact") {
    const auto absurd =
        robot_beside({.about_status = [](status& s) { s[status::position] = no_position - 1; }});
    CAPTURE(absurd);
    CHECK(is_refused(absurd, "a beat that can't be"));
    const auto text = robot_beside({.about_status = [](status& s) { s.reason.fill(~std::uint64_t{0}); }});
    CAPTURE(text);
    CHECK(is_refused(text, "a reason that is no text"));
  }

  TEST_CASE("a process of another version is refused, both versions are named") {
    const std::string name = over_dds::other_name();
    process other([&] { return play_other_version(name, true); });
    std::this_thread::sleep_for(300ms);
    process robot([&] {
      cca::deployed<two> d(cca::only{"robot"}, over_dds::transport(name));
      return std::string("it may run");
    });
    const std::string said = robot.said();
    CAPTURE(said);
    CHECK(said.starts_with("refused: cca::dds: " + versions() + ": process "));
    other.kill();
  }

  TEST_CASE("who was there first stays, and tells whom it refused") {
    const std::string name = over_dds::other_name();
    process robot([&] {
      const auto net = over_dds::transport(name);
      cca::deployed<two> d(cca::only{"robot"}, net);
      for (int i = 0; i < 2000 && net.refusals().empty(); ++i) std::this_thread::sleep_for(10ms);
      return net.refusals().empty() ? "it met nobody" : net.refusals()[0].why;
    });
    std::this_thread::sleep_for(700ms);
    process other([&] { return play_other_version(name, false); });
    CHECK_EQ(robot.said(), versions());
    other.kill();
  }

  TEST_CASE("a stranger with the right names changes nothing") {
    const std::string name = over_dds::other_name();
    process stranger([&] {
      const participant in(over_dds::number(), name);
      const channel_writer statuses(in, "cca/mind/status", status_type(), status::size(2, 1), 1);
      const channel_writer samples(in, "cca/slow/y", sample_type, 4, 32);
      for (int i = 0; i < 2000; ++i) {
        samples.write(sample_of(i, i, 1e6));
        words message;
        good_status(static_cast<std::uint64_t>(i)).write_to(message);
        statuses.write(message);
        std::this_thread::sleep_for(1ms);
      }
      return std::string();
    });
    process mind([&] {
      cca::deployed<two> d(cca::only{"mind"}, over_dds::transport(name));
      d.load();
      d.start();
      d.run(cca::for_beats<4000>{});
      return std::string();
    });
    process robot([&] {
      const auto net = over_dds::transport(name);
      cca::deployed<two> d(cca::only{"robot"}, net);
      d.load();
      d.start();
      d.run(cca::for_beats<4000>{});
      return transport_laws::robot_of(d) +
             (net.refused_messages() > 0 ? "refused " + net.refusals()[0].why : "");
    });
    cca::controller<architecture> c;
    c.load();
    c.start();
    c.run(cca::for_beats<4000>{});
    CHECK_EQ(robot.said(), transport_laws::robot_of(c) + "refused it does not run environment `mind`");
  }

  TEST_CASE("each number of a status is checked") {
    const bounds of{1'000'000, 8, 5};
    CHECK(good_status(1).complaint(of, -1).empty());
    const auto complaint = [&](auto change, std::int64_t newest = 0) {
      status s = good_status(1);
      s[status::position] = 8;
      change(s);
      return std::string(s.complaint(of, newest));
    };
    CHECK_EQ(complaint([](status&) {}), "");
    CHECK_EQ(complaint([](status& s) { s[status::flags] = status::is_paused; }), "");
    CHECK_EQ(complaint([](status& s) { s[status::flags] = 2 * status::is_paused; }),
             "flags that do not exist");
    CHECK_EQ(complaint([](status& s) { s[status::mode] = 1; }), "a mode that does not exist");
    CHECK_EQ(complaint([](status& s) { s[status::position] = -2; }), "a beat that can't be");
    CHECK_EQ(complaint([](status& s) { s[status::position] = 8 * 1'000'000; }), "a beat that can't be");
    CHECK_EQ(complaint([](status& s) { s[status::position] = 8 * 1'000'000; }, 999'000), "");
    CHECK_EQ(complaint([](status& s) { s[status::begun] = 1'000'000; }), "a beat that can't be");
    CHECK_EQ(complaint([](status& s) { s[status::interval] = no_position; }), "a time that can't be");
    CHECK_EQ(complaint([](status& s) { s[status::begun_age] = -1; }), "a time that can't be");
    CHECK_EQ(complaint([](status& s) { s[status::fault_position] = -2; }), "a fault that can't be");
    CHECK_EQ(complaint([](status& s) { s[status::fault_node] = 5; }), "a component that does not exist");
    CHECK_EQ(complaint([](status& s) { s[status::stop_at] = -1; }), "an end that can't be");
    CHECK_EQ(complaint([](status& s) { s[status::ready] = -1; }), "a run that can't be");
    CHECK_EQ(complaint([](status& s) { s[status::length] = -1; }), "a count below zero");
    CHECK_EQ(complaint([](status& s) { s.published[0] = -1; }), "a count below zero");
    CHECK_EQ(complaint([](status& s) { s.late[1] = -1; }), "a count below zero");
    CHECK_EQ(complaint([](status& s) { s.wishes = {4}; }), "");
    CHECK_EQ(complaint([](status& s) { s.wishes = {5}; }), "a wish that does not exist");
    CHECK_EQ(complaint([](status& s) { s.wishes = {-1}; }), "a wish that does not exist");
    words message;
    good_status(7).write_to(message);
    CHECK_EQ(message.size(), status::size(2, 1));
    status again(2, 1);
    again.read_from(message);
    CHECK_EQ(again.accepted[0], 7);
    CHECK_EQ(again[status::position], 50000 * calls);
  }
}
