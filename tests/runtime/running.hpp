// How tests begin, and what they are refused.
#pragma once

#include <string>

#include <cca/base/refused.hpp>

namespace test {

// A controller or a deployment, loaded and started.
template <class Played>
Played running() {
  Played c;
  c.load();
  c.start();
  return c;
}

// The sentence with which a call is refused.
std::string refusal(auto f) {
  try {
    f();
  } catch (const cca::refused& e) { return e.what(); }
  return "nothing";
}

}  // namespace test
