// Rank 0's book of one call: which runs wait, which are under way on which rank, which are over. It knows
// nothing of MPI. A run that is under way on a rank that is lost waits again.
//
// Test: tests/runtime/mpi/hand_out.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cca::mpi::detail {

// No run has failed: its number is `none`. What no run is to blame for has the number of runs.
struct failure {
  static constexpr auto none = static_cast<std::uint64_t>(-1);
  std::uint64_t number = none;
  std::string text{};
  bool is_one() const { return number != none; }
};

class hand_out {
public:
  explicit hand_out(std::size_t count) : place(count, waits), results(count) {}

  // Runs for a rank that could begin `idle` of them now, and has `own` of `all` threads: at least as many,
  // and more at once while many wait.
  std::vector<std::uint64_t> take(int rank, std::size_t idle, std::size_t own, std::size_t all) {
    std::vector<std::uint64_t> taken;
    if (ceased) return taken;
    const std::size_t waiting = back.size() + place.size() - next;
    const std::size_t share = waiting * own / (4 * std::max<std::size_t>(all, 1));
    for (std::size_t n = std::min(waiting, std::max(idle, share)); n > 0; --n) {
      std::size_t i = next;
      if (back.empty()) ++next;
      else i = back.back(), back.pop_back();
      place[i] = rank;
      ++out;
      taken.push_back(i);
    }
    return taken;
  }

  // True: it counts. What a rank says of a run that it does not have changes nothing.
  bool is_done(int rank, std::uint64_t i, std::string result) {
    if (!leaves(rank, i, over)) return false;
    results[i] = std::move(result);
    ++finished;
    return true;
  }
  // It was cut short, or did not begin.
  void is_dropped(int rank, std::uint64_t i) { leaves(rank, i, dropped); }
  // i: a run, or the number of runs: then something else than a run.
  void has_failed(int rank, std::uint64_t i, std::string text) {
    leaves(rank, i, dropped);
    if (i < first.number) first = {i, std::move(text)};
    ceased = true;
  }
  void is_lost(int rank) {
    for (std::size_t i = 0; i < place.size(); ++i)
      if (place[i] == rank) place[i] = waits, --out, back.push_back(i);
    std::ranges::sort(back, std::greater{});  // the lowest number first
  }
  void cease() { ceased = true; }

  bool has_ceased() const { return ceased; }
  bool is_over() const { return out == 0 && (ceased || finished == place.size()); }
  std::size_t count_finished() const { return finished; }
  const failure& failed() const { return first; }

  // The results before the first run that has none.
  std::vector<std::string> take_results() {
    const auto end = std::ranges::find_if(place, [](int where) { return where != over; });
    results.resize(static_cast<std::size_t>(end - place.begin()));
    return std::move(results);
  }

private:
  static constexpr int waits = -1, over = -2, dropped = -3;

  bool leaves(int rank, std::uint64_t i, int to) {
    if (i >= place.size() || place[i] != rank) return false;
    place[i] = to;
    --out;
    return true;
  }

  std::vector<int> place;  // of each run: a rank, or one of the above
  std::vector<std::string> results;
  std::vector<std::size_t> back;  // runs of lost ranks
  std::size_t next = 0, out = 0, finished = 0;
  bool ceased = false;
  failure first;
};

}  // namespace cca::mpi::detail
