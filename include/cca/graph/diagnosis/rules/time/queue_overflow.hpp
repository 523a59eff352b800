// queue.overflow: a queue that rejects can never be full.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>
#include <cca/graph/plan/merged_queue.hpp>

namespace cca::detail {

struct queue_overflow {
  static constexpr std::string_view id = "queue.overflow";

  static constexpr bool is_broken(when::clocked_wire, const flat_view& g, const finding& f) {
    if (!f.item->has_queue() || f.item->full != full_kind::reject) return false;
    const auto& in = g.inputs[f.input];
    if (is_merged(in)) return in.way_of < 0 && merged_queue{g, f.input}.overflows();
    return overflows(shifted(published(g, g.outputs[f.output]), in.delay), g.calls[in.call].fires,
                     f.item->capacity);
  }

  static constexpr void tell(auto& m) {
    if (is_merged(m.g.inputs[m.found().input])) {
      m.at_wire();
      return tell_merged(m);
    }
    const auto& out = m.g.outputs[m.found().output];
    const auto& in = m.g.inputs[m.found().input];
    if (port_of(m.g, in).space) m.at_wire();
    else add_node_path(m.where, m.g, m.g.calls[in.call].node);
    const auto from = published(m.g, out), to = m.g.calls[in.call].fires;
    m.two_clocks(out, in);
    m.say() << ", so the queue of " << m.item().capacity
            << " between them is full sooner or later, which cca::reject forbids: read "
            << (to.never() || from.period < to.period ? "faster" : "sooner")
            << ", or say what is lost: cca::drop_oldest or cca::drop_newest";
  }

private:
  static constexpr void tell_merged(auto& m) {
    const auto& in = m.g.inputs[m.found().input];
    m.port(in);
    m.done(" read", m.g.calls[in.call].fires);
    m.say() << ", but samples come from ";
    for_each_way(m.g, m.found().input, [&](const input& way) {
      m.port(m.g.outputs[way.writer]);
      m.say() << " (published ";
      add_clock(m.say(), published(m.g, m.g.outputs[way.writer]));
      m.say() << (way.next_way >= 0 ? ") and from " : ")");
    });
    m.say() << ", so the queue of " << in.wire->capacity
            << " is full sooner or later, which cca::reject forbids: read faster, or say what is lost: "
               "cca::drop_oldest or cca::drop_newest";
  }

  // Samples arrive faster than they are read, or fill the queue before the first of them is read.
  static constexpr bool overflows(clock from, clock to, std::int64_t room) {
    if (!from.known() || to.dynamic()) return false;
    return to.never() || from.period < to.period || from.first + room * from.period <= to.first;
  }
};

}  // namespace cca::detail
