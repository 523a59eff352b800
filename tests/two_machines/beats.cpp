// How short a beat may be between two machines: a joint controller on the one, what thinks for it on the
// other, with delays of 1 to 5 beats on all wires between them, in a wall-clock run. It counts the late
// beats, and the longest row of them: the least that `tolerate<N>` must be.
//
//   cca_beats_over_cable robot|mind OWN OTHER DELAY MS BEATS [--loses] [--most-late %]
//
// The robot sends twelve angles, twelve velocities and an acceleration, the mind twelve commands and twelve
// stiffnesses: five samples of 24 to 96 bytes in a beat, and both sides say how far they are.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <tuple>

#include <cca/cca.hpp>
#include <cca/dds.hpp>

namespace {

struct one : cca::space<cca::number, cca::axes<cca::x>> {};
struct measured : cca::array_of<one, 12> {};
struct moving : cca::array_of<one, 12> {};
struct wanted : cca::array_of<one, 12> {};
struct stiff : cca::array_of<one, 12> {};
struct shaken : cca::space<cca::number, cca::axes<cca::x, cca::y, cca::z>> {};

struct joints {
  measured::vector_type at = measured::vector_type::Zero();
  auto sense(cca::beat now)
      -> std::tuple<cca::out<"at", measured>, cca::out<"rates", moving>, cca::out<"trunk", shaken>> {
    return {at, moving::vector_type(0.1 * at), shaken::vector_type::Constant(now.dt())};
  }
  void act(cca::in<"to", wanted> to, cca::in<"stiffness", stiff> k) {
    at += 1e-3 * (to.vector() - at).cwiseProduct(k.vector());
  }
  void on_fault() {}
};
struct thinker {
  auto process(cca::in<"at", measured> at,
               cca::in<"rates", moving> rates,
               cca::in<"trunk", shaken> trunk,
               cca::beat now) -> std::tuple<cca::out<"to", wanted>, cca::out<"stiffness", stiff>> {
    const double swing = static_cast<double>(now.index() % 1000) * 1e-3 + trunk[cca::x{}];
    return {wanted::vector_type(swing - at.vector().array()), stiff::vector_type(rates.vector().array() + 1)};
  }
};

template <int N>
struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"joints", joints>,
                                 cca::node<"thinker", thinker>,
                                 cca::wire<"joints.at", "thinker.at", cca::delayed<N>>,
                                 cca::wire<"joints.rates", "thinker.rates", cca::delayed<N>>,
                                 cca::wire<"joints.trunk", "thinker.trunk", cca::delayed<N>>,
                                 cca::wire<"thinker.to", "joints.to", cca::delayed<N>>,
                                 cca::wire<"thinker.stiffness", "joints.stiffness", cca::delayed<N>>> {};
template <int N>
struct on_two_machines : cca::deployment<architecture<N>,
                                         cca::environment<"robot", cca::nodes<"joints">>,
                                         cca::environment<"mind", cca::other_nodes>,
                                         cca::tolerate<1'000'000>> {};

struct options {
  std::string machine;
  cca::dds::network by;
  double ms = 1;
  std::int64_t beats = 1000;
  double most_late = 100;  // %: with more it ends with 1
};

constexpr std::int64_t not_counted = 100;  // the first beats: what they need is touched for the first time

template <int N>
int run(const options& o) {
  cca::deployed<on_two_machines<N>> d(cca::only{o.machine.c_str()}, cca::dds::domain(9, "beats", o.by));
  d.load();
  d.start();
  if (o.machine == "mind") {
    d.run(cca::without_end{});  // at the pace of the robot
    return 0;
  }
  std::int64_t late = 0, in_a_row = 0, longest = 0, beats_late = 0;
  d.run(cca::for_some_beats{not_counted + o.beats}, cca::at_speed(1 / o.ms), [&](auto& running) {
    const bool is_late = running.late() > late && running.beat_index() > not_counted;
    late = running.late();
    in_a_row = is_late ? in_a_row + 1 : 0;
    beats_late += is_late;
    longest = std::max(longest, in_a_row);
  });
  std::printf("delayed<%d>, %g ms: %lld of %lld beats late, at most %lld in a row, %lld overruns\n", N, o.ms,
              static_cast<long long>(beats_late), static_cast<long long>(o.beats),
              static_cast<long long>(longest), static_cast<long long>(d.overruns()));
  d.stop();
  return 100.0 * static_cast<double>(beats_late) <= o.most_late * static_cast<double>(o.beats) ? 0 : 1;
}

template <int... N>
int run_delayed(const options& o, int delay, std::integer_sequence<int, N...>) {
  int code = 2;
  ((N + 1 == delay ? void(code = run<N + 1>(o)) : void()), ...);
  return code;
}

}  // namespace

int main(int count, char** words) {
  if (count < 7)
    return std::puts("cca_beats_over_cable robot|mind OWN OTHER DELAY MS BEATS [--loses] [--most-late %]"), 2;
  options o{words[1], cca::dds::network::between(words[2], {words[3]}), std::stod(words[5]),
            std::stoll(words[6])};
  for (int i = 7; i < count; ++i)
    if (const std::string_view word = words[i]; word == "--loses") o.by = o.by.that_loses();
    else if (word == "--most-late" && i + 1 < count) o.most_late = std::stod(words[++i]);
  return run_delayed(o, std::stoi(words[4]), std::make_integer_sequence<int, 5>());
}
