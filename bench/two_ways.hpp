// A program that computes quantities in two ways: by the library (`cca`) and by another one.
//
//   PROGRAM check               compares all results; exits with 1 if they differ
//   PROGRAM list                the names of the quantities
//   PROGRAM NAME WAY ROUNDS     computes one quantity this many times, for another state each time (under
//                               callgrind)
//   PROGRAM NAME allocations    the allocations of 1000 rounds of the library
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

extern "C" long bench_allocations();

namespace bench {

// Other angles, speeds and inputs in each round, without a cost that counts.
template <class State>
void spread(State& s, int round) {
  const int n = static_cast<int>(s.q.size());
  for (int i = 0; i < n; ++i) {
    const double x = (round * n + i) * 0.61803398875;
    s.q[i] = 2 * (x - std::floor(x)) - 1;
    s.dq[i] = 0.7 - s.q[i];
    s.input[i] = 3 * s.q[i] + 1;
  }
}

// A call each, as in a beat of a controller.
template <class Quantity, class State>
[[gnu::noinline]] auto once_cca(const State& s) {
  return Quantity::cca(s);
}

template <class Quantity, class State>
[[gnu::noinline]] auto once_loops(const State& s) {
  return Quantity::loops(s);
}

// What is recorded at compile time, beside the loops over the links. `States::next(round)`: the state of a
// round. `States::tolerance`: a part of the largest number.
template <class States>
struct beside_loops : States {
  template <class Quantity>
  static bool check() {
    for (int i = 0; i < 100; ++i) {
      const auto s = States::next(i);
      const auto a = once_cca<Quantity>(s), b = once_loops<Quantity>(s);
      if ((a - b).cwiseAbs().maxCoeff() <= States::tolerance * b.cwiseAbs().maxCoeff()) continue;
      std::fprintf(stderr, "%s differs from the loops by %g\n", Quantity::name, (a - b).norm());
      return false;
    }
    return true;
  }
  template <class Quantity>
  static double sum(std::string_view way, int rounds) {
    double sum = 0;
    for (int i = 0; i < rounds; ++i)
      sum += way == "cca" ? once_cca<Quantity>(States::next(i)).sum()
                          : once_loops<Quantity>(States::next(i)).sum();
    return sum;
  }
};

// A call of the other library, of which `Library` is: it takes a state, and a quantity computes by it.
template <class Quantity, class Library>
[[gnu::noinline]] auto once_other(Library& l) {
  return Quantity::other(l);
}

// The library beside another one.
template <class State, class Library>
struct beside_another {
  static State next(int round) {
    State s;
    spread(s, round);
    return s;
  }
  template <class Quantity>
  static bool check() {
    Library other;
    for (int i = 0; i < 100; ++i) {
      const State s = next(i);
      other.take(s);
      const auto ours = once_cca<Quantity>(s), theirs = once_other<Quantity>(other);
      if ((ours - theirs).norm() < 1e-9 * (1 + theirs.norm())) continue;
      std::fprintf(stderr, "%s differs from %s by %g\n", Quantity::name, Library::name,
                   (ours - theirs).norm());
      return false;
    }
    return true;
  }
  template <class Quantity>
  static double sum(std::string_view way, int rounds) {
    Library other;
    double sum = 0;
    for (int i = 0; i < rounds; ++i) {
      const State s = next(i);
      if (way == "cca") {
        sum += once_cca<Quantity>(s).sum();
      } else {
        other.take(s);
        sum += once_other<Quantity>(other).sum();
      }
    }
    return sum;
  }
};

// `Ways::next(round)`: the state of a round. `Ways::check<Quantity>()`: whether both ways agree.
// `Ways::sum<Quantity>(way, rounds)`: of all numbers of so many rounds.
template <class Ways, class... Quantities>
int program(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "check") return (Ways::template check<Quantities>() && ...) ? 0 : 1;
  if (what == "list") {
    (std::puts(Quantities::name), ...);
    return 0;
  }
  int result = 2;
  const auto try_one = [&]<class Quantity>(Quantity) {
    if (what != Quantity::name) return;
    double sum = 0;
    if (argc == 4) {
      sum = Ways::template sum<Quantity>(argv[2], std::atoi(argv[3]));
    } else if (argc == 3 && std::string_view(argv[2]) == "allocations") {
      const long before = bench_allocations();
      for (int i = 0; i < 1000; ++i) sum += once_cca<Quantity>(Ways::next(i)).sum();
      std::printf("%ld\n", bench_allocations() - before);
    } else {
      return;
    }
    result = std::isfinite(sum) ? 0 : 1;
  };
  (try_one(Quantities{}), ...);
  return result;
}

}  // namespace bench
