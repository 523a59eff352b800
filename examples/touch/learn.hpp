#pragma once
// What the arm learns between two beats, where the plan says so.
#include "architecture.hpp"

namespace touch {

// Learns what was shown; between two beats.
template <class Controller>
void learn(Controller& c) {
  auto& module = c.template get<"repeat.module">();
  const auto movement = c.template get<"recorder">().movement();
  module.learning.collect();
  module.demonstrate(movement, recorder::interval);
  module.p.duration = recorder::interval * static_cast<double>(movement.size() - 1);
  module.learning.hand_over(module.learning.begin_batch(module.p.settings)());
}

}  // namespace touch
