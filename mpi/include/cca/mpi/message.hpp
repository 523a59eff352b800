// What ranks say to one another. All of it goes from rank 0 or to rank 0.
#pragma once

#include <cstdint>
#include <string>

namespace cca::mpi::detail {

enum class kind : std::uint32_t {
  alive,     // sent every tenth of the silence that is allowed
  ask,       // to rank 0: for runs of a call; `number`: threads without work, `other`: all threads
  grant,     // the numbers of runs
  finished,  // to rank 0: runs that are over, dropped or failed
  stopping,  // to rank 0: `stops` was true here
  cease,     // no further run of this call begins
  outcome,   // the results of a call, on all ranks the same
  goodbye,   // to rank 0: the program ends here; `number`: its exit code
  ended,     // rank 0 makes no further call
  release,   // the last word of rank 0: all are here, MPI ends
  last,      // the answer, and the last word of the other
  left_out   // to a rank that was taken for dead
};

struct message {
  kind what = kind::alive;
  std::uint64_t call = 0, number = 0, other = 0;
  std::string bytes{};
  int from = -1;
};

// In front of the bytes of a message, or of a piece of it.
struct message_head {
  kind what;
  std::uint32_t goes_on;  // more pieces follow
  std::uint64_t call, number, other;
};

}  // namespace cca::mpi::detail
