// A node after twelve that may fault. It runs in every beat: the compiler must not take it for cold code.
#include <cca/cca.hpp>

namespace {

struct value : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};

struct source {
  double at = 0;
  auto process() -> cca::out<"x", value> { return at += 0.5; }
};
struct careful {
  double last = 0;
  auto process(cca::in<"x", value> x) -> std::tuple<cca::out<"x", value>, cca::fault> {
    const bool jumped = x[cca::x{}] > last + 1;
    last = x[cca::x{}];
    return {last, jumped ? cca::fault{"it jumped"} : cca::fault{}};
  }
};
struct heavy {
  Eigen::Matrix<double, 64, 1> held = Eigen::Matrix<double, 64, 1>::Zero();
  void act(cca::in<"x", value> x) {
    for (int i = 0; i < 64; ++i) held[i] = held[i] * 0.5 + x[cca::x{}];
  }
};

struct twelve : cca::graph<cca::node<"s", source>,
                           cca::node<"a", careful>,
                           cca::node<"b", careful>,
                           cca::node<"c", careful>,
                           cca::node<"d", careful>,
                           cca::node<"e", careful>,
                           cca::node<"f", careful>,
                           cca::node<"g", careful>,
                           cca::node<"h", careful>,
                           cca::node<"i", careful>,
                           cca::node<"j", careful>,
                           cca::node<"k", careful>,
                           cca::node<"l", careful>,
                           cca::node<"end", heavy>,
                           cca::wire<"s.x", "a.x">,
                           cca::wire<"a.x", "b.x">,
                           cca::wire<"b.x", "c.x">,
                           cca::wire<"c.x", "d.x">,
                           cca::wire<"d.x", "e.x">,
                           cca::wire<"e.x", "f.x">,
                           cca::wire<"f.x", "g.x">,
                           cca::wire<"g.x", "h.x">,
                           cca::wire<"h.x", "i.x">,
                           cca::wire<"i.x", "j.x">,
                           cca::wire<"j.x", "k.x">,
                           cca::wire<"k.x", "l.x">,
                           cca::wire<"l.x", "end.x">> {};

}  // namespace

bool beat(void* c) { return static_cast<cca::controller<twelve>*>(c)->step(); }
