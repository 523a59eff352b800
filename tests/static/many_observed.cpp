// An observer that hears more ports than clang folds (256), in a component and from outside.
#include <cca/cca.hpp>

namespace {

struct number : cca::space<cca::number, cca::axes<cca::x>> {};

struct ten {
  using one = number;
  auto process(cca::beat now) -> std::tuple<cca::out<"a", one>,
                                            cca::out<"b", one>,
                                            cca::out<"c", one>,
                                            cca::out<"d", one>,
                                            cca::out<"e", one>,
                                            cca::out<"f", one>,
                                            cca::out<"g", one>,
                                            cca::out<"h", one>,
                                            cca::out<"i", one>,
                                            cca::out<"j", one>> {
    const double v = now.dt();
    return {v, v, v, v, v, v, v, v, v, v};
  }
};
struct fifty : cca::graph<cca::node<"a", ten>,
                          cca::node<"b", ten>,
                          cca::node<"c", ten>,
                          cca::node<"d", ten>,
                          cca::node<"e", ten>> {};
struct listener {
  void process(cca::observe<"many.**"> all) {
    for (const cca::observation& one : all) sum += one.values[0];
  }
  double sum = 0;
};
struct many : cca::graph<cca::node<"a", fifty>,
                         cca::node<"b", fifty>,
                         cca::node<"c", fifty>,
                         cca::node<"d", fifty>,
                         cca::node<"e", fifty>,
                         cca::node<"f", fifty>> {};
struct observed : cca::graph<cca::rate<1000>,
                             cca::node<"many", many>,
                             cca::node<"listener", listener>,
                             cca::observe<"**">> {};

}  // namespace

double observed_sum() {
  cca::controller<observed> c;
  c.load();
  c.start();
  c.step();
  double sum = c.get<"listener">().sum;
  c.observed([&](const cca::observation& one) { sum += one.values[0]; });
  return sum;
}
