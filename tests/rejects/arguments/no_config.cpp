// EXPECT loads: cca::controller: load\(file\) needs #include <cca/config\.hpp>
// EXPECT loads_one: cca::controller: load\(path, file\) needs #include <cca/config\.hpp>
// EXPECT saves: cca::controller: save\(path, file\) needs #include <cca/config\.hpp>
// EXPECT sets: cca::controller: set\(path, value\) needs #include <cca/config\.hpp>
// EXPECT asks: cca::controller: parameter\(path\) needs #include <cca/config\.hpp>
// EXPECT asks_live: cca::live_access: parameter\(path\) needs #include <cca/config\.hpp>
// LINES: 12
// What a program does with files and paths that does not include <cca/config.hpp>.
#include <cca/cca.hpp>
#include <cca/runtime/live/live_access.hpp>

#include "../parts.hpp"
#include "late.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"stance", stance>> {};

namespace broken {

using walking = cca::controller<walk>;
template <class T>
auto loads(T& c) {
  c.load("walk.toml");
}
template <class T>
auto loads_one(T& c) {
  c.load("stance", "walk.toml");
}
template <class T>
auto saves(T& c) {
  c.save("stance", "walk.toml");
}
template <class T>
auto sets(T& c) {
  c.set("stance.height", 0.2);
}
template <class T>
auto asks(T& c) {
  return c.template parameter<double>("stance.height");
}
template <class T>
auto asks_live(T& c) {
  return cca::live_access(c).parameter("stance.height");
}
template <class T>
auto none(T& c) {
  c.load();
}

}  // namespace broken

#ifndef CCA_REJECT
#define CCA_REJECT none
#endif
void run(broken::walking& c) { broken::CCA_REJECT(c); }
