// The results of a free-running environment as messages to the process of the first environment: of each
// output the cycle, the origin, the values, and what queues take, in as many messages as that needs.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>

#include <cca/dds/domain/channel.hpp>
#include <cca/dds/deployment/messages.hpp>
#include <cca/runtime/environments/exchange/cycle_results.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::dds::detail {

template <class D, int E, class Outputs = cca::detail::outputs_leaving<D, E>>
class results_on_the_way;
template <class D, int E, int... Output>
class results_on_the_way<D, E, std::integer_sequence<int, Output...>> {
  using results = cca::detail::cycle_results<D, E>;
  using slot = typename results::slot;

public:
  // Of a message, in words, behind its head.
  static std::size_t size() { return (std::size_t{0} + ... + size_of<Output>()); }
  // Of what it means.
  static std::uint64_t hash() {
    std::uint64_t all = 0;
    (void(all = (all * 31 + schema_of<Output>().hash()) * 31 + most_in_message<Output>), ...);
    return all;
  }

  // The next message, in this beat. False: there is none.
  bool take(results& from, std::int64_t beat, std::uint64_t& next, words& message) {
    if (!newest) newest = from.take();
    if (!newest) return false;
    message.clear();
    message.push_back(next++);
    message.push_back(static_cast<std::uint64_t>(std::max<std::int64_t>(beat, 0)));
    message.push_back(0);
    (add_newest(message, newest->template at<Output>()), ...);
    bool is_all = true;
    (void(is_all &= add_gathered<Output>(message)), ...);
    if (is_all) newest = nullptr;
    return true;
  }
  static void put(results& to, std::span<const std::uint64_t> message) {
    to.put_all([&](slot& here) {
      std::size_t at = sample_message::head;
      (read_newest(message, at, here.template at<Output>()), ...);
      (put_gathered<Output>(here, message, at), ...);
    });
  }

private:
  // Samples of one output for queues; 0: it has none.
  template <int Number>
  static constexpr std::size_t most_in_message =
      static_cast<std::size_t>(std::min(cca::detail::gathered_in_a_beat<D>[Number], 8));
  template <int Number>
  static constexpr std::size_t words_of_sample =
      2 + cca::detail::array_size(cca::detail::size_of_output<D, Number>);

  template <int Number>
  static space_schema schema_of() {
    return space_schema(*cca::detail::output_port_of<D, Number>.space);
  }
  template <int Number>
  static constexpr std::size_t size_of() {
    constexpr std::size_t most = most_in_message<Number>;
    return words_of_sample<Number> + words_of_modes +
           (most > 0 ? 1 + words_of_modes + most * words_of_sample<Number> : 0);
  }
  // Of a set of modes: when the cycle began, and which sample was the first since its component came.
  static constexpr bool has_modes = DeploymentOfModes<D>;
  static constexpr std::size_t words_of_modes = has_modes ? 1 : 0;

  template <class Sample>
  static void add_newest(words& message, const Sample& one) {
    add(message, one.cycle, one);
    if constexpr (has_modes) message.push_back(static_cast<std::uint64_t>(one.began_in));
  }
  template <class Sample>
  static void read_newest(std::span<const std::uint64_t> message, std::size_t& at, Sample& one) {
    read(message, at, one.cycle, one);
    if constexpr (has_modes) one.begin_in(static_cast<std::int64_t>(message[at++]));
  }

  template <class Sample>
  static void add(words& message, std::uint64_t number, const Sample& one) {
    message.push_back(number);
    message.push_back(static_cast<std::uint64_t>(one.origin));
    for (const double value : one.coordinates) message.push_back(std::bit_cast<std::uint64_t>(value));
  }
  template <class Sample>
  static void read(std::span<const std::uint64_t> message,
                   std::size_t& at,
                   std::uint64_t& number,
                   Sample& one) {
    number = message[at++];
    one.origin = static_cast<std::int64_t>(message[at++]);
    for (double& value : one.coordinates) value = std::bit_cast<double>(message[at++]);
  }

  // True: these were the last.
  template <int Number>
  bool add_gathered([[maybe_unused]] words& message) {
    if constexpr (most_in_message<Number> > 0) {
      const auto& all = newest->template gathered<Number>();
      std::uint64_t& next = numbers[Number];
      if (all.end() < next) next = 0;
      if constexpr (has_modes) message.push_back(all.stay.first);
      const std::size_t count_at = message.size();
      std::size_t count = 0;
      message.push_back(0);
      all.for_each_from(next, [&](const auto& one) {
        if (count == most_in_message<Number>) return;
        ++count;
        next = one.number + 1;
        add(message, one.number, one);
      });
      message[count_at] = count;
      message.resize(count_at + 1 + words_of_sample<Number> * most_in_message<Number>, 0);
      return next == all.end() || count == 0;
    }
    return true;
  }
  template <int Number>
  static void put_gathered([[maybe_unused]] slot& here,
                           [[maybe_unused]] std::span<const std::uint64_t> message,
                           [[maybe_unused]] std::size_t& at) {
    if constexpr (most_in_message<Number> > 0) {
      if constexpr (has_modes) here.template gathered<Number>().stay.first = message[at++];
      const std::uint64_t count = message[at++];
      for (std::uint64_t i = 0; i < most_in_message<Number>; ++i) {
        cca::detail::result_of_cycle<D, Number> one;
        read(message, at, one.cycle, one);
        if (i < count) here.template gathered<Number>().put_numbered(one.cycle, one.origin, one.vector());
      }
    }
  }

  const slot* newest = nullptr;  // what is being sent
  std::array<std::uint64_t, cca::detail::array_size(cca::detail::counts_of<D>.output_count + 1)> numbers{};
};

}  // namespace cca::dds::detail
