// The skeletons that are components, for the interpreter: what docs/skeletons.md says of each, on plain
// vectors and independent of the library. Skeletons that are graphs reach the interpreter as their nodes.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

#include "firing.hpp"

namespace semantics {

namespace skeletons {

struct value {
  std::vector<double> x;
  std::int64_t origin = never;
};

inline value of(const recorded_input& s) { return {s.value, s.origin}; }

inline void tell(recorded_output& t, const value& v) {
  t.value = v.x;
  t.sets_origin = v.origin != never;
  t.origin = v.origin;
}
inline void tell(recorded_output& t, double number) { t.value = {number}; }

// On a line; a part of weight 0 leaves no trace.
inline value between(const value& a, const value& b, double t) {
  if (!(t > 0)) return a;
  if (t >= 1) return b;
  value v = a;
  for (std::size_t i = 0; i < v.x.size(); ++i) v.x[i] = (1 - t) * a.x[i] + t * b.x[i];
  v.origin = a.origin == never ? b.origin : b.origin == never ? a.origin : std::min(a.origin, b.origin);
  return v;
}

// Blends each part with the mean of the parts before it, by its share of the weights so far.
inline value mean(const std::vector<double>& weights, const std::vector<recorded_input>& inputs) {
  value v = of(inputs[0]);
  double sum = weights[0];
  for (std::size_t i = 1; i < weights.size(); ++i) {
    sum += weights[i];
    v = between(v, of(inputs[i]), sum > 0 ? weights[i] / sum : 0);
  }
  return v;
}

// The first input that was fresh within its patience; if none was, the last writer stays.
struct by_priority {
  std::size_t count;
  std::int64_t patience;
  std::vector<std::int64_t> heard = std::vector<std::int64_t>(count, never);
  std::size_t speaks = 0;
  void operator()(firing& f) {
    for (std::size_t i = 0; i < count; ++i)
      if (f.inputs[i].fresh) heard[i] = f.time;
    for (std::size_t i = count; i-- > 0;)
      if (heard[i] != never && f.time - heard[i] <= patience) speaks = i;
    tell(f.outputs[0], of(f.inputs[speaks]));
    tell(f.outputs[1], static_cast<double>(speaks));
  }
};

struct by_freshness {
  std::size_t count;
  void operator()(firing& f) const {
    std::size_t youngest = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (f.inputs[i].origin > f.inputs[youngest].origin) youngest = i;
    tell(f.outputs[0], of(f.inputs[youngest]));
    tell(f.outputs[1], static_cast<double>(youngest));
  }
};

struct switching {
  std::size_t count;
  double duration;
  int chosen = -1;
  std::vector<double> weights = std::vector<double>(count), begin{};
  double passed = 0;
  void operator()(firing& f) {
    const double wanted = f.inputs[count].value[0];
    for (std::size_t i = 0; i < count; ++i)
      if (std::floor(wanted) == static_cast<double>(i) && f.inputs[i].origin != never &&
          chosen != static_cast<int>(i)) {
        begin = weights;
        passed = chosen < 0 ? duration : 0;
        chosen = static_cast<int>(i);
        break;
      }
    bool settled = false;
    if (chosen < 0) {
      weights = std::vector<double>(count);
      weights[0] = 1;
    } else {
      const double next = passed + f.dt;
      settled = next >= duration;
      passed = settled ? duration : next;
      const double u = settled ? 1 : passed / duration, s = u * u * u * (10 - 15 * u + 6 * u * u);
      for (std::size_t i = 0; i < count; ++i) {
        const double end = chosen == static_cast<int>(i);
        weights[i] = settled ? end : begin[i] + s * (end - begin[i]);
      }
    }
    tell(f.outputs[0], mean(weights, f.inputs));
    tell(f.outputs[1], settled);
  }
};

struct blend {
  double none, full;
  void operator()(firing& f) const {
    tell(f.outputs[0],
         between(of(f.inputs[0]), of(f.inputs[1]), (f.inputs[2].value[0] - none) / (full - none)));
  }
};

struct blend_of {
  std::size_t count;
  void operator()(firing& f) const {
    std::vector<double> weights = f.inputs[count].value;
    for (double& w : weights) w = std::max(w, 0.0);
    tell(f.outputs[0], mean(weights, f.inputs));
  }
};

struct hold {
  value kept{};
  void operator()(firing& f) {
    const auto& freeze = f.inputs[1];
    if (!freeze.wired || freeze.value[0] == 0 || kept.origin == never) kept = of(f.inputs[0]);
    tell(f.outputs[0], kept);
  }
};

struct decimate {
  int n;
  bool averages;
  int count = 0;
  value so_far{};
  void operator()(firing& f) {
    const int number = count++ % n;
    so_far =
        number == 0 || !averages ? of(f.inputs[0]) : between(so_far, of(f.inputs[0]), 1.0 / (number + 1));
    f.outputs[0].published = number == (averages ? n - 1 : 0);
    if (f.outputs[0].published) tell(f.outputs[0], so_far);
  }
};

struct interpolate {
  int n;
  bool begun = false;
  int steps = 0;
  value from{}, at{};
  void operator()(firing& f) {
    const value to = of(f.inputs[0]);
    if (f.inputs[0].fresh) from = at, steps = begun ? 0 : n, begun = true;  // the first is taken at once
    steps = std::min(steps + 1, n);
    at = begun ? between(from, to, static_cast<double>(steps) / n) : to;
    tell(f.outputs[0], at);
  }
};

// Its workers have all the time that they need: a result is there one beat after its task.
struct on_threads {
  int tasks = 0;
  std::deque<value> made{};
  void operator()(firing& f) {
    f.outputs[0].published = !made.empty();
    if (!made.empty()) tell(f.outputs[0], made.front()), made.pop_front();
    if (f.inputs[0].fresh) {
      value v = of(f.inputs[0]);
      for (double& x : v.x) x = worker_result(x, tasks);
      made.push_back(v), ++tasks;
    }
    tell(f.outputs[1], static_cast<double>(made.size()));
    tell(f.outputs[2], 0.0);
  }
};

// The first coordinates go to the first output, and so on: a splitter, and what shares tasks out to a farm.
inline void apart(firing& f) {
  std::size_t next = 0;
  for (recorded_output& t : f.outputs)
    for (double& x : t.value) x = f.inputs[0].value[next++];
}
inline void together(firing& f) {
  std::size_t next = 0;
  for (const recorded_input& s : f.inputs)
    for (const double x : s.value) f.outputs[0].value[next++] = x;
}

}  // namespace skeletons

inline std::function<void(firing&)> skeleton(const std::string& kind, std::istream& from) {
  using namespace skeletons;
  const auto number = [&] {
    std::int64_t n = 0;
    from >> n;
    return n;
  };
  const auto count = [&] { return static_cast<std::size_t>(number()); };
  const auto word = [&] {
    std::string w;
    from >> w;
    return w;
  };
  if (kind == "by_priority") {
    const auto n = count();
    return by_priority{n, number()};
  }
  if (kind == "by_freshness") return by_freshness{count()};
  if (kind == "switch") {
    const auto n = count();
    return switching{n, static_cast<double>(number()) * 1e-9};
  }
  if (kind == "blend") {
    const auto none = static_cast<double>(number());
    return blend{none, static_cast<double>(number())};
  }
  if (kind == "blend_of") return blend_of{count()};
  if (kind == "hold") return hold{};
  if (kind == "decimate") {
    const auto n = static_cast<int>(number());
    return decimate{n, word() == "averaged"};
  }
  if (kind == "on_threads") {
    count();
    return on_threads{};
  }
  if (kind == "interpolate") return interpolate{static_cast<int>(number())};
  if (kind == "splitter" || kind == "share_out") {
    if (kind == "share_out") count();
    return apart;
  }
  if (kind == "collector" || kind == "gather") {
    if (kind == "gather") count();
    return together;
  }
  throw std::runtime_error("description: no skeleton '" + kind + "'");
}

}  // namespace semantics
