// The program of docs/cluster.md.
#include <cstddef>
#include <cstdio>
#include <vector>

#include <cca/base/math.hpp>
#include <cca/mpi/ranks.hpp>

namespace {

double value_of(double width) { return cca::math::sin(9 * width) - width * width; }

}  // namespace

// [ranks]
int main(int count, char** words) {
  cca::mpi::ranks all(count, words);  // first in main
  double best = 0.5, around = 0.5;
  for (int generation = 0; generation < 10; ++generation) {
    const auto width = [&](std::size_t i) { return best + around * (static_cast<double>(i) / 10 - 1); };
    const std::vector<double> values = all.rollouts(21, [&](std::size_t i) { return value_of(width(i)); });
    std::size_t winner = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] > values[winner]) winner = i;
    best = width(winner);
    around *= 0.3;
  }
  if (all.is_first()) std::printf("the best width is %.6f\n", best);
}
// [ranks end]
