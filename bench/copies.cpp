// Samples of eight axes through 22 nodes, eight of them of a single axis between a splitter and a collector:
// what it costs that components hand over whole samples.
//
//   copies <style> <what program.hpp takes>     filled: components fill their output in place; returned: they
//                                               return a vector; expressions: they return Eigen expressions
//
// The loop by hand is written with arrays and loops over the axes, that beside `expressions` with Eigen.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "program.hpp"

namespace bench {

inline constexpr int axis_count = 8;
struct q0 : cca::dimension<"q0"> {};
struct q1 : cca::dimension<"q1"> {};
struct q2 : cca::dimension<"q2"> {};
struct q3 : cca::dimension<"q3"> {};
struct q4 : cca::dimension<"q4"> {};
struct q5 : cca::dimension<"q5"> {};
struct q6 : cca::dimension<"q6"> {};
struct q7 : cca::dimension<"q7"> {};
struct joints : cca::space<cca::number, cca::axes<q0, q1, q2, q3, q4, q5, q6, q7>> {};
using vector8 = joints::vector_type;
using array8 = std::array<double, axis_count>;

enum class style { filled, returned, expressions };

// y[i] = f(i) for each axis, in the style.
template <style Style, class F>
  requires(Style == style::filled)
cca::out<"y", joints> made_of(F f) {
  cca::out<"y", joints> y;
  for (int i = 0; i < axis_count; ++i) y.vector()[i] = f(i);
  return y;
}
template <style Style, class F>
  requires(Style == style::returned)
cca::out<"y", joints> made_of(F f) {
  vector8 y;
  for (int i = 0; i < axis_count; ++i) y[i] = f(i);
  return y;
}

template <style Style>
struct plant {
  vector8 at = vector8::Zero(), speed = vector8::Zero();
  auto sense() -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) return at;
    else return made_of<Style>([&](int i) { return at[i]; });
  }
  void act(cca::in<"x", joints> x) {
    if constexpr (Style == style::expressions) {
      speed += 0.001 * (x.vector() - 0.5 * speed);
      at += 0.001 * speed;
    } else {
      for (int i = 0; i < axis_count; ++i) {
        speed[i] += 0.001 * (x.vector()[i] - 0.5 * speed[i]);
        at[i] += 0.001 * speed[i];
      }
    }
  }
};

template <style Style>
struct ramp {
  vector8 value = vector8::LinSpaced(axis_count, 0.1, 0.8);
  auto process(cca::beat) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) {
      value.array() += 0.001;
      return value;
    } else {
      return made_of<Style>([&](int i) { return value[i] += 0.001; });
    }
  }
};

template <style Style, int Percent>
struct low_pass {
  static constexpr double gain = Percent / 100.0;
  vector8 state = vector8::Zero();
  auto process(cca::in<"x", joints> x) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) {
      state += gain * (x.vector() - state);
      return state;
    } else {
      return made_of<Style>([&](int i) { return state[i] += gain * (x.vector()[i] - state[i]); });
    }
  }
};

template <style Style>
struct change {
  vector8 last = vector8::Zero();
  auto process(cca::in<"x", joints> x) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) {
      const vector8 d = 1000.0 * (x.vector() - last);
      last = x.vector();
      return d;
    } else {
      return made_of<Style>([&](int i) {
        const double d = 1000.0 * (x.vector()[i] - last[i]);
        last[i] = x.vector()[i];
        return d;
      });
    }
  }
};

template <style Style>
struct difference {
  auto process(cca::in<"a", joints> a, cca::in<"b", joints> b) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) return a.vector() - b.vector();
    else return made_of<Style>([&](int i) { return a.vector()[i] - b.vector()[i]; });
  }
};

template <style Style>
struct sum {
  auto process(cca::in<"a", joints> a, cca::in<"b", joints> b) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) return a.vector() + b.vector();
    else return made_of<Style>([&](int i) { return a.vector()[i] + b.vector()[i]; });
  }
};

template <style Style, int Percent>
struct times {
  static constexpr double gain = Percent / 100.0;
  auto process(cca::in<"x", joints> x) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) return gain * x.vector();
    else return made_of<Style>([&](int i) { return gain * x.vector()[i]; });
  }
};

template <style Style>
struct integral {
  vector8 state = vector8::Zero();
  auto process(cca::in<"x", joints> x) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) {
      state = (state + 0.001 * x.vector()).cwiseMin(0.5).cwiseMax(-0.5);
      return state;
    } else {
      return made_of<Style>(
          [&](int i) { return state[i] = std::max(std::min(state[i] + 0.001 * x.vector()[i], 0.5), -0.5); });
    }
  }
};

template <style Style>
struct clamp {
  auto process(cca::in<"x", joints> x) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) return x.vector().cwiseMin(6.0).cwiseMax(-6.0);
    else return made_of<Style>([&](int i) { return std::max(std::min(x.vector()[i], 6.0), -6.0); });
  }
};

// One axis: a filter and a friction that follows its speed.
template <class Axis>
struct one_axis {
  using space = cca::sub_space<joints, Axis>;
  double state = 0;
  auto process(cca::in<"x", space> x) -> cca::out<"y", space> {
    const double old = state;
    state += 0.3 * (x[Axis{}] - state);
    return state + 0.05 * (state - old);
  }
};

template <style Style>
struct joint_control : cca::graph<cca::rate<1000>,
                                  cca::node<"plant", plant<Style>>,
                                  cca::node<"smooth", low_pass<Style, 25>>,
                                  cca::node<"speed", change<Style>>,
                                  cca::node<"goal", ramp<Style>>,
                                  cca::node<"shaped", low_pass<Style, 10>>,
                                  cca::node<"error", difference<Style>>,
                                  cca::node<"stiff", times<Style, 4000>>,
                                  cca::node<"steady", integral<Style>>,
                                  cca::node<"damping", times<Style, -20>>,
                                  cca::node<"wanted", sum<Style>>,
                                  cca::node<"damped", sum<Style>>,
                                  cca::node<"split", cca::splitter<"x", joints>>,
                                  cca::node<"a0", one_axis<q0>>,
                                  cca::node<"a1", one_axis<q1>>,
                                  cca::node<"a2", one_axis<q2>>,
                                  cca::node<"a3", one_axis<q3>>,
                                  cca::node<"a4", one_axis<q4>>,
                                  cca::node<"a5", one_axis<q5>>,
                                  cca::node<"a6", one_axis<q6>>,
                                  cca::node<"a7", one_axis<q7>>,
                                  cca::node<"join", cca::collector<"y", joints>, cca::moderate>,
                                  cca::node<"safe", clamp<Style>>,
                                  cca::wire<"plant.y", "smooth.x">,
                                  cca::wire<"plant.y", "speed.x">,
                                  cca::wire<"goal.y", "shaped.x">,
                                  cca::wire<"shaped.y", "error.a">,
                                  cca::wire<"smooth.y", "error.b">,
                                  cca::wire<"error.y", "stiff.x">,
                                  cca::wire<"error.y", "steady.x">,
                                  cca::wire<"speed.y", "damping.x">,
                                  cca::wire<"stiff.y", "wanted.a">,
                                  cca::wire<"steady.y", "wanted.b">,
                                  cca::wire<"wanted.y", "damped.a">,
                                  cca::wire<"damping.y", "damped.b">,
                                  cca::wire<"damped.y", "split.x">,
                                  cca::wire<"split.q0", "a0.x">,
                                  cca::wire<"split.q1", "a1.x">,
                                  cca::wire<"split.q2", "a2.x">,
                                  cca::wire<"split.q3", "a3.x">,
                                  cca::wire<"split.q4", "a4.x">,
                                  cca::wire<"split.q5", "a5.x">,
                                  cca::wire<"split.q6", "a6.x">,
                                  cca::wire<"split.q7", "a7.x">,
                                  cca::wire<"a0.y", "join.q0">,
                                  cca::wire<"a1.y", "join.q1">,
                                  cca::wire<"a2.y", "join.q2">,
                                  cca::wire<"a3.y", "join.q3">,
                                  cca::wire<"a4.y", "join.q4">,
                                  cca::wire<"a5.y", "join.q5">,
                                  cca::wire<"a6.y", "join.q6">,
                                  cca::wire<"a7.y", "join.q7">,
                                  cca::wire<"join.y", "safe.x">,
                                  cca::wire<"safe.y", "plant.x">> {};

struct look_at_plant {
  vector8 operator()(const auto& controller) const { return controller.template get<"plant">().at; }
};
template <style Style>
using graph = as_graph<joint_control<Style>, look_at_plant>;

// The same by hand: a function after the other on arrays, each a loop over the axes.
struct by_hand {
  static constexpr const char* name = "by_hand";
  array8 at{}, speed{}, smooth{}, last{}, goal, shaped{}, steady{}, filtered{};
  by_hand() {
    const vector8 first = vector8::LinSpaced(axis_count, 0.1, 0.8);
    for (std::size_t i = 0; i < axis_count; ++i) goal[i] = first[static_cast<int>(i)];
  }

  template <class F>
  static void each(F f) {
    for (std::size_t i = 0; i < axis_count; ++i) f(i);
  }

  void step() {
    array8 change, error, stiff, damping, wanted, damped, safe;
    each([&](std::size_t i) { smooth[i] += 0.25 * (at[i] - smooth[i]); });
    each([&](std::size_t i) {
      change[i] = 1000.0 * (at[i] - last[i]);
      last[i] = at[i];
    });
    each([&](std::size_t i) { goal[i] += 0.001; });
    each([&](std::size_t i) { shaped[i] += 0.1 * (goal[i] - shaped[i]); });
    each([&](std::size_t i) { error[i] = shaped[i] - smooth[i]; });
    each([&](std::size_t i) { stiff[i] = 40.0 * error[i]; });
    each([&](std::size_t i) { steady[i] = std::max(std::min(steady[i] + 0.001 * error[i], 0.5), -0.5); });
    each([&](std::size_t i) { damping[i] = -0.2 * change[i]; });
    each([&](std::size_t i) { wanted[i] = stiff[i] + steady[i]; });
    each([&](std::size_t i) { damped[i] = wanted[i] + damping[i]; });
    each([&](std::size_t i) {
      const double old = filtered[i];
      filtered[i] += 0.3 * (damped[i] - filtered[i]);
      safe[i] = filtered[i] + 0.05 * (filtered[i] - old);
    });
    each([&](std::size_t i) { safe[i] = std::max(std::min(safe[i], 6.0), -6.0); });
    each([&](std::size_t i) {
      speed[i] += 0.001 * (safe[i] - 0.5 * speed[i]);
      at[i] += 0.001 * speed[i];
    });
  }
  vector8 result() const { return Eigen::Map<const vector8>(at.data()); }
};

// The same by hand with Eigen.
struct by_hand_eigen {
  static constexpr const char* name = "by_hand";
  vector8 at = vector8::Zero(), speed = at, smooth = at, last = at, shaped = at, steady = at, filtered = at;
  vector8 goal = vector8::LinSpaced(axis_count, 0.1, 0.8);

  void step() {
    smooth += 0.25 * (at - smooth);
    const vector8 change = 1000.0 * (at - last);
    last = at;
    goal.array() += 0.001;
    shaped += 0.1 * (goal - shaped);
    const vector8 error = shaped - smooth;
    const vector8 stiff = 40.0 * error;
    steady = (steady + 0.001 * error).cwiseMin(0.5).cwiseMax(-0.5);
    const vector8 damping = -0.2 * change;
    const vector8 wanted = stiff + steady;
    const vector8 damped = wanted + damping;
    const vector8 old = filtered;
    filtered += 0.3 * (damped - filtered);
    vector8 safe = filtered + 0.05 * (filtered - old);
    safe = safe.cwiseMin(6.0).cwiseMax(-6.0).eval();
    speed += 0.001 * (safe - 0.5 * speed);
    at += 0.001 * speed;
  }
  vector8 result() const { return at; }
};

}  // namespace bench

int main(int argc, char** argv) {
  using namespace bench;
  const std::string_view name = argc > 1 ? argv[1] : "";
  if (name == "filled") return program<graph<style::filled>, by_hand>(argc - 1, argv + 1);
  if (name == "returned") return program<graph<style::returned>, by_hand>(argc - 1, argv + 1);
  if (name == "expressions") return program<graph<style::expressions>, by_hand_eigen>(argc - 1, argv + 1);
  return 2;
}
