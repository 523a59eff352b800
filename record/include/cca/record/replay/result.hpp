// What a replay found: the same samples, or the first one that differs.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

namespace cca::recording {

struct replay_result {
  std::int64_t beats = 0;           // that were compared
  std::int64_t samples = 0;         // that were equal, bit for bit
  std::string difference{};         // what differs, as a sentence; empty: nothing
  std::string component{}, port{};  // of the first difference, in the order of the beat
  std::int64_t beat = -1;
  std::string fault{};  // of the replayed controller in the last beat, as "`guard`: too fast"; empty: none
  std::string ended_early{};  // why the recording could not be replayed to its end; empty: it could
  std::string
      not_compared{};  // why nothing was compared; empty: something was, or the graph computes nothing

  // All of the recording was replayed, and every sample is the same.
  explicit operator bool() const { return difference.empty() && ended_early.empty() && not_compared.empty(); }

  friend std::ostream& operator<<(std::ostream& to, const replay_result& r) {
    if (!r.difference.empty()) return to << r.difference;
    if (r.beats == 0 && !r.ended_early.empty()) return to << "nothing is replayed: " << r.ended_early;
    if (r.not_compared.empty())
      to << r.samples << " samples of " << r.beats << " beats, bit for bit as recorded";
    else to << "nothing is compared in " << r.beats << " beats: " << r.not_compared;
    if (!r.ended_early.empty()) to << "; then " << r.ended_early;
    return to;
  }
};

}  // namespace cca::recording
