// The observations of the last beats, as a network sees them.
//
//   observation_history<Contract> h;
//   h.add(frame);       the numbers of all terms of this beat, one term after the other
//   h.numbers()         what the network sees: Contract::history frames, in the contract's layout and order
//
//   history 3 of the terms a, b     oldest first            newest first
//   by_term                         a1 a2 a3 b1 b2 b3       a3 a2 a1 b3 b2 b1
//   by_time                         a1 b1 a2 b2 a3 b3       a3 b3 a2 b2 a1 b1
//
// Cost: moves the numbers of history - 1 beats; without a history nothing.
#pragma once

#include <algorithm>
#include <array>

#include <cca/mapping/imported/policy_contract.hpp>
#include <cca/mapping/network/activations.hpp>

namespace cca::detail {

template <class... Terms>
constexpr auto sizes_of(policy_terms<Terms...>) {
  return std::array<int, sizeof...(Terms)>{size_of_term<Terms>...};
}

template <class Contract>
class observation_history {
public:
  using number = typename Contract::number;
  static constexpr int frame = numbers_of_terms(typename Contract::terms{});
  static constexpr int length = Contract::history;
  static constexpr int size = frame * length;

  void clear() { begun = false; }

  // As if `now` had been observed all the time.
  void fill(const neural::numbers<number, frame>& now) {
    begun = true;
    for (int i = 0; i < length; ++i) add(now);
  }
  void add(const neural::numbers<number, frame>& now) {
    const bool fills = !begun;
    if (fills) seen.setZero();
    begun = true;
    if constexpr (Contract::layout == history_layout::by_time) {
      add_block(0, frame, now.data(), fills);
    } else {
      constexpr auto sizes = sizes_of(typename Contract::terms{});
      int at = 0;
      for (const int one : sizes) {
        add_block(at * length, one, now.data() + at, fills);
        at += one;
      }
    }
  }
  const neural::numbers<number, size>& numbers() const { return seen; }

private:
  void add_block(int at, int width, const number* now, bool fills) {
    number* const first = seen.data() + at;
    number* const end = first + width * length;
    if (fills && Contract::start == history_start::repeated) {
      for (number* to = first; to != end; to += width) std::copy_n(now, width, to);
    } else if constexpr (Contract::order == history_order::oldest_first) {
      std::copy(first + width, end, first);
      std::copy_n(now, width, end - width);
    } else {
      std::copy_backward(first, end - width, end);
      std::copy_n(now, width, first);
    }
  }

  neural::numbers<number, size> seen = neural::numbers<number, size>::Zero();
  bool begun = false;
};

}  // namespace cca::detail
