// What a test component records each time it fires, and what it answers: the same on both sides of the
// comparison.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace semantics {

inline constexpr std::int64_t never = std::numeric_limits<std::int64_t>::lowest();

struct recorded_input {
  std::string name;
  std::vector<double> value;
  std::int64_t origin = never;
  bool fresh = false, wired = false;
  std::int64_t dropped = 0;
};

struct recorded_output {
  std::vector<double> value;
  bool is_maybe = false;
  bool published = true;
  bool sets_origin = false;
  std::int64_t origin = never;  // only if the component sets it
};

// `look`: a program looks at what graphs observe, one firing for each port.
enum class function : std::uint8_t { sense, process, act, on_fault, look };
inline constexpr int looker = 9999;  // the id of the program

struct firing {
  int id = 0;
  function which = function::process;
  std::int64_t beat = 0, time = 0;
  double dt = 0;
  std::vector<recorded_input> inputs;
  std::vector<recorded_output> outputs;
  bool may_fault = false, fault = false;
};

using log = std::vector<firing>;

// No templates: they would be compiled again for each kind of test component.
void add_input(firing& f,
               std::string_view name,
               const double* values,
               int size,
               std::int64_t origin,
               bool fresh,
               bool wired,
               std::int64_t dropped = 0);
void add_output(firing& f, int size, bool is_maybe);
void copy_value(const recorded_output& from, double* to);

// What distinguishes a test component from the others. It is a structural type, so it can be a template
// argument.
struct habit {
  int id = 0;
  int publishes = 100;  // of a hundred times, for the outputs that are `maybe`
  int origin = 0;  // 0: never sets an origin; 1: two periods back, always; 2: sometimes the beat's, sometimes
                   // a period ahead
  int fault_at = -1;  // from this beat on it returns a fault
};

// What a test component remembers from one firing to the next.
struct memory {
  double state = 0;
  int firings = 0;
};

// Fills `f.outputs` (whose sizes are set) and `f.fault` from all that the component sees and remembers.
void respond(const habit& h, memory& m, firing& f);

// Whether a test component asks for a part, in a beat: `salt` says which of its requests.
inline bool wants(int id, std::int64_t beat, int salt) {
  std::uint64_t h = static_cast<std::uint64_t>(beat) * 0x9e3779b97f4a7c15u +
                    static_cast<std::uint64_t>(id) * 7919u + static_cast<std::uint64_t>(salt) * 104729u;
  h ^= h >> 31;
  h *= 0xbf58476d1ce4e5b9u;
  return (h >> 40) % 13 == 0;
}

// What a worker on a thread makes of its part, the n-th time.
inline double worker_result(double x, int n) { return 0.5 * x + n % 5; }

// Components write here: each thread has its own. A thread that has none gets one when it records first.
inline thread_local log* recording = nullptr;
void record(const firing& f);
// What a program saw at once: the text leaves open in which order.
log in_order_of_content(log seen);
// What all threads wrote that had none; it is forgotten then. They must have ended.
log recorded_by_threads();

// In an order that does not depend on that of threads; what `on_fault` recorded comes last.
log merged(log all);

// Of all that it holds, bit for bit.
std::uint64_t digest(const firing& f);

// Bit for bit.
bool same(const std::vector<double>& a, const std::vector<double>& b);
bool same(const firing& a, const firing& b);

std::ostream& operator<<(std::ostream& to, const firing& f);

}  // namespace semantics
