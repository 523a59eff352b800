// The laws of a Learner, stated once and run for every learner.
//
// A case has `Case::learner`; `Case::input(source)`, a random input of its trained region; `Case::truth(x)`,
// the function to learn (or, instead of both, `Case::sequence(count, seed)`: examples in an order);
// `Case::far()`, an input far from the region; `Case::left`, the largest fraction of the error that may
// remain. `laws::allocations()` counts calls of malloc; the test program defines it.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <cca/adaptive/training.hpp>

#include "ode_laws.hpp"

namespace laws {

template <class Case>
using example_of = cca::example<typename Case::learner::model>;

template <class Case>
std::vector<example_of<Case>> scattered_examples(int count, std::uint64_t seed) {
  ode_source random{std::mt19937_64{seed}};
  std::vector<example_of<Case>> all;
  for (int i = 0; i < count; ++i) {
    const typename Case::learner::model::input x = Case::input(random);
    all.push_back({x, Case::truth(x)});
  }
  return all;
}

template <class Case>
std::vector<example_of<Case>> examples(int count, std::uint64_t seed) {
  if constexpr (requires { Case::sequence(count, seed); }) {
    return Case::sequence(count, seed);
  } else {
    return scattered_examples<Case>(count, seed);
  }
}

template <class Case>
double rms_error(const typename Case::learner::learned& known) {
  double sum = 0;
  const auto fresh = examples<Case>(500, 99);
  for (const auto& one : fresh)
    sum += (Case::learner::model::answer(known.function, one.x) - one.y).squaredNorm();
  return std::sqrt(sum / 500);
}

template <class Case>
std::string as_text(const typename Case::learner::learned& known) {
  return cca::detail::learned_text(
      {std::string(Case::learner::model::title()), std::string(Case::learner::name)},
      cca::detail::schema_of<typename Case::learner::learned>, &known);
}

// The error on unseen inputs falls to the fraction of the case; everything stays finite; the same examples
// give the same result.
template <class Case>
void learns_in_batch() {
  using learner = typename Case::learner;
  const auto all = examples<Case>(1000, 1);
  const auto known = std::make_unique<typename learner::learned>(learner::batch(all, {}));
  const auto nothing = std::make_unique<typename learner::learned>();
  const double before = rms_error<Case>(*nothing), left = rms_error<Case>(*known);
  CHECK_MESSAGE(left < Case::left * before, "error in batch: " << before << " before, " << left << " left");
  CHECK_MESSAGE(as_text<Case>(learner::batch(all, {})) == as_text<Case>(*known),
                "the same examples give the same result, bit for bit");
}

// Online the error falls from each decade of examples to the next, or stays within 1 % at its floor.
template <class Case>
void learns_online() {
  using learner = typename Case::learner;
  const auto all = examples<Case>(1000, 2);
  const auto known = std::make_unique<typename learner::learned>();
  const double before = rms_error<Case>(*known);
  double last = before;
  for (std::size_t i = 0; i < all.size(); ++i) {
    learner::step(*known, all[i].x, all[i].y, {});
    if (i != 99 && i != 999) continue;
    const double now = rms_error<Case>(*known);
    CHECK_MESSAGE(now <= last + 0.01 * before,
                  "after " << i + 1 << " examples: " << now << ", before: " << last);
    last = now;
  }
  CHECK_MESSAGE(last < Case::left * before, "error online: " << before << " before, " << last << " left");
}

// Saving and loading gives the same text, and the same answers bit for bit.
template <class Case>
void keeps() {
  using learner = typename Case::learner;
  const auto known = std::make_unique<typename learner::learned>(learner::batch(examples<Case>(300, 3), {}));
  const auto again = std::make_unique<typename learner::learned>();
  const auto text = as_text<Case>(*known);
  cca::detail::read_learned(text, "text", {std::string(learner::model::title()), std::string(learner::name)},
                            cca::detail::schema_of<typename learner::learned>, again.get());
  CHECK_MESSAGE(as_text<Case>(*again) == text, "written again with the same text");
  for (const auto& one : examples<Case>(50, 4))
    CHECK_MESSAGE(
        learner::model::answer(known->function, one.x) == learner::model::answer(again->function, one.x),
        "the same answers");
}

// Its status is right, and nothing in a beat allocates.
template <class Case>
void tells() {
  using learner = typename Case::learner;
  const typename learner::settings s;
  const auto side = std::make_unique<cca::training<learner, 200>>();
  const auto all = examples<Case>(300, 5);
  CHECK(side->state() == cca::learning::idle);
  CHECK_MESSAGE(side->region(all[0].x, s) == cca::trained_region::outside, "outside at first");
  side->teach(all[0].x, all[0].y, s);
  CHECK_MESSAGE(side->example_count() == 0, "idle, it keeps no examples");
  side->collect();
  CHECK(side->state() == cca::learning::collecting);
  std::size_t before = allocations();
  for (const auto& one : all) side->teach(one.x, one.y, s);
  auto broken = all[0];
  broken.y[0] = std::numeric_limits<double>::quiet_NaN();
  side->teach(broken.x, broken.y, s);
  CHECK_MESSAGE(allocations() == before, "collecting does not allocate");
  CHECK_MESSAGE(side->example_count() == 200, "it keeps the newest examples");
  CHECK_MESSAGE(side->examples().front().x == all[100].x, "it keeps their order");
  CHECK_MESSAGE(side->examples().back().x == all[299].x, "examples that are not finite are ignored");
  const auto work = side->begin_batch(s);
  CHECK(side->state() == cca::learning::batch);
  const auto known = std::make_unique<typename learner::learned>(work());
  side->hand_over(*known);
  CHECK(side->state() == cca::learning::trained);
  int outside = 0;
  typename learner::model::output sum = learner::model::output::Zero();
  before = allocations();
  for (std::size_t i = 100; i < all.size(); ++i) {
    outside += side->region(all[i].x, s) == cca::trained_region::outside;
    sum += side->answer(all[i].x);
  }
  CHECK_MESSAGE(allocations() == before, "an answer does not allocate");
  CHECK_MESSAGE(outside == 0, "inside the trained region: " << outside << " of 200 are not");
  CHECK_MESSAGE(sum.allFinite(), "finite");
  CHECK_MESSAGE(side->region(Case::far(), s) == cca::trained_region::outside, "outside far from the region");
  if constexpr (cca::OnlineLearner<learner>) {
    side->learn();
    CHECK(side->state() == cca::learning::online);
    before = allocations();
    for (const auto& one : all) side->teach(one.x, one.y, s);
    side->teach(broken.x, broken.y, s);
    CHECK_MESSAGE(allocations() == before, "a step does not allocate");
    CHECK_MESSAGE(side->answer(all[0].x).allFinite(), "examples that are not finite are ignored");
    side->rest();
    CHECK(side->state() == cca::learning::trained);
  }
  side->forget();
  CHECK(side->state() == cca::learning::idle);
  CHECK_MESSAGE(side->region(all[200].x, s) == cca::trained_region::outside,
                "after forgetting all is outside");
  const auto fresh = std::make_unique<cca::training<learner, 200>>();
  CHECK_MESSAGE(side->answer(all[200].x) == fresh->answer(all[200].x),
                "after forgetting it answers like a new one");
  CHECK_MESSAGE(side->example_count() == 0, "after forgetting it has no examples");
  side->collect();
  side->rest();
  CHECK_MESSAGE(side->state() == cca::learning::idle, "nothing was learned");
}

template <class Case>
void learner() {
  static_assert(cca::Learner<typename Case::learner>);
  law("states what it does", tells<Case>);
  law("keeps what it learned", keeps<Case>);
  law("learns in a batch", learns_in_batch<Case>);
  if constexpr (cca::OnlineLearner<typename Case::learner>) law("learns online", learns_online<Case>);
}

}  // namespace laws
