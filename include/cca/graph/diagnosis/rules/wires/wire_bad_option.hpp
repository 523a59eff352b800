// wire.bad_option: a wire has at most one initial value, and one policy, or a delay and a queue.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct wire_bad_option {
  static constexpr std::string_view id = "wire.bad_option";

  static constexpr bool is_broken(when::wire_options, const flat_view&, const finding& f) {
    return !f.item->unknown_type.empty() || f.item->repeats_option ||
           f.item->too_small != policy_kind::unstated;
  }

  static constexpr void tell(auto& m) {
    const auto& item = m.item();
    m.at_wire();
    m.say() << "the wire ";
    m.wire();
    if (item.too_small == policy_kind::delayed)
      m.say() << " has a delay of " << item.delay << ": write at least 1, or cca::latest instead";
    else if (item.too_small != policy_kind::unstated)
      m.say() << " has a queue of " << item.capacity << ": write at least 1, or cca::latest instead";
    else if (item.full == full_kind::unknown)
      m.say() << " has a queue with `" << item.unknown_type
              << "`, which does not say what a full queue loses: write cca::drop_oldest, cca::drop_newest or "
                 "cca::reject";
    else if (item.unknown_type.empty())
      m.say() << " has two policies or two initial values: leave one of each (only a cca::delayed may stand "
                 "beside a cca::queue or a cca::merged)";
    else
      m.say() << " has the option `" << item.unknown_type
              << "`, which is no option of a wire: it may have a policy (cca::latest, cca::delayed<N>, "
                 "cca::queue<C, F>, cca::merged<C, F>) and a cca::initial<...>";
  }
};

}  // namespace cca::detail
