// The figures of a deployment's wall-clock runs. `Self` has the exchange, in `shared`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cca/component/lifecycle.hpp>
#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/runtime/environments/figures.hpp>
#include <cca/runtime/environments/waiting/lost_contact.hpp>

namespace cca::detail {

// The fault of a run that has not returned yet, and the environments that hold it up: of this process those
// that are in a beat, of others those that have not ended.
struct unreturned_fault {
  std::int64_t beat = -1;  // -1: there is none
  std::string path{}, reason{}, cause{};
  std::vector<std::string> waits_for{};
};

template <class Self, class D>
class figures_of_runs {
public:
  // In the wall-clock runs since start(). Beats whose samples had not come when they began, each
  // environment that was late counted; beats that were still running when the next should begin; the periods
  // in which no beat began. Sums over all environments. These and `figures` may be called from any thread
  // while it runs.
  std::int64_t late() const noexcept {
    std::int64_t all = 0;
    for (const auto& e : records())
      for (const auto& channel : e.late) all += channel.load(std::memory_order_relaxed);
    return all;
  }
  std::int64_t overruns() const noexcept {
    std::int64_t all = 0;
    for (const auto& e : records()) all += e.overruns.load(std::memory_order_relaxed);
    return all;
  }
  std::int64_t lost_periods() const noexcept {
    std::int64_t all = 0;
    for (const auto& e : records()) all += e.lost_periods.load(std::memory_order_relaxed);
    return all;
  }
  // After lost contact: what the environment needed, what it had, and what to change, for a person. Empty
  // after other faults, and where there is none. Between two runs.
  std::string fault_cause() const {
    const Self& self = static_cast<const Self&>(*this);
    return self.state() == state::faulted ? contact.template text<D>() : std::string();
  }
  // The fault of a run that has not returned. Any thread, while it runs.
  unreturned_fault fault_before_return() const {
    unreturned_fault one;
    const Self& self = static_cast<const Self&>(*this);
    const auto& all = *self.shared;
    const auto& first = all.first_to_fail();
    const std::int64_t position = first.fault.position.load(std::memory_order_acquire);
    if (position == no_position) return one;
    one.beat = position / exchange<D>::calls_and_one + 1;
    one.reason = first.fault.reason.data();
    if (first.fault.node >= 0) one.path = path_of_node<D>(first.fault.node);
    one.cause = contact_loss::in<D>(all, static_cast<std::size_t>(&first - all.environments.data()),
                                    array_size(self.first_here()), first.fault)
                    .template text<D>();
    for (std::size_t e = 0; e < all.environments.size(); ++e) {
      const auto& each = all.environments[e];
      const bool holds_up = self.here[e] ? each.slowest.since != 0 : each.finished < each.arrived;
      if (holds_up) one.waits_for.push_back("`" + std::string(name_of_environment<D>(e)) + "`");
    }
    return one;
  }
  std::vector<environment_figures> figures() const {
    std::vector<environment_figures> all;
    for (std::size_t e = 0; e < records().size(); ++e) {
      const auto& record = records()[e];
      auto& one = all.emplace_back(environment_figures{name_of_environment<D>(e),
                                                       record.wake_up,
                                                       record.duration,
                                                       record.overruns,
                                                       record.lost_periods,
                                                       {}});
      for (std::size_t from = 0; from < record.late.size(); ++from)
        if (detail::crossings_of<D>.least_delay[from][e] > 0)
          one.channels.push_back({name_of_environment<D>(from), record.late[from]});
    }
    return all;
  }

protected:
  // Of the record with the first fault, when the run has ended. `own`: an environment of this process.
  void keep_cause(const environment_record<environment_count<D>>& first, int own) {
    const auto& all = *static_cast<const Self&>(*this).shared;
    contact = contact_loss::in<D>(all, static_cast<std::size_t>(&first - all.environments.data()),
                                  array_size(own), first.fault);
  }

private:
  contact_loss contact{};

  const auto& records() const { return static_cast<const Self&>(*this).shared->environments; }
};

}  // namespace cca::detail
