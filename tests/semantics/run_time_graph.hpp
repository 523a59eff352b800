// A graph at run time, already flat: vectors of nodes, their calls, the histories of their outputs, and what
// an input sees.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

#include "firing.hpp"

namespace semantics {

struct strategy {
  enum kind {
    by_default,
    timed,
    restless,
    moderate,
    timeout,
    port_triggered,
    coordinated,
    full_speed,
    inactive,
    any_of,
    all_of,
    stoppable,
    user
  };
  kind is = by_default;
  std::int64_t n = 1, phase = 0;
  std::vector<std::string> names;  // port_triggered; user: its name and its port
  std::vector<strategy> parts;     // any_of, all_of, stoppable
  int number = 0;                  // user: of all in the description; it finds what is kept of it
};

// In the order of the enumerators; the words of a description, too.
inline constexpr const char* strategy_names[] = {
    "default",  "timed",  "restless", "moderate",  "timeout", "port_triggered", "coordinated", "full_speed",
    "inactive", "any_of", "all_of",   "stoppable", "user"};
static_assert(std::size(strategy_names) == strategy::user + 1, "each strategy has a name");

struct publication {
  std::int64_t beat = 0;
  std::vector<double> value;
  std::int64_t origin = never;
  std::int64_t number = 0;   // in the order of all publications
  int way = 0;               // in a queue: by which way it came
  bool closed_loop = false;  // and whether that closed a loop then: another mode may have other ways
};

struct output {
  std::string name;
  int width = 1;
  bool is_maybe = false;
  std::vector<publication> history;
};

enum class policy { latest, queue };
enum class when_full { drop_oldest, drop_newest, reject };

// A wire to an input: from which output of which call, and how many beats it takes; 0: it is not delayed.
struct way {
  int writer = -1, port = -1;
  std::int64_t delay = 0;
  bool is_taken = false;   // it brings what the writer's input number `port` takes from its queue
  std::int64_t since = 0;  // into a queue: what was published before this beat does not come
};

struct input {
  std::string name;
  int width = 1;
  bool optional = false;
  std::vector<way> ways;  // more than one: they are merged
  policy is = policy::latest;
  bool is_merged = false;
  bool is_heard = false;                  // by an observer
  std::tuple<int, bool, int> heard{};     // it hears this port: of which call, an input or not, its number
  int shown_call = -1, shown_input = -1;  // it shows what waits in the queue of this input
  std::size_t capacity = 0;
  when_full full = when_full::drop_oldest;
  std::vector<double> initial;

  std::deque<publication> waiting;  // queue
  std::optional<publication> taken;
  std::vector<publication> all_taken;
  std::int64_t arrived_in = never;  // queue: the beat in which the newest samples arrived, and how many
  int arrivals = 0;
  // For the count of what was exercised.
  int dropped = 0, reads = 0, fresh_reads = 0, ways_taken = 0;

  bool wired() const { return !ways.empty(); }
  bool delayed() const { return ways.size() == 1 && ways[0].delay > 0; }
};

// What a call observes: a pattern, and the policies as those of an input.
struct observed {
  std::string pattern;
  input as{};
  std::int64_t delay = 0;
};

// One call in a beat: of a component, or of one function of a resource node. function::look: what a graph
// observes for a program.
struct call {
  int node = -1;
  function which = function::process;
  std::vector<input> inputs;
  std::vector<output> outputs;
  std::vector<observed> patterns;
  bool may_fault = false;

  std::int64_t last_fired = never;
  std::int64_t oldest_seen = never;  // when it last fired
  bool is_new = true;                // it has not fired since it was started
  int firings = 0;
};

// A component, or an inner graph as a whole, that may be stopped.
struct part {
  std::string path;
  std::int64_t stop_in = never, start_in = never;  // before which beat somebody stops and starts it
  bool is_stopped = false;
  int asked = 0;    // in this beat: 1 to start, -1 to stop
  int changes = 0;  // that components have asked for
};
struct request {
  int part = -1;
  bool starts = false;
  int salt = 0;
};

struct node {
  std::string path;
  bool resource = false;
  strategy when;
  int id = 0;
  std::vector<int> parts{};                             // that have it, and may be stopped
  std::vector<request> asks{};                          // of parts, each time it fires
  std::vector<std::pair<std::string, int>> switches{};  // of modes: the name, and the salt
  std::string skeleton{};  // its kind: a component of the library's, which writes nothing down
  std::function<void(firing&)> does;
};

struct graph {
  std::string name;
  std::int64_t period = 1;  // T, in nanoseconds
  std::vector<node> nodes;  // as declared, depth first
  std::vector<call> calls;  // as declared
  std::vector<part> parts;
  std::map<std::string, std::vector<std::string>> second_names;  // of a port, as graphs expose it
  std::vector<std::int64_t> looks;                               // before these beats a program looks
  std::map<std::string, int> features;                           // counted by who made the graph
  std::string mode;                                              // empty: it is no mode
  std::vector<graph> modes;                                      // all of its set
  std::vector<std::pair<std::int64_t, std::string>> switches;    // before these beats somebody switches
  int switched = 0;                                              // so often have components
};

// An input as its component sees it.
struct seen_input {
  std::vector<double> value;
  std::int64_t origin = never;  // of an initial value: never
  bool arrived = false;         // a sample, no initial value
  bool fresh = false;
  int way = 0;
  bool closed_loop = false;
};

}  // namespace semantics
