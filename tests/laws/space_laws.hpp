// The laws of spaces, each stated once and run over every model that it applies to.
//
// A model makes and compares samples: `Model::random(source)`, and `Model::close(a, b)`, which is equality up
// to rounding and up to the representation (q and -q, 0 and 2 pi).
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include <doctest/doctest.h>

#include <cca/space/domain.hpp>
#include <cca/space/sample.hpp>

namespace laws {

inline constexpr int rounds = 200;

struct source {
  std::mt19937_64 bits;
  double operator()(double from, double to) {
    return from + (to - from) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }
  Eigen::Vector3d vector(double size) {
    return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)};
  }
};

// a * b and a.inverse() form a group; the zero of the space is the identity.
template <class Model>
void group() {
  source random{std::mt19937_64{1}};
  const decltype(Model::random(random)) e{};
  for (int i = 0; i < rounds; ++i) {
    const auto a = Model::random(random), b = Model::random(random), c = Model::random(random);
    CHECK_MESSAGE(Model::close((a * b) * c, a * (b * c)), "associative");
    CHECK_MESSAGE(Model::close(a * e, a), "the identity on the right");
    CHECK_MESSAGE(Model::close(e * a, a), "the identity on the left");
    CHECK_MESSAGE(Model::close(a * a.inverse(), e), "the inverse on the right");
    CHECK_MESSAGE(Model::close(a.inverse() * a, e), "the inverse on the left");
    CHECK_MESSAGE(Model::close((a * b).inverse(), b.inverse() * a.inverse()), "the inverse of a product");
  }
}

// Model::act(a, x) moves a point: (a * b) acts like b and then a, and keeps distances.
template <class Model>
void action() {
  source random{std::mt19937_64{2}};
  for (int i = 0; i < rounds; ++i) {
    const auto a = Model::random(random), b = Model::random(random);
    const auto x = Model::point(random), y = Model::point(random);
    CHECK_MESSAGE(Model::act(a * b, x).distance(Model::act(a, Model::act(b, x))) < 1e-12,
                  "a product acts as its factors");
    CHECK_MESSAGE(
        Model::act(a, x).distance(Model::act(a, y)) == doctest::Approx(x.distance(y)).epsilon(1e-12),
        "distances stay");
    CHECK_MESSAGE(Model::act(a.inverse(), Model::act(a, x)).distance(x) < 1e-12, "the inverse undoes it");
  }
}

// a.difference(b), and Model::plus(b, difference), which gives a.
template <class Model>
void differences() {
  source random{std::mt19937_64{3}};
  for (int i = 0; i < rounds; ++i) {
    const auto a = Model::random(random), b = Model::random(random);
    CHECK_MESSAGE(Model::close(Model::plus(b, a.difference(b)), a), "b plus the difference is a");
    CHECK_MESSAGE(a.difference(a).norm() < 1e-12, "the difference of a and a is zero");
    CHECK_MESSAGE((a.difference(b).norm() == doctest::Approx(b.difference(a).norm()).epsilon(1e-12)),
                  "as far there as back");
  }
}

template <class Model>
void interpolation() {
  source random{std::mt19937_64{4}};
  for (int i = 0; i < rounds; ++i) {
    const auto a = Model::random(random), b = Model::random(random);
    const double t = random(0, 1);
    CHECK_MESSAGE(Model::close(a.interpolated(b, 0), a), "starts at a");
    CHECK_MESSAGE(Model::close(a.interpolated(b, 1), b), "ends at b");
    CHECK_MESSAGE(Model::close(a.interpolated(a, t), a), "stays at a between a and a");
    CHECK_MESSAGE(Model::close(a.interpolated(b, t), b.interpolated(a, 1 - t)), "the same way back");
  }
}

// If the space has differences, interpolation at t covers the part t of the difference.
template <class Model>
void straight() {
  source random{std::mt19937_64{5}};
  for (int i = 0; i < rounds; ++i) {
    const auto a = Model::random(random), b = Model::random(random);
    const double t = random(0, 1);
    CHECK_MESSAGE((a.interpolated(b, t).difference(a) - t * b.difference(a)).norm() < 1e-9, "constant speed");
  }
}

// Sums and multiples.
template <class Model>
void sums() {
  source random{std::mt19937_64{6}};
  const decltype(Model::random(random)) zero{};
  for (int i = 0; i < rounds; ++i) {
    const auto a = Model::random(random), b = Model::random(random), c = Model::random(random);
    const double k = random(-3, 3);
    CHECK_MESSAGE(Model::close((a + b) + c, a + (b + c)), "associative");
    CHECK_MESSAGE(Model::close(a + b, b + a), "commutative");
    CHECK_MESSAGE(Model::close(a + zero, a), "the zero");
    CHECK_MESSAGE(Model::close(a + (-a), zero), "the opposite");
    CHECK_MESSAGE(Model::close(a - b, a + (-b)), "minus");
    CHECK_MESSAGE(Model::close(k * (a + b), k * a + k * b), "distributive");
    CHECK_MESSAGE(Model::close(a * k, k * a), "a factor on either side");
  }
}

// The result of two samples has the older origin of the two; an initial value doesn't count.
template <class Model, class Operation>
void origins(Operation combine) {
  source random{std::mt19937_64{7}};
  const auto a = Model::random(random), b = Model::random(random);
  using sample = std::remove_cvref_t<decltype(a)>;
  CHECK(combine(sample(a.vector(), 5), sample(b.vector(), 3)).origin() == 3);
  CHECK(combine(sample(a.vector(), 3), sample(b.vector(), 5)).origin() == 3);
  CHECK(combine(sample(a.vector(), 3), sample(b.vector())).origin() == 3);
  CHECK(combine(sample(a.vector()), sample(b.vector(), 3)).origin() == 3);
  CHECK(combine(sample(a.vector()), sample(b.vector())).origin() == cca::never);
}

}  // namespace laws
