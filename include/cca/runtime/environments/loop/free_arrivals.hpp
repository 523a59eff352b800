// How the samples of free-running environments enter the beats in a wall-clock run: the first environment,
// which gives the beat, takes the newest results when a beat begins, and puts them into rings with the number
// of this beat. So all readers, and a recording, agree on the beat in which a sample arrived.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <cca/runtime/environments/exchange/exchange.hpp>

namespace cca::detail {

// Of one free-running environment.
template <class D, int E, class Outputs = outputs_leaving<D, E>>
class arrivals_from;
template <class D, int E, int... Output>
class arrivals_from<D, E, std::integer_sequence<int, Output...>> {
public:
  // A fast run begins: what has not arrived yet never does.
  void forget(exchange<D>& shared) noexcept {
    if (const auto* const last = shared.template results<E>().take()) {
      (void(seen[index<Output>] = last->template at<Output>().cycle), ...);
      (void(gathered[index<Output>].from = last->template gathered<Output>().end()), ...);
    }
    news = nullptr;
  }
  // Beat k begins. by.template arrives<Output>(result): else it is forgotten.
  template <class By>
  void admit(exchange<D>& shared, [[maybe_unused]] std::int64_t k, [[maybe_unused]] const By& by) noexcept {
    news = shared.template results<E>().take();
    if (news) (admit_one<Output>(shared, k, by), ...);
  }
  // f.template operator()<Output>(coordinates, origin) for the newest of each output that arrived in this
  // beat.
  template <class F>
  void for_each(F f) const {
    if (!news) return;
    (void(is_new[index<Output>] ? f.template operator()<Output>(news->template at<Output>().vector(),
                                                                news->template at<Output>().origin)
                                : void()),
     ...);
  }

  // f.template operator()<Output>(samples, number of the first, how many are missing) for the outputs of
  // which queues take all that arrived in this beat.
  template <class F>
  void for_each_gathered(F f) const {
    if (news) (tell_gathered<Output>(f), ...);
  }

private:
  template <int Number, class F>
  void tell_gathered([[maybe_unused]] F& f) const {
    if constexpr (is_gathered<D, Number>)
      if (is_new[index<Number>])
        f.template operator()<Number>(news->template gathered<Number>(), gathered[index<Number>].begins,
                                      gathered[index<Number>].missing);
  }
  template <int Number>
  static constexpr std::size_t index = [] {
    std::size_t at = 0;
    ((Output < Number ? ++at : at), ...);
    return at;
  }();

  template <int Number, class By>
  void admit_one(exchange<D>& shared, std::int64_t k, const By& by) noexcept {
    const auto& result = news->template at<Number>();
    is_new[index<Number>] = result.cycle != seen[index<Number>];
    if (!is_new[index<Number>]) return;
    seen[index<Number>] = result.cycle;
    is_new[index<Number>] = by.template arrives<Number>(result);
    if (!is_new[index<Number>]) return;
    shared.template arrived<Number>().put(result.vector(), result.origin, k);
    if constexpr (is_gathered<D, Number>) gather_one<Number>(shared, k);
  }
  // For queues all of them, with their numbers.
  template <int Number>
  void gather_one(exchange<D>& shared, std::int64_t k) noexcept {
    Eigen::Matrix<double, size_of_output<D, Number> + 1, 1> numbered;
    const auto& all = news->template gathered<Number>();
    gathered_numbers& at = gathered[index<Number>];
    if (all.end() < at.from) at.from = at.counted = 0;  // its process has begun anew
    if constexpr (DeploymentOfModes<D>) {
      const std::uint64_t first = std::min(all.stay.first, all.end());
      at.from = std::max(at.from, first);
      at.counted = std::max(at.counted, first);
    }
    at.begins = at.from;
    std::uint64_t came = 0;
    all.for_each_from(at.begins, [&](const auto& one) {
      ++came;
      numbered << one.vector(), static_cast<double>(one.number);
      shared.template put_gathered<Number>(numbered, one.origin, k);
    });
    at.missing = all.end() - at.counted - came;
    at.from = at.counted = all.end();
  }

  const typename cycle_results<D, E>::slot* news = nullptr;
  std::array<std::uint64_t, sizeof...(Output) + 1> seen{};  // the cycle of the newest that arrived
  std::array<bool, sizeof...(Output) + 1> is_new{};
  struct gathered_numbers {
    std::uint64_t from = 0, counted = 0;  // the next sample; and the next that has not been counted
    std::uint64_t begins = 0;             // the first that arrived in this beat
    std::uint64_t missing = 0;            // how many that have not been counted before do not come
  };
  std::array<gathered_numbers, sizeof...(Output) + 1> gathered{};
};

// Of all of them.
template <class D, class Environments = free_environments<D>>
struct free_arrivals;
template <class D, int... E>
struct free_arrivals<D, std::integer_sequence<int, E...>> : arrivals_from<D, E>... {
  void forget([[maybe_unused]] exchange<D>& shared) noexcept {
    (static_cast<arrivals_from<D, E>&>(*this).forget(shared), ...);
  }
  template <class By>
  void admit([[maybe_unused]] exchange<D>& shared,
             [[maybe_unused]] std::int64_t k,
             [[maybe_unused]] const By& by) noexcept {
    (static_cast<arrivals_from<D, E>&>(*this).admit(shared, k, by), ...);
  }
  template <class F>
  void for_each([[maybe_unused]] F f) const {
    (static_cast<const arrivals_from<D, E>&>(*this).for_each(f), ...);
  }
  template <class F>
  void for_each_gathered([[maybe_unused]] F f) const {
    (static_cast<const arrivals_from<D, E>&>(*this).for_each_gathered(f), ...);
  }
};

}  // namespace cca::detail
