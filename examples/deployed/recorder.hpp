#pragma once
// Records every sample that any component publishes, wherever that runs: an observer of the whole
// architecture, one beat late. Two records tell where two runs differ first.
//
//   in  all outputs, of every environment
//
// Of a sample it keeps a digest of 64 bits, of all bits of its numbers and of its origin. Cost: some
// operations for each number; no allocation in a beat, since `reserve` makes the room.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>
#include <cca/graph/items/graph.hpp>

namespace deployed {

class record {
public:
  // For so many beats. What comes after them is not kept.
  void reserve(std::int64_t beats) {
    names.reserve(most_outputs);
    digests.reserve(static_cast<std::size_t>(beats) * most_outputs);
  }
  void forget() {
    names.clear();
    digests.clear();
  }

  void note(const cca::observe<"**.*", cca::delayed<1>>& all) {
    if (all.size() > most_outputs || digests.size() + all.size() > digests.capacity()) return;
    if (names.empty())
      for (const cca::observation& one : all) names.push_back(one.path);
    for (const cca::observation& one : all) digests.push_back(one.fresh ? digest(one) : 0);
  }

  std::int64_t beats() const {
    return names.empty() ? 0 : static_cast<std::int64_t>(digests.size() / names.size());
  }
  struct place {
    std::string_view output;
    std::int64_t beat = 0;
  };
  struct comparison {
    std::int64_t compared = 0, different = 0;  // samples
    std::optional<place> first;                // of those that differ
  };

  // The samples of the first beats of this record and another.
  comparison compare(const record& other, std::int64_t beats_compared) const {
    comparison all;
    if (names != other.names || beats() < beats_compared || other.beats() < beats_compared)
      return {0, 1, place{"the records have other outputs or beats", 0}};
    const auto count = static_cast<std::size_t>(beats_compared) * names.size();
    for (std::size_t i = 0; i < count; ++i) {
      all.compared += digests[i] != 0 || other.digests[i] != 0;
      if (digests[i] == other.digests[i]) continue;
      if (++all.different == 1)
        all.first = place{names[i % names.size()], static_cast<std::int64_t>(i / names.size()) - 1};
    }
    return all;
  }

private:
  static constexpr std::size_t most_outputs = 160;

  // Never 0, which stands for no sample.
  static std::uint64_t digest(const cca::observation& one) {
    std::uint64_t sum = static_cast<std::uint64_t>(one.origin);
    for (const double value : one.values) {
      sum = (sum ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15;
      sum ^= sum >> 29;
    }
    return sum | 1;
  }

  std::vector<std::string_view> names;  // static text
  std::vector<std::uint64_t> digests;   // beat by beat, 0: nothing was published
};

// The component. What it hears in a beat was published in the beat before.
struct recorder {
  void process(cca::observe<"**.*", cca::delayed<1>> all) { seen.note(all); }
  void on_start() { seen.forget(); }

  record seen;
};

}  // namespace deployed
