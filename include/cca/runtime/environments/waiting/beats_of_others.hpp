// How a fast run waits for the other environments. `Loop` is its loop.
#pragma once

#include <cca/runtime/environments/waiting/patience.hpp>

namespace cca::detail {

template <class Loop>
class beats_of_others {
protected:
  // False: a fault or the end has come before it. `meanwhile()`: every few milliseconds, so that what is
  // asked of it in a pause is done.
  template <class Meanwhile>
  bool wait_until_it_may_begin(Meanwhile meanwhile) noexcept(noexcept(meanwhile())) {
    for (learned_patience patience = loop().state.be_patient();; patience.wait()) {
      const bool may_begin = loop().state.may_begin(loop().k);
      auto& shared = loop().shared();
      if (shared.fault_position() < loop().position() || shared.stop_at() <= loop().k) return false;
      if (may_begin) return true;
      if (!patience.is_time_to_ask()) continue;
      loop().state.look_for_missing(loop().k, loop().position() - 1);
      meanwhile();
    }
  }

  // Waits until all others have done the beats before k. False: one of them faulted or stopped.
  bool all_have_come() noexcept {
    for (learned_patience patience = loop().state.be_patient(); loop().goes_on(); patience.wait()) {
      if (loop().state.all_have_come_to(loop().position())) return true;
      if (patience.is_time_to_ask()) loop().state.look_for_those_before(loop().position());
    }
    return false;
  }

private:
  Loop& loop() { return static_cast<Loop&>(*this); }
};

}  // namespace cca::detail
