// The extended life-cycle of a training, as a table: which change is legal in which state, and where it
// leads.
#pragma once

#include <array>
#include <cstdint>

#include <cca/adaptive/module_status.hpp>

namespace cca::detail {

enum class learning_change : std::uint8_t { collect, learn, begin_batch, hand_over, rest, forget };

struct learning_transition {
  learning_change what;
  learning from, to;
};

// `rest` leads to trained, or to idle if nothing was learned.
inline constexpr std::array learning_transitions{
    learning_transition{learning_change::collect, learning::idle, learning::collecting},
    learning_transition{learning_change::collect, learning::trained, learning::collecting},
    learning_transition{learning_change::learn, learning::idle, learning::online},
    learning_transition{learning_change::learn, learning::trained, learning::online},
    // A batch from idle uses the examples that were collected before.
    learning_transition{learning_change::begin_batch, learning::idle, learning::batch},
    learning_transition{learning_change::begin_batch, learning::trained, learning::batch},
    learning_transition{learning_change::begin_batch, learning::collecting, learning::batch},
    learning_transition{learning_change::hand_over, learning::batch, learning::trained},
    learning_transition{learning_change::hand_over, learning::idle, learning::trained},
    learning_transition{learning_change::hand_over, learning::trained, learning::trained},
    learning_transition{learning_change::rest, learning::collecting, learning::trained},
    learning_transition{learning_change::rest, learning::online, learning::trained},
    // Gives up a batch, without its result.
    learning_transition{learning_change::rest, learning::batch, learning::trained},
    learning_transition{learning_change::forget, learning::idle, learning::idle},
    learning_transition{learning_change::forget, learning::trained, learning::idle},
};

constexpr bool is_legal(learning_change what, learning from) {
  for (const auto& one : learning_transitions)
    if (one.what == what && one.from == from) return true;
  return false;
}

}  // namespace cca::detail
