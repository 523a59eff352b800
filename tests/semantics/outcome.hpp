// What the library did with an architecture, and the list of all architectures that are compiled in.
#pragma once

#include <vector>

#include "firing.hpp"

namespace semantics {

inline constexpr int beats = 200;

struct outcome {
  log firings;
  bool faulted = false;
  bool copy_agrees = true;  // a copy made on the way went on bit for bit like the original; a deployment that
                            // is stopped, started and resumed did what the controller does
  bool processes_agree = true;  // a deployment whose environments are processes did the same
  bool is_merged = false;       // the firings of several threads: their order in a beat is not known
};

struct registered {
  registered(int from_seed, const char* described, outcome (*runs)(int))
      : seed(from_seed), text(described), run(runs) {
    all().push_back(this);
  }
  static std::vector<registered*>& all() {
    static std::vector<registered*> list;
    return list;
  }
  int seed;
  const char* text;
  outcome (*run)(int copy_at);
};

inline bool agree(const log& a, std::size_t from, const log& b) {
  if (a.size() - from != b.size()) return false;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (!same(a[from + i], b[i])) return false;
  return true;
}

}  // namespace semantics
