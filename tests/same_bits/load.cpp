// Prints what load() of a controller says of this build.
#include <cstdio>

#include <cca/cca.hpp>

struct number : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};
struct source {
  auto process(cca::beat) -> cca::out<"y", number> { return 1.0; }
};
struct one : cca::graph<cca::node<"source", source>> {};

int main() {
  try {
    cca::controller<one>().load();
  } catch (const cca::refused& problem) {
    std::puts(problem.what());
    return 1;
  }
  std::puts("it has the bits that it has everywhere");
}
