// queue.overflow: a queue that rejects can never be full.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct queue_overflow {
  static constexpr std::string_view id = "queue.overflow";

  static constexpr bool is_broken(when::clocked_wire, const flat_view& g, const finding& f) {
    return f.item->policy == policy_kind::queue && f.item->full == full_kind::reject &&
           overflows(published(g, g.outputs[f.output]), g.calls[g.inputs[f.input].call].fires,
                     f.item->number);
  }

  static constexpr void tell(auto& m) {
    m.at_wire();
    const auto& out = m.g.outputs[m.found().output];
    const auto& in = m.g.inputs[m.found().input];
    const auto from = published(m.g, out), to = m.g.calls[in.call].fires;
    m.two_clocks(out, in);
    m.say() << ", so the queue of " << m.item().number
            << " between them is full sooner or later, which cca::reject forbids: read "
            << (to.never() || from.period < to.period ? "faster" : "sooner")
            << ", or say what is lost: cca::drop_oldest or cca::drop_newest";
  }

private:
  // Samples arrive faster than they are read, or fill the queue before the first of them is read.
  static constexpr bool overflows(clock from, clock to, std::int64_t room) {
    if (!from.known() || to.dynamic()) return false;
    return to.never() || from.period < to.period || from.first + room * from.period <= to.first;
  }
};

}  // namespace cca::detail
