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

// The joints: encoders that count from somewhere else, and motors.
inline constexpr double resolution = 0.002, zero = 50;

template <style Style>
struct plant {
  vector8 counts = vector8::Constant(zero), speed = vector8::Zero();
  auto sense() -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) return resolution * (counts.array() - zero).matrix();
    else return made_of<Style>([&](int i) { return resolution * (counts[i] - zero); });
  }
  void act(cca::in<"x", joints> x) {
    if constexpr (Style == style::expressions) {
      speed += 0.001 * (x.vector() - 0.5 * speed);
      counts += 0.5 * speed;
    } else {
      for (int i = 0; i < axis_count; ++i) {
        speed[i] += 0.001 * (x.vector()[i] - 0.5 * speed[i]);
        counts[i] += 0.5 * speed[i];
      }
    }
  }
};

// A swing of each axis: a pair that turns, and is kept at length 1.
inline constexpr double turn_cos = 0.99998, turn_sin = 0.0063245;

template <style Style>
struct swing {
  vector8 c = vector8::LinSpaced(axis_count, 0.1, 0.8), s = vector8::Constant(0.6);
  auto process(cca::beat) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) {
      const vector8 a = turn_cos * c - turn_sin * s, b = turn_sin * c + turn_cos * s;
      const vector8 grow = (1.5 - 0.5 * (a.array() * a.array() + b.array() * b.array())).matrix();
      c = a.cwiseProduct(grow);
      s = b.cwiseProduct(grow);
      return (0.2 + 0.4 * s.array()).matrix();
    } else {
      return made_of<Style>([&](int i) {
        const double a = turn_cos * c[i] - turn_sin * s[i], b = turn_sin * c[i] + turn_cos * s[i];
        const double grow = 1.5 - 0.5 * (a * a + b * b);
        c[i] = a * grow;
        s[i] = b * grow;
        return 0.2 + 0.4 * s[i];
      });
    }
  }
};

// A filter of second order.
struct coefficients {
  double b0, b1, b2, a1, a2;
};
inline constexpr coefficients fast{0.29, 0.58, 0.29, -0.01, 0.17}, slow{0.067, 0.135, 0.067, -1.143, 0.413};

template <style Style, coefficients C>
struct low_pass {
  vector8 s1 = vector8::Zero(), s2 = vector8::Zero();
  auto process(cca::in<"x", joints> x) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) {
      const vector8 y = C.b0 * x.vector() + s1;
      s1 = C.b1 * x.vector() - C.a1 * y + s2;
      s2 = C.b2 * x.vector() - C.a2 * y;
      return y;
    } else {
      return made_of<Style>([&](int i) {
        const double y = C.b0 * x.vector()[i] + s1[i];
        s1[i] = C.b1 * x.vector()[i] - C.a1 * y + s2[i];
        s2[i] = C.b2 * x.vector()[i] - C.a2 * y;
        return y;
      });
    }
  }
};

template <style Style>
struct change {
  vector8 last = vector8::Zero(), state = vector8::Zero();
  auto process(cca::in<"x", joints> x) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) {
      state += 0.2 * (1000.0 * (x.vector() - last) - state);
      last = x.vector();
      return state;
    } else {
      return made_of<Style>([&](int i) {
        state[i] += 0.2 * (1000.0 * (x.vector()[i] - last[i]) - state[i]);
        last[i] = x.vector()[i];
        return state[i];
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

// A spring that hardens, and a damper with dry friction.
template <style Style>
struct spring {
  auto process(cca::in<"x", joints> x) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) {
      return (x.vector().array() * (40.0 + 25.0 * (x.vector().array() * x.vector().array()))).matrix();
    } else {
      return made_of<Style>([&](int i) {
        const double e = x.vector()[i];
        return e * (40.0 + 25.0 * (e * e));
      });
    }
  }
};

template <style Style>
struct damper {
  auto process(cca::in<"x", joints> x) -> cca::out<"y", joints> {
    if constexpr (Style == style::expressions) {
      return (x.vector().array() * -0.2 - x.vector().array() / (10.0 + 8.0 * x.vector().array().abs()))
          .matrix();
    } else {
      return made_of<Style>([&](int i) {
        const double v = x.vector()[i];
        return v * -0.2 - v / (10.0 + 8.0 * std::abs(v));
      });
    }
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
                                  cca::node<"smooth", low_pass<Style, fast>>,
                                  cca::node<"speed", change<Style>>,
                                  cca::node<"goal", swing<Style>>,
                                  cca::node<"shaped", low_pass<Style, slow>>,
                                  cca::node<"error", difference<Style>>,
                                  cca::node<"stiff", spring<Style>>,
                                  cca::node<"steady", integral<Style>>,
                                  cca::node<"damping", damper<Style>>,
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
  vector8 operator()(const auto& controller) const { return controller.template get<"plant">().counts; }
};
template <style Style>
using graph = as_graph<joint_control<Style>, look_at_plant>;

// The same by hand: a function after the other on arrays, each a loop over the axes.
struct by_hand {
  static constexpr const char* name = "by_hand";
  array8 counts, speed{}, smooth1{}, smooth2{}, last{}, changed{}, c, s, shaped1{}, shaped2{}, steady{},
      filtered{};
  by_hand() {
    const vector8 first = vector8::LinSpaced(axis_count, 0.1, 0.8);
    for (std::size_t i = 0; i < axis_count; ++i) c[i] = first[static_cast<int>(i)];
    s.fill(0.6);
    counts.fill(zero);
  }

  template <class F>
  static void each(F f) {
    for (std::size_t i = 0; i < axis_count; ++i) f(i);
  }
  static void low_pass(const coefficients& k, const array8& x, array8& s1, array8& s2, array8& y) {
    each([&](std::size_t i) {
      y[i] = k.b0 * x[i] + s1[i];
      s1[i] = k.b1 * x[i] - k.a1 * y[i] + s2[i];
      s2[i] = k.b2 * x[i] - k.a2 * y[i];
    });
  }

  void step() {
    array8 at, smooth, goal, shaped, error, stiff, damping, wanted, damped, safe;
    each([&](std::size_t i) { at[i] = resolution * (counts[i] - zero); });
    low_pass(fast, at, smooth1, smooth2, smooth);
    each([&](std::size_t i) {
      changed[i] += 0.2 * (1000.0 * (at[i] - last[i]) - changed[i]);
      last[i] = at[i];
    });
    each([&](std::size_t i) {
      const double a = turn_cos * c[i] - turn_sin * s[i], b = turn_sin * c[i] + turn_cos * s[i];
      const double grow = 1.5 - 0.5 * (a * a + b * b);
      c[i] = a * grow;
      s[i] = b * grow;
      goal[i] = 0.2 + 0.4 * s[i];
    });
    low_pass(slow, goal, shaped1, shaped2, shaped);
    each([&](std::size_t i) { error[i] = shaped[i] - smooth[i]; });
    each([&](std::size_t i) { stiff[i] = error[i] * (40.0 + 25.0 * (error[i] * error[i])); });
    each([&](std::size_t i) { steady[i] = std::max(std::min(steady[i] + 0.001 * error[i], 0.5), -0.5); });
    each([&](std::size_t i) {
      damping[i] = changed[i] * -0.2 - changed[i] / (10.0 + 8.0 * std::abs(changed[i]));
    });
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
      counts[i] += 0.5 * speed[i];
    });
  }
  vector8 result() const { return Eigen::Map<const vector8>(counts.data()); }
};

// The same by hand with Eigen.
struct by_hand_eigen {
  static constexpr const char* name = "by_hand";
  vector8 counts = vector8::Constant(zero), speed = vector8::Zero(), smooth1 = speed, smooth2 = speed,
          last = speed, changed = speed, shaped1 = speed, shaped2 = speed, steady = speed, filtered = speed;
  vector8 c = vector8::LinSpaced(axis_count, 0.1, 0.8), s = vector8::Constant(0.6);

  static vector8 low_pass(const coefficients& k, const vector8& x, vector8& s1, vector8& s2) {
    const vector8 y = k.b0 * x + s1;
    s1 = k.b1 * x - k.a1 * y + s2;
    s2 = k.b2 * x - k.a2 * y;
    return y;
  }

  void step() {
    const vector8 at = resolution * (counts.array() - zero).matrix();
    const vector8 smooth = low_pass(fast, at, smooth1, smooth2);
    changed += 0.2 * (1000.0 * (at - last) - changed);
    last = at;
    const vector8 a = turn_cos * c - turn_sin * s, b = turn_sin * c + turn_cos * s;
    const vector8 grow = (1.5 - 0.5 * (a.array() * a.array() + b.array() * b.array())).matrix();
    c = a.cwiseProduct(grow);
    s = b.cwiseProduct(grow);
    const vector8 goal = (0.2 + 0.4 * s.array()).matrix();
    const vector8 shaped = low_pass(slow, goal, shaped1, shaped2);
    const vector8 error = shaped - smooth;
    const vector8 stiff = (error.array() * (40.0 + 25.0 * (error.array() * error.array()))).matrix();
    steady = (steady + 0.001 * error).cwiseMin(0.5).cwiseMax(-0.5);
    const vector8 damping =
        (changed.array() * -0.2 - changed.array() / (10.0 + 8.0 * changed.array().abs())).matrix();
    const vector8 wanted = stiff + steady;
    const vector8 damped = wanted + damping;
    const vector8 old = filtered;
    filtered += 0.3 * (damped - filtered);
    vector8 safe = filtered + 0.05 * (filtered - old);
    safe = safe.cwiseMin(6.0).cwiseMax(-6.0).eval();
    speed += 0.001 * (safe - 0.5 * speed);
    counts += 0.5 * speed;
  }
  vector8 result() const { return counts; }
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
