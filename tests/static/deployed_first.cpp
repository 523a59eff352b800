// <cca/runtime/environments/deployed.hpp>, and so <cca/main.hpp>, may be the first header of a file: what a
// loop with free-running environments calls is declared before the loop.
#include <cca/runtime/environments/deployed.hpp>

#include <cca/cca.hpp>

namespace deployed_first {

struct light : cca::space<cca::number, cca::axes<cca::x>> {};
struct device {
  auto process(cca::beat) -> cca::out<"light", light> { return 1; }
};
struct eye {
  auto process(cca::in<"light", light> x) -> cca::out<"seen", light> { return x; }
};
struct reflex {
  void process(cca::in<"seen", light>) {}
};

struct seeing : cca::graph<cca::rate<1000>,
                           cca::node<"device", device>,
                           cca::node<"eye", eye, cca::full_speed>,
                           cca::node<"reflex", reflex>,
                           cca::wire<"device.light", "eye.light">,
                           cca::wire<"eye.seen", "reflex.seen">> {};
struct split : cca::deployment<seeing,
                               cca::environment<"robot", cca::other_nodes>,
                               cca::environment<"eye", cca::nodes<"eye">, cca::free_running>>,
               cca::recordable {};

void run(cca::deployed<split>& d) { d.run(cca::for_<1>{}, cca::at_wall_clock()); }

}  // namespace deployed_first
