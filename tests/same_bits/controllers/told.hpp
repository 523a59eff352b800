// What a robot sensed, read from the standard input as extract.cpp writes it, and what its controller then
// publishes, printed. For one program by many compilers: whatever it prints must be the same everywhere.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <tuple>
#include <vector>

#include <cca/cca.hpp>
#include <cca/graph/layout/lookup.hpp>
#include <cca/graph/layout/nodes_by_path.hpp>
#include <cca/runtime/observers/beat_tap.hpp>

namespace same_bits {

// One entry: the number of its topic, how many coordinates, beat, time of origin, the coordinates.
struct entry {
  std::uint32_t topic = 0, size = 0;
  std::int64_t beat = 0, origin = 0;
  std::vector<double> numbers;
};

inline bool read(std::FILE* from, entry& to) {
  if (std::fread(&to.topic, sizeof to.topic, 1, from) != 1 ||
      std::fread(&to.size, sizeof to.size, 1, from) != 1 ||
      std::fread(&to.beat, sizeof to.beat, 1, from) != 1 ||
      std::fread(&to.origin, sizeof to.origin, 1, from) != 1)
    return false;
  to.numbers.resize(to.size);
  return std::fread(to.numbers.data(), sizeof(double), to.size, from) == to.size;
}

// The entries of one beat after the other.
class sensed {
public:
  sensed() { goes_on = read(stdin, next); }

  bool is_over() const { return !goes_on; }
  std::int64_t first_beat() const { return next.beat; }
  // `take(entry)` for each of this beat.
  template <class Take>
  void of_beat(std::int64_t k, Take take) {
    for (; goes_on && next.beat <= k; goes_on = read(stdin, next))
      if (next.beat == k) take(next);
  }

private:
  entry next;
  bool goes_on = false;
};
inline sensed& all_sensed() {
  static sensed one;
  return one;
}

// A port of the robot: the sample of this beat.
template <class Vector>
void put(const entry& e, Vector& to) {
  for (int i = 0; i < to.size(); ++i) to[i] = e.numbers.at(static_cast<std::size_t>(i));
}

// Prints each sample of each output: beat, path, a hash of its bits and of its time of origin.
template <class Graph>
class printer final : public cca::detail::beat_tap<Graph> {
  static constexpr int outputs = cca::detail::counts_of<Graph>.output_count;
  static constexpr const auto& layout = cca::detail::frame_layout_of<Graph>;

public:
  printer() : cca::detail::beat_tap<Graph>(4) {}

  void print() {
    const auto& plan = cca::detail::plan_of<Graph>;
    while (const std::int64_t* const frame = this->ring.oldest()) {
      for (std::size_t o = 0; o < static_cast<std::size_t>(outputs); ++o) {
        const std::int64_t origin = frame[layout.origin[o]];
        if (origin == cca::never) continue;
        std::uint64_t hash = 0x9e3779b97f4a7c15;
        const auto add = [&hash](std::int64_t word) {
          hash = (hash ^ static_cast<std::uint64_t>(word)) * 0x100000001b3;
          hash ^= hash >> 29;
        };
        add(origin);
        for (int i = 0; i < layout.size[o]; ++i) add(frame[layout.at[o] + i]);
        const auto& out = plan.outputs[o];
        const auto& call = plan.calls[static_cast<std::size_t>(out.call)];
        const auto path = cca::detail::path_of_node<Graph>(call.node);
        std::printf("%lld %s.%s %016llx\n", static_cast<long long>(frame[0]), std::string(path).c_str(),
                    std::string(cca::detail::port_of(call, out).name).c_str(),
                    static_cast<unsigned long long>(hash));
      }
      this->ring.take();
    }
  }

  void parameters_changed(const cca::detail::controller_state<Graph>&, std::int64_t) noexcept override {}
  void moved(cca::state, std::int64_t) noexcept override {}
  void failed(int, const char*, std::int64_t) noexcept override {}
  void controller_is_gone() noexcept override {}
};

// Runs the controller as long as `goes_on(controller)`. `before(controller)`: before each beat.
template <class Graph, class Prepare, class Before, class GoesOn>
int run(Prepare prepare, Before before, GoesOn goes_on) {
  printer<Graph> out;
  cca::controller<Graph> c;
  c.record_into(&out);
  prepare(c);
  c.load();
  c.start();
  while (goes_on(c)) {
    before(c);
    c.step();
    out.print();
  }
  return c.state() == cca::state::faulted;
}

// As long as something was sensed.
template <class Graph, class Prepare, class Before>
int run(Prepare prepare, Before before) {
  return same_bits::run<Graph>(prepare, before, [](const auto&) { return !all_sensed().is_over(); });
}

}  // namespace same_bits
