// Samples of spaces of each kind go both ways between a controller and a program that shares no code with
// cca: its types are made by Cyclone's idlc from what cca::idl writes.
#include <doctest/doctest.h>

#include <cstdio>
#include <string>

#include "spaces.hpp"

using namespace talk;

namespace {

template <class Space>
std::string expected() {
  const auto all = told<Space>();
  std::string text = "its space, fresh |";
  for (int i = 0; i < Space::size && i < 8; ++i) {
    char digits[32];
    std::snprintf(digits, sizeof digits, " %g", all[i]);
    text += digits;
  }
  return text + " | " + std::to_string(all.sum()) + "\n";
}

template <class Space>
void is_heard(const char* type) {
  CAPTURE(type);
  auto other = peer("hear", type);
  cca::controller<talker<Space>> c;
  c.template get<"tell">().p.domain = domain();
  c.load();
  c.start();
  int beat = 0;
  within_seconds(30, [&] {
    if (++beat % 10 == 0) c.step();
    return other.has_said();
  });
  CHECK_EQ(other.said, expected<Space>());
  CHECK_GT(c.template get<"tell">().sent(), 0);
}

template <class Space>
void hears(const char* type) {
  CAPTURE(type);
  const auto other = peer("tell", type);
  cca::controller<listener<Space>> c;
  c.template get<"heard">().p.domain = domain();
  c.load();
  c.start();
  const auto& here = c.template get<"here">();
  CHECK(within_seconds(30, [&] {
    c.step();
    return here.count > 0 && here.last == told<Space>();
  }));
  CHECK_EQ(here.age, 250'000'000);  // as the sender says
  CHECK_EQ(c.template get<"heard">().refused(), 0);
  CHECK_GT(c.template get<"heard">().received(), 0);
}

// Why it refuses what does not fit.
template <class Space>
std::string refusal(const char* type, const char* how) {
  const auto other = peer("tell", type, how);
  cca::controller<listener<Space>> c;
  c.template get<"heard">().p.domain = domain();
  c.load();
  c.start();
  const auto& heard = c.template get<"heard">();
  CHECK(within_seconds(30, [&] {
    c.step();
    return heard.refused() > 1;
  }));
  CHECK_EQ(heard.received(), 0);
  CHECK_EQ(c.template get<"here">().count, 0);
  const std::string line = heard.summary();  // as programs print it after a run
  CHECK(line.ends_with(" messages refused, the newest: " + std::string(heard.why_refused())));
  return std::string(heard.why_refused());
}

// What the program of docs/dds.md watches and commands.
struct of_page : cca::graph<cca::rate<1000>,
                            cca::node<"leg", speaker<leg_angles>>,
                            cca::node<"tell", cca::dds::publisher<leg_angles>>,
                            cca::node<"heard", cca::dds::subscriber<leg_angles, "cca/said">>,
                            cca::node<"here", recorder<leg_angles>>,
                            cca::wire<"leg.value", "tell.sample">,
                            cca::wire<"heard.sample", "here.value">> {};

}  // namespace

TEST_SUITE("spaces and other programs") {
  TEST_CASE("a program made of their IDL hears what is published") {
    is_heard<leg_angles>("leg_angles");
    is_heard<leg_torques>("leg_torques");
    is_heard<any>("any");
    is_heard<pads>("pads");
    is_heard<trunk_pose>("trunk_pose");
    is_heard<paws>("paws");
    is_heard<mood>("mood");
    is_heard<picture>("picture");
  }
  TEST_CASE("what a program made of their IDL sends is heard, with its age") {
    hears<leg_angles>("leg_angles");
    hears<leg_torques>("leg_torques");
    hears<any>("any");
    hears<pads>("pads");
    hears<trunk_pose>("trunk_pose");
    hears<paws>("paws");
    hears<mood>("mood");
    hears<picture>("picture");
  }
  TEST_CASE("the program of the page hears the leg, and commands it") {
    peer_process other({CCA_PAGE_PROGRAM, std::to_string(domain())});
    cca::controller<of_page> c;
    c.get<"tell">().p.domain = domain();
    c.get<"heard">().p.domain = domain();
    c.load();
    c.start();
    const auto& here = c.get<"here">();
    CHECK(within_seconds(30, [&] {
      c.step();
      return other.has_said() && here.count > 0;
    }));
    CHECK(other.said.starts_with("hip 1.00, knee 1.50, "));
    CHECK_EQ(here.last[1], -0.5);
    CHECK_LE(std::abs(here.last[0]), 0.25);
    CHECK_EQ(c.get<"heard">().summary(), "");
  }
  TEST_CASE("what does not fit is refused and counted, and changes nothing") {
    CHECK_EQ(refusal<leg_angles>("leg_angles", "other_space"), "a sample of another space");
    CHECK_EQ(refusal<leg_angles>("leg_angles", "future"), "an age that can't be");
    CHECK_EQ(refusal<leg_angles>("leg_angles", "nan"), "a number that is not finite");
    CHECK_EQ(refusal<trunk_pose>("trunk_pose", "turned"), "an orientation that is no unit quaternion");
    CHECK_EQ(refusal<paws>("paws", "turned"), "an orientation that is no unit quaternion");
    CHECK_EQ(refusal<mood>("mood", "half"), "a status that is no whole number");
  }
}
