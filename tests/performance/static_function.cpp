// A component that calls a large static function which nothing else calls: in the beat the call is gone, as
// it would be in a loop by hand. On clang the function had two callers, `process` and the beat, and stayed.
#include <cmath>

#include <cca/graph/items/graph.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/space/domain.hpp>

namespace arm {

struct q0 : cca::dimension<"q0"> {};
struct q1 : cca::dimension<"q1"> {};
struct q2 : cca::dimension<"q2"> {};
struct q3 : cca::dimension<"q3"> {};
struct q4 : cca::dimension<"q4"> {};
struct q5 : cca::dimension<"q5"> {};
struct q6 : cca::dimension<"q6"> {};
struct q7 : cca::dimension<"q7"> {};
struct joint_space : cca::space<cca::number, cca::axes<q0, q1, q2, q3, q4, q5, q6, q7>> {};
using vector = joint_space::vector_type;

static vector shaped_by_a_large_function(const vector& x) {
  vector y;
  for (int i = 0; i < 8; ++i) {
    const double a = x[i] / (1 + std::abs(x[i])), b = a * a;
    y[i] = a * (1 + b * (-0.4 + b * (0.6 - 0.01 * b))) + 0.05 * (x[i] > 0.2 ? 1 - b : b);
  }
  return y;
}

struct source {
  vector state = vector::Ones();
  auto process(cca::beat) -> cca::out<"y", joint_space> {
    state *= 0.99;
    return state;
  }
};
struct shape {
  auto process(cca::in<"x", joint_space> x) -> cca::out<"y", joint_space> {
    return shaped_by_a_large_function(x.vector());
  }
};
struct filter {
  vector state = vector::Zero();
  auto process(cca::in<"x", joint_space> x) -> cca::out<"y", joint_space> {
    state += 0.25 * (x.vector() - state);
    return state;
  }
};

struct three : cca::graph<cca::rate<1000>,
                          cca::node<"source", source>,
                          cca::node<"shape", shape>,
                          cca::node<"filter", filter>,
                          cca::wire<"source.y", "shape.x">,
                          cca::wire<"shape.y", "filter.x">> {};

}  // namespace arm

bool beat(cca::controller<arm::three>& c) { return c.step(); }
