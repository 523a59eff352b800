// What a file may hold, and that saving and loading keeps every bit.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "mock.hpp"

using config_test::controller;
using config_test::terrain;

namespace {

std::string refusal_of(controller& c, std::string_view text) { return c.refusal(text); }

// All numbers of a controller as bits, which tell -0.0 from 0.0.
std::vector<std::uint64_t> bits(const controller& c) {
  std::vector<std::uint64_t> all;
  const auto number = [&](double value) { all.push_back(std::bit_cast<std::uint64_t>(value)); };
  for (const auto* each : {&c.cpg, &c.ode}) {
    number(each->p.frequency);
    number(each->p.gain);
    number(each->p.links.strength);
    for (const double offset : each->p.links.offsets) number(offset);
  }
  const auto& p = c.pose.p;
  for (const double value : {double{p.hip}, double{p.load}, p.offset[0], p.offset[1], p.mixing(0, 0),
                             p.mixing(0, 1), p.mixing(1, 0), p.mixing(1, 1), double{p.patience},
                             double{p.legs[0].knee}, double{p.legs[1].knee}, double{p.duty}})
    number(value);
  all.push_back(std::bit_cast<std::uint32_t>(p.slack));
  for (const std::int64_t value : {std::int64_t{p.mode}, std::int64_t{p.retries}, std::int64_t{p.stiff},
                                   static_cast<std::int64_t>(p.ground), std::int64_t{p.legs[0].front},
                                   std::int64_t{p.legs[1].front}, p.seed})
    all.push_back(static_cast<std::uint64_t>(value));
  for (const char byte : p.label.view()) all.push_back(static_cast<unsigned char>(byte));
  return all;
}

class dice {
public:
  explicit dice(std::uint64_t seed) : engine(seed) {}
  std::uint64_t word() { return engine(); }
  std::size_t below(std::size_t n) { return engine() % n; }

  // Any bits of a finite number, including subnormal ones and signed zeros.
  double number() {
    static constexpr double corners[] = {0.0,
                                         -0.0,
                                         1.0,
                                         -1.0,
                                         5e-324,
                                         -5e-324,
                                         2.2250738585072014e-308,
                                         2.2250738585072011e-308,
                                         0.1,
                                         1e22,
                                         1e23,
                                         9007199254740993.0,
                                         std::numeric_limits<double>::max(),
                                         std::numeric_limits<double>::lowest(),
                                         std::numeric_limits<double>::epsilon()};
    if (below(4) == 0) return corners[below(std::size(corners))];
    double value;
    do value = std::bit_cast<double>(word());
    while (!std::isfinite(value));
    return value;
  }
  float single() {
    static constexpr float corners[] = {
        0.0f, -0.0f,      1e-45f, std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest(),
        0.1f, 16777216.0f};
    if (below(4) == 0) return corners[below(std::size(corners))];
    float value;
    do value = std::bit_cast<float>(static_cast<std::uint32_t>(word()));
    while (!std::isfinite(value));
    return value;
  }
  double within(double lower, double upper) {
    const double value = lower + (upper - lower) * static_cast<double>(word() >> 11) * 0x1p-53;
    return below(8) == 0 ? lower : below(8) == 0 ? upper : std::fmin(value, upper);
  }
  std::string text(std::size_t longest) {
    static constexpr std::string_view bytes[] = {"a",    "\"",       "\\",           "\n", "\t", "\r", "\x01",
                                                 "\x7f", "\xc3\xa4", "\xe2\x82\xac", "#",  "=",  " ",  "'"};
    std::string out;
    for (std::size_t i = below(longest); i > 0; --i) {
      const auto& next = bytes[below(std::size(bytes))];
      if (out.size() + next.size() <= longest) out += next;
    }
    return out;
  }

private:
  std::mt19937_64 engine;
};

void randomise(controller& c, dice& d) {
  for (auto* each : {&c.cpg, &c.ode}) {
    each->p = {d.number(), d.within(0.1, 5), {std::fmin(d.number(), 10.0), {d.number(), d.number()}}};
    if (each->p.frequency == each->p.gain) each->p.frequency += 1;
  }
  auto& p = c.pose.p;
  p.hip = d.within(-0.9, 0.9);
  p.load = d.number();
  p.offset = {d.number(), d.number()};
  p.mixing << d.number(), d.number(), d.number(), d.number();
  p.mode = static_cast<int>(d.below(4));
  p.retries = static_cast<std::uint8_t>(d.word());
  p.stiff = d.below(2) == 0;
  p.ground = static_cast<terrain>(d.below(3));
  REQUIRE(p.label.assign(d.text(8)));
  p.slack = d.single();
  p.patience = d.below(4) == 0 ? cca::infinity : std::fabs(d.number());
  for (auto& leg : p.legs) leg = {d.within(-1.8, 0), d.below(2) == 0};
  p.duty = d.within(0, 1);
  p.seed = static_cast<std::int64_t>(d.below(4) == 0 ? std::uint64_t{1} << 63 : d.word());
}

}  // namespace

TEST_SUITE("config accepted") {
  TEST_CASE("what a saved file looks like") {
    CHECK_EQ(controller{}.text(), R"([cpg]
frequency = 1.5
gain = 1.0  # 0.1 to 5

[cpg.links]
strength = 3.0
offsets = ["0 rad", "0.5 rad"]

[dmp.ode]
frequency = 1.5
gain = 1.0  # 0.1 to 5

[dmp.ode.links]
strength = 3.0
offsets = ["0 rad", "0.5 rad"]

[pose]
hip = "0.25 rad"  # -0.9 to 0.9 rad
load = "2 N m"
offset = [1.0, 2.0]
mixing = [[1.0, 0.0], [0.0, 1.0]]
mode = 1  # 0 to 3
retries = 3
stiff = true
ground = "slope"  # flat, slope or steps
label = "trot"
slack = 0.1
patience = 2.0  # at least 0
legs = [{knee = "-0.5 rad", front = true}, {knee = "-1 rad", front = false}]
duty = 0.5  # 0 to 1
seed = 7
)");
  }

  TEST_CASE("values without a key in the file do not change") {
    controller c;
    CHECK_EQ(refusal_of(c, ""), "");
    CHECK_EQ(bits(c), bits(controller{}));
    CHECK_EQ(refusal_of(c, "[dmp.ode.links]\nstrength = 4\n"), "");
    CHECK_EQ(c.ode.p.links.strength, 4.0);
    c.ode.p.links.strength = 3;
    CHECK_EQ(bits(c), bits(controller{}));
    CHECK_EQ(refusal_of(c, "[pose]\nlegs = [{}, {front = true}]\n[sum]\n"), "");
    CHECK_EQ(double{c.pose.p.legs[1].knee}, -1.0);
    CHECK(c.pose.p.legs[1].front);
  }

  TEST_CASE("spellings") {
    controller c;
    CHECK_EQ(refusal_of(c,
                        "cpg = {frequency = 2, gain = 1e0, links = {offsets = [\"90deg\", 0.5]}}\n"
                        "[pose]\nhip = \" +30  deg \"\nload = \"1500 mN m\"\nduty = \"25 %\"\npatience = "
                        "inf\nmixing = [[1, 2], [3, 4]]\n"
                        "ground = 'steps'\nlabel = \"\"\nslack = 3.4028235e38\n"),
             "");
    CHECK_EQ(c.cpg.p.frequency, 2.0);
    CHECK_EQ(double{c.cpg.p.links.offsets[0]}, 90 * cca::detail::degree);
    CHECK_EQ(double{c.cpg.p.links.offsets[1]}, 0.5);
    CHECK_EQ(double{c.pose.p.hip}, 30 * cca::detail::degree);
    CHECK_EQ(double{c.pose.p.load}, 1.5);
    CHECK_EQ(double{c.pose.p.duty}, 0.25);
    CHECK_EQ(double{c.pose.p.patience}, cca::infinity);
    CHECK_EQ(c.pose.p.mixing(0, 1), 2.0);
    CHECK_EQ(c.pose.p.mixing(1, 0), 3.0);
    CHECK((c.pose.p.ground == terrain::steps));
    CHECK(c.pose.p.label.view().empty());
    CHECK_EQ(c.pose.p.slack, std::numeric_limits<float>::max());
  }

  TEST_CASE("saving and loading keeps every bit") {
    dice d(1);
    for (int i = 0; i < 2000; ++i) {
      controller written, read;
      randomise(written, d);
      const std::string text = written.text();
      CAPTURE(text);
      REQUIRE_EQ(refusal_of(read, text), "");
      REQUIRE_EQ(bits(read), bits(written));
      REQUIRE_EQ(read.text(), text);
    }
  }

  TEST_CASE("random bytes: a file is loaded as a whole or refused as a whole") {
    dice d(2);
    int loaded = 0;
    for (int i = 0; i < 3000; ++i) {
      controller written, c;
      randomise(written, d);
      std::string text = written.text();
      for (std::size_t k = d.below(4); k > 0; --k) {
        const std::size_t at = d.below(text.size());
        if (d.below(3) == 0) text.erase(at, d.below(20));
        else if (d.below(2) == 0) text.insert(at, text.substr(d.below(text.size()), d.below(20)));
        else text[at] = static_cast<char>(d.word());
        if (text.empty()) break;
      }
      CAPTURE(text);
      const auto before = bits(c);
      if (const std::string words = refusal_of(c, text); words.empty()) {
        ++loaded;
        controller again;
        REQUIRE_EQ(refusal_of(again, c.text()), "");
        REQUIRE_EQ(bits(again), bits(c));
      } else {
        REQUIRE(words.starts_with("trot.toml:"));
        REQUIRE_EQ(bits(c), before);
      }
    }
    CHECK(loaded > 300);
    CHECK(loaded < 2700);
  }

}  // TEST_SUITE
