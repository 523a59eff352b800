// The states of a training: which change is legal in which state, which examples it keeps, what it refuses.
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

#include <cca/adaptive/locally_weighted_regression.hpp>
#include <cca/adaptive/training.hpp>
#include <cca/motor/dmp_shapes.hpp>

#include "rig.hpp"

using namespace adaptive_test;
using enum cca::learning;

namespace {

using rule = cca::locally_weighted_regression<cca::rhythmic_shape<leg, 5>>;
using side = cca::training<rule, 10>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();
const rule::settings settings;

void teach(side& s, int count) {
  for (int i = 0; i < count; ++i) s.teach({0.3 * i, 1.0}, {1.0 * i, -1.0}, settings);
}
rule::learned known() {
  rule::learned one;
  rule::step(one, {0.5, 1.0}, {1, 2}, settings);
  return one;
}

// A training in the given state, with examples, and with a learned value if asked for.
side in_state(cca::learning state, bool learned = false) {
  side s;
  if (learned) s.hand_over(known());
  s.collect();
  teach(s, 3);
  if (state == collecting) return s;
  s.rest();
  if (state == online) s.learn();
  if (state == batch) (void)s.begin_batch(settings);
  if (state == trained && !learned) s.hand_over(known());
  return s;
}

constexpr std::array states{idle, collecting, online, batch, trained};
using legal_in = std::set<cca::learning>;

template <class F>
void check_change(F call, const legal_in& legal, cca::learning to) {
  for (const auto state : states) {
    auto s = in_state(state);
    REQUIRE(s.state() == state);
    const auto words = words_of([&] { call(s); });
    CAPTURE(to_string(state));
    CHECK_EQ(words.empty(), legal.contains(state));
    CHECK(s.state() == (legal.contains(state) ? to : state));
    if (!words.empty())
      CHECK(words.find("is refused while it is `" + std::string(to_string(state)) + "`") != words.npos);
  }
}

}  // namespace

TEST_CASE("each change of a training is legal in its states and refused in the others") {
  check_change([](side& s) { s.collect(); }, {idle, trained}, collecting);
  check_change([](side& s) { s.learn(); }, {idle, trained}, online);
  check_change([](side& s) { (void)s.begin_batch(settings); }, {idle, collecting, trained}, batch);
  check_change([](side& s) { s.hand_over(known()); }, {idle, batch, trained}, trained);
  check_change([](side& s) { s.rest(); }, {collecting, online, batch}, idle);  // nothing was learned
  check_change([](side& s) { s.forget(); }, {idle, trained}, idle);
  for (const auto state : {collecting, online, batch}) {
    auto s = in_state(state, true);
    s.rest();
    CHECK(s.state() == trained);
  }
}

TEST_CASE("it learns only on request, only from finite examples, and keeps the newest") {
  for (const auto state : {idle, batch, trained}) {
    auto s = in_state(state);
    const auto before = s.get().function.weights;
    teach(s, 2);
    CHECK_EQ(s.example_count(), 3);
    CHECK_EQ(s.get().function.weights, before);
  }
  auto s = in_state(collecting);
  s.teach({none, 1}, {0, 0}, settings);
  s.teach({0, 1}, {none, 0}, settings);
  CHECK_EQ(s.example_count(), 3);
  teach(s, 9);
  CHECK_EQ(s.example_count(), 10);
  const auto all = s.examples();
  REQUIRE_EQ(all.size(), 10);
  CHECK_EQ(all[0].y[0], 2);  // two of the first three are dropped
  CHECK_EQ(all[1].y[0], 0);
  CHECK_EQ(all[9].y[0], 8);
  auto o = in_state(online);
  o.teach({none, 1}, {0, 0}, settings);
  o.teach({0, 1}, {0, none}, settings);
  CHECK(o.get().function.weights == rule::learned().function.weights);
  CHECK(o.get().seen == rule::learned().seen);
  teach(o, 1);
  CHECK(o.get().seen != rule::learned().seen);
  CHECK_EQ(o.example_count(), 3);
  o.rest();
  CHECK(o.state() == trained);  // now it has a learned value
}

TEST_CASE("before learning and after forgetting everything is outside the trained region") {
  const rule::settings easy(1.0, 0.0);  // settings under which every input counts as inside
  side s;
  CHECK(s.region({0, 1}, easy) == cca::trained_region::outside);
  CHECK_EQ(words_of([&] {
             (void)s.begin_batch(settings);
           }).find("cca::training: begin_batch() is refused: no examples"),
           0);
  CHECK(s.state() == idle);
  s = in_state(trained);
  CHECK(s.region({0, 1}, easy) == cca::trained_region::inside);
  CHECK(s.get().function.weights == known().function.weights);
  s.forget();
  CHECK(s.region({0, 1}, easy) == cca::trained_region::outside);
  CHECK_EQ(s.example_count(), 0);
  CHECK(s.get().function.weights == rule::learned().function.weights);
}

TEST_CASE("an input that is not finite is outside of the trained region, whatever the settings") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double with_payload = std::bit_cast<double>(std::bit_cast<std::uint64_t>(none) + 1);
  const rule::settings easy(1.0, 0.0);
  const side s = in_state(trained);
  REQUIRE(s.region({0, 1}, easy) == cca::trained_region::inside);
  for (const double broken : {none, -none, with_payload, infinite, -infinite}) {
    CAPTURE(broken);
    CHECK(s.region({broken, 1}, easy) == cca::trained_region::outside);
    CHECK(s.region({0, broken}, easy) == cca::trained_region::outside);
  }
}

TEST_CASE("a value that is not finite is not saved, and nothing is loaded during learning") {
  const temporary file("training");
  auto s = in_state(trained);
  s.save(file.path);
  auto broken = known();
  broken.function.weights(0, 0) = none;
  auto lost = in_state(trained);
  lost.hand_over(broken);
  const auto text = file.text();
  CHECK(words_of([&] { lost.save(file.path); }).find("not written: function.weights") != std::string::npos);
  CHECK_EQ(file.text(), text);
  for (const auto state : states) {
    auto other = in_state(state);
    const auto words = words_of([&] { other.load(file.path); });
    CHECK_EQ(words.empty(), state == idle || state == batch || state == trained);
    if (words.empty()) CHECK(other.state() == trained);
    else CHECK(other.state() == state);
    if (!words.empty()) CHECK_EQ(words.find("cca::training: load() is refused while it is `"), 0);
  }
}
