// Baum and Welch against the sums over all sequences of states, written out; against the model that made the
// samples; and on movements that cross themselves.
#include <cca/motor/hidden_markov_learning.hpp>
#include <cca/motor/hmm_motion.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <vector>

#include "rig.hpp"

using namespace motor_test;

namespace {

struct line : cca::space<cca::number, cca::axes<cca::x>> {};
constexpr int K = 3;
using small = cca::hidden_markov_function<line, line, K>;
using rule = cca::baum_welch<small>;
using pair = cca::example<small>;
using vector = Eigen::VectorXd;
using matrix = Eigen::MatrixXd;

// ---- the same, written out ----

struct chain {
  vector prior{K};
  matrix passage{K, K};
  std::vector<vector> mean{K};
  std::vector<matrix> covariance{K};
};
using sequence = std::vector<vector>;  // of points

double density(const vector& off, const matrix& S) {
  return std::exp(-0.5 * off.dot(S.inverse() * off)) / std::sqrt((2 * cca::pi * S).determinant());
}

// f(states, probability of these states and of what was seen), for all sequences of states.
template <class F>
void each_path(const chain& c, const sequence& seen, F f) {
  std::vector<int> states(seen.size(), 0);
  for (;;) {
    double p = c.prior[states[0]];
    for (std::size_t t = 0; t < seen.size(); ++t) {
      const auto k = static_cast<std::size_t>(states[t]);
      p *= density(seen[t] - c.mean[k], c.covariance[k]);
      if (t > 0) p *= c.passage(states[t - 1], states[t]);
    }
    f(states, p);
    std::size_t t = 0;
    while (t < seen.size() && ++states[t] == K) states[t++] = 0;
    if (t == seen.size()) return;
  }
}

double log_likelihood(const chain& c, const std::vector<sequence>& all) {
  double sum = 0;
  for (const auto& seen : all) {
    double p = 0;
    each_path(c, seen, [&](const auto&, double one_path) { p += one_path; });
    sum += std::log(p);
  }
  return sum;
}

struct expected {
  std::vector<matrix> state;  // of each sequence: K rows, a column for each point
  vector begin = vector::Zero(K);
  matrix passage = matrix::Zero(K, K);
};
expected expectation(const chain& c, const std::vector<sequence>& all) {
  expected e;
  for (const auto& seen : all) {
    double p = 0;
    matrix state = matrix::Zero(K, static_cast<Eigen::Index>(seen.size())), passage = matrix::Zero(K, K);
    each_path(c, seen, [&](const std::vector<int>& states, double path) {
      p += path;
      for (std::size_t t = 0; t < states.size(); ++t) {
        state(states[t], static_cast<Eigen::Index>(t)) += path;
        if (t > 0) passage(states[t - 1], states[t]) += path;
      }
    });
    e.state.push_back(state / p);
    e.begin += state.col(0) / p;
    e.passage += passage / p;
  }
  return e;
}

chain maximised(const expected& e, const std::vector<sequence>& all, double floor) {
  chain c;
  c.prior = e.begin / e.begin.sum();
  for (int k = 0; k < K; ++k) {
    c.passage.row(k) = e.passage.row(k) / e.passage.row(k).sum();
    double n = 0;
    vector sum = vector::Zero(2);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t t = 0; t < all[i].size(); ++t) {
        const double share = e.state[i](k, static_cast<Eigen::Index>(t));
        n += share;
        sum += share * all[i][t];
      }
    const vector mean = sum / n;
    matrix S = matrix::Zero(2, 2);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t t = 0; t < all[i].size(); ++t)
        S +=
            e.state[i](k, static_cast<Eigen::Index>(t)) * (all[i][t] - mean) * (all[i][t] - mean).transpose();
    c.mean[static_cast<std::size_t>(k)] = mean;
    c.covariance[static_cast<std::size_t>(k)] = S / n + floor * matrix::Identity(2, 2);
  }
  return c;
}

// Each sequence in parts of equal length.
expected guess(const std::vector<sequence>& all, double unseen) {
  expected e;
  for (const auto& seen : all) {
    matrix state = matrix::Zero(K, static_cast<Eigen::Index>(seen.size()));
    const auto part = [&](std::size_t t) { return static_cast<Eigen::Index>(K * t / seen.size()); };
    for (std::size_t t = 0; t < seen.size(); ++t) {
      state(part(t), static_cast<Eigen::Index>(t)) = 1;
      if (t > 0) e.passage(part(t - 1), part(t)) += 1;
    }
    e.state.push_back(state);
  }
  e.begin = static_cast<double>(all.size()) * (Eigen::Vector3d(1, 0, 0).array() + unseen);
  for (int k = 0; k < K; ++k) e.passage.row(k).array() += unseen * std::max(1.0, e.passage.row(k).sum());
  return e;
}

std::vector<sequence> random_sequences(std::uint64_t seed, std::initializer_list<int> lengths) {
  laws::ode_source random{std::mt19937_64{seed}};
  std::vector<sequence> all;
  for (const int length : lengths) {
    all.emplace_back();
    for (int t = 0; t < length; ++t)
      all.back().push_back(Eigen::Vector2d(0.4 * t + random(-1, 1), std::sin(1.0 * t) + random(-0.5, 0.5)));
  }
  return all;
}
std::vector<pair> as_examples(const std::vector<sequence>& all) {
  std::vector<pair> examples;
  for (const auto& seen : all)
    for (std::size_t t = 0; t < seen.size(); ++t)
      examples.push_back({small::input(seen[t][0]), small::output(seen[t][1]), t == 0});
  return examples;
}

// Of a known chain of three states, by chance.
chain made_by() {
  chain c;
  c.prior << 0.7, 0.2, 0.1;
  c.passage << 0.90, 0.08, 0.02, 0.05, 0.85, 0.10, 0.20, 0.05, 0.75;
  c.mean = {Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 1), Eigen::Vector2d(-1, 4)};
  const Eigen::Matrix2d round = 0.25 * Eigen::Matrix2d::Identity();
  c.covariance = {round, round, round};
  c.covariance[1] << 0.5, 0.2, 0.2, 0.3;
  return c;
}
std::vector<pair> drawn(std::uint64_t seed, int sequences, int length) {
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal;
  const chain c = made_by();
  std::vector<pair> all;
  for (int i = 0; i < sequences; ++i) {
    const auto choose = [&](const auto& chances) {
      return std::discrete_distribution<int>({chances[0], chances[1], chances[2]})(bits);
    };
    int k = choose(c.prior);
    for (int t = 0; t < length; ++t) {
      if (t > 0) k = choose(vector(c.passage.row(k)));
      const matrix root = Eigen::LLT<matrix>(c.covariance[static_cast<std::size_t>(k)]).matrixL();
      const vector z =
          c.mean[static_cast<std::size_t>(k)] + root * Eigen::Vector2d(normal(bits), normal(bits));
      all.push_back({small::input(z[0]), small::output(z[1]), t == 0});
    }
  }
  return all;
}

// ---- a movement ----

using plane_rule = cca::baum_welch<cca::hidden_markov_function<plane, cca::velocity_of<plane>, 12>>;
using plane_motion = cca::hmm_motion<plane, 12>;

// A figure of eight, from its crossing and back to it.
Eigen::Vector2d eight(double s) { return {0.2 * std::sin(2 * cca::pi * s), 0.1 * std::sin(4 * cca::pi * s)}; }

}  // namespace

TEST_CASE("each step of Baum and Welch equals the sums over all sequences of states") {
  for (const double unseen : {0.0, 0.05}) {
    const auto all = random_sequences(unseen > 0 ? 3 : 4, {6, 5, 4});
    const auto examples = as_examples(all);
    expected e = guess(all, unseen);
    // A state that is never left keeps itself; the sums know no passage from it.
    if (unseen == 0) e.passage(K - 1, K - 1) = std::max(e.passage(K - 1, K - 1), 1e-300);
    double last = -1e300;
    for (int steps = 1; steps <= 6; ++steps) {
      const chain wanted = maximised(e, all, 1e-3);
      const auto known = rule::batch(examples, {1e-3, 0, steps, unseen});
      CAPTURE(steps);
      CHECK((known.function.mixture.priors - wanted.prior).norm() < 1e-10);
      CHECK((known.function.transitions - wanted.passage).norm() < 1e-10);
      for (std::size_t k = 0; k < K; ++k) {
        CHECK((known.function.mixture.means.col(static_cast<Eigen::Index>(k)) - wanted.mean[k]).norm() <
              1e-10);
        CHECK((known.function.mixture.covariances[k] - wanted.covariance[k]).norm() < 1e-10);
      }
      const double likelihood = log_likelihood(wanted, all) / static_cast<double>(examples.size());
      CHECK(known.likelihood == doctest::Approx(likelihood).epsilon(1e-10));
      CHECK(likelihood > last - 1e-6);
      last = likelihood;
      e = expectation(wanted, all);
    }
  }
}

TEST_CASE(
    "after 21 steps from the same beginning it is where pomegranate 0.14.8 is, which shares no code with "
    "it") {
  // By hidden_markov.py, with Debian's package.
  constexpr double likelihood = 8.959723917446528;
  Eigen::Matrix3d passages;
  passages << 0.942754298446769, 0.05724570155323106, 2.8844486652199624e-194, 0.06678585936566021,
      0.866488843150586, 0.06672529748375373, 2.9585192925044044e-187, 0.02018662302663215,
      0.9798133769733679;
  Eigen::Matrix<double, 2, 3> means;
  means << 0.8439458232146512, 0.2057786442216547, -0.7379304571651043, -0.44603685631499196,
      0.8223672329520105, -0.26117067166397906;
  std::array<Eigen::Matrix2d, 3> covariances;
  covariances[0] << 0.02247945807982402, -0.06034397774197686, -0.06034397774197686, 0.20928644487784487;
  covariances[1] << 0.05896146305080149, -0.025375324999537537, -0.025375324999537537, 0.031236121256966568;
  covariances[2] << 0.05324564813701508, 0.10888919922412635, 0.10888919922412635, 0.3396523679243901;
  std::vector<pair> shown;
  int i = 0;
  for (const int count : {60, 50, 40}) {
    for (int t = 0; t < count; ++t)
      shown.push_back({small::input(std::sin(0.11 * t) + 0.05 * std::sin(1.7 * t + i)),
                       small::output(std::cos(0.23 * t + 0.1 * i) + 0.04 * std::cos(2.3 * t)), t == 0});
    ++i;
  }
  const auto known = rule::batch(shown, {0, 0, 22, 0.1});
  CHECK(150 * known.likelihood == doctest::Approx(likelihood).epsilon(1e-10));
  CHECK((known.function.transitions - passages).norm() < 1e-12);
  CHECK((known.function.mixture.means - means).norm() < 1e-12);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK((known.function.mixture.covariances[k] - covariances[k]).norm() < 1e-12);
}

TEST_CASE("the chain that made the samples is found again") {
  const auto samples = drawn(5, 20, 100);
  const auto known = rule::batch(samples, {1e-6, 1e-9, 500, 0.5});
  const chain truth = made_by();
  // The states may have another order.
  std::array<int, 3> order{0, 1, 2}, best = order;
  double least = 1e9;
  do {
    double off = 0;
    for (std::size_t k = 0; k < 3; ++k)
      off += (known.function.mixture.means.col(order[k]) - truth.mean[k]).norm();
    if (off < least) least = off, best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  for (std::size_t j = 0; j < 3; ++j) {
    CHECK((known.function.mixture.means.col(best[j]) - truth.mean[j]).norm() < 0.1);
    CHECK(
        (known.function.mixture.covariances[static_cast<std::size_t>(best[j])] - truth.covariance[j]).norm() <
        0.1);
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(std::abs(known.function.transitions(best[j], best[k]) -
                     truth.passage(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k))) < 0.05);
  }
}

TEST_CASE("a model that learned a figure of eight goes straight on where it crosses itself") {
  plane_motion motion;
  // [learned]
  // Three demonstrations of a figure of eight, 2 s each with a sample every 10 ms.
  std::vector<cca::example<plane_rule::model>> shown;
  for (int demonstration = 0; demonstration < 3; ++demonstration)
    for (int t = 0; t < 200; ++t) {
      const double s = t / 200.0, size = 0.95 + 0.05 * demonstration;
      shown.push_back({size * eight(s), size * (eight(s + 1e-4) - eight(s - 1e-4)) / 4e-4, t == 0});
    }
  const auto learned = plane_rule::batch(shown, {});
  motion.p = {learned.function.mixture, learned.function.transitions};
  // [learned end]
  cca::check_parameters(motion.p);
  const auto right = [](double s) { return Eigen::Vector2d((eight(s + 1e-4) - eight(s - 1e-4)) / 4e-4); };
  double worst = 0, at_crossing = 0;
  for (int t = 0; t < 200; ++t) {
    const double s = t / 200.0;
    const auto v = std::get<0>(motion.process(given<cca::in<"position", plane>>(eight(s)))).vector();
    worst = std::max(worst, (v - right(s)).norm());
    if (t == 100) at_crossing = (v - right(s)).norm();
  }
  MESSAGE("of a speed of up to " << right(0).norm() << " m/s: error at most " << worst << ", at the crossing "
                                 << at_crossing);
  CHECK(worst < 0.2);
  CHECK(at_crossing < 0.1);
  // Without the history both directions mix.
  const Eigen::Vector2d blind = plane_rule::model::answer(learned.function, Eigen::Vector2d(0, 0));
  CHECK((blind - right(0.5)).norm() > 0.4);
}

TEST_CASE("demonstrations that share a place are kept apart: nothing goes from the end of one to the next") {
  std::vector<pair> shown;
  for (int i = 0; i < 4; ++i)
    for (int t = 0; t < 30; ++t) shown.push_back({small::input(0.1 * t), small::output(1), t == 0});
  const auto apart = rule::batch(shown, {1e-4, 1e-6, 100, 0});
  CHECK(apart.function.transitions(K - 1, 0) == 0);
  CHECK(apart.function.transitions(K - 1, K - 1) == 1);
  for (auto& example : shown) example.begins = false;
  const auto together = rule::batch(shown, {1e-4, 1e-6, 100, 1e-3});
  CHECK(together.function.transitions.row(K - 1).minCoeff() >= 0);
  CHECK((together.function.transitions - apart.function.transitions).norm() > 0.01);
}

TEST_CASE("what no state explains stays finite") {
  std::vector<pair> shown;
  for (int t = 0; t < 40; ++t)
    shown.push_back({small::input(t == 20 ? 1e9 : 0.1 * t), small::output(t == 21 ? -1e9 : 1), t % 20 == 0});
  for (const double floor : {1e-6, 1.0}) {
    const auto kept = rule::batch(shown, {floor, 0, 50, 0});
    CHECK(kept.function.mixture.means.allFinite());
    CHECK(kept.function.transitions.allFinite());
    CHECK(kept.function.mixture.check() == "");
    CHECK(std::isfinite(kept.likelihood));
  }
  const auto single = rule::batch(std::vector<pair>{shown[0]}, {});  // fewer than states
  CHECK(single.function.mixture.means.allFinite());
  CHECK(single.function.mixture.check() == "");
  CHECK(rule::batch(std::vector<pair>{}, {}).function.mixture.check() == "");
}
