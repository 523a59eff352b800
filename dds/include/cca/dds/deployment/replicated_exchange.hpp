// The exchange of one process of a deployment over DDS: its own records and rings, and those of the others as
// they come in.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include <cca/dds/deployment/process_transport.hpp>
#include <cca/dds/deployment/results_on_the_way.hpp>
#include <cca/runtime/transports/manifest.hpp>
#include <cca/runtime/environments/exchange/peers.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::dds::detail {

template <class D,
          class Outputs = cca::detail::all_that_leaves<D>,
          class FreeOutputs =
              cca::detail::chosen<cca::detail::counts_of<D>.output_count, cca::detail::leaves_freely<D>>,
          class Gathered =
              cca::detail::chosen<cca::detail::counts_of<D>.output_count, cca::detail::leaves_gathered<D>>,
          class Free = cca::detail::free_environments<D>>
class replicated_exchange;

// Of a free-running environment two more things are sent, in a wall-clock run: the results of its cycles, to
// the first environment, and the samples that have arrived there, from the first environment to the others:
// the newest of each beat, and for queues all of them.
template <class D, int... Output, int... FreeOutput, int... Gathered, int... Free>
class replicated_exchange<D,
                          std::integer_sequence<int, Output...>,
                          std::integer_sequence<int, FreeOutput...>,
                          std::integer_sequence<int, Gathered...>,
                          std::integer_sequence<int, Free...>> : public cca::detail::peers,
                                                                 private exchange_of_process {
public:
  replicated_exchange(std::uint32_t domain,
                      const std::string& partition,
                      const network& by,
                      const cca::detail::environments_here<D>& here,
                      std::shared_ptr<refusals> counted)
      : refused(std::move(counted)), runs_first(here[0]) {
    transport.emplace(domain, partition, by, facts_of(here), static_cast<exchange_of_process&>(*this),
                      own_rings, *refused,
                      [](int e) { return cca::detail::name_of_environment<D>(cca::detail::array_size(e)); });
  }

  cca::detail::exchange<D>* exchanged() { return &own; }

  bool is_gone(int environment) const override {
    return transport->is_gone(static_cast<std::size_t>(environment));
  }
  std::int64_t newest_run_before() const override { return transport->newest_run_before(); }
  void check() const override { transport->check(); }
  bells* rings() const override { return &own_rings; }
  bool works_in_environment() const override { return transport->works_in_environment(); }
  void send() const noexcept override { transport->send(); }
  bool receive(std::int64_t longest) const noexcept override { return transport->receive_instead(longest); }

private:
  static constexpr std::size_t environment_count = cca::detail::environment_count<D>;
  static_assert(environment_count <= 64, "cca::dds: a deployment has at most 64 environments");

  static deployment_facts facts_of(const cca::detail::environments_here<D>& here) {
    deployment_facts all;
    [&]<int... E>(std::integer_sequence<int, E...>) {
      (all.environments.push_back({cca::detail::name_of_environment<D>(E),
                                   cca::detail::samples_tell<D, E, Output...>,
                                   cca::detail::samples_show_progress_to_all<D, E>}),
       ...);
    }(std::make_integer_sequence<int, cca::detail::environment_count<D>>{});
    for (std::size_t e = 0; e < environment_count; ++e)
      if (here[e]) all.here |= std::uint64_t{1} << e;
    (all.outputs.push_back(facts_of_output<Output>()), ...);
    (all.outputs.push_back(facts_of_arrived<FreeOutput>()), ...);
    (all.outputs.push_back(facts_of_gathered<Gathered>()), ...);
    (all.outputs.push_back(facts_of_results<Free>()), ...);
    all.manifest = cca::detail::manifest_of<D>();
    all.limits = {cca::detail::counts_of<D>.period, cca::detail::exchange<D>::calls_and_one,
                  cca::detail::counts_of<D>.node_count, cca::detail::most_ahead<D>};
    all.limits.parts = cca::detail::array_size(cca::detail::counts_of<D>.part_count);
    if constexpr (DeploymentOfModes<D>) all.limits.modes = cca::detail::mode_count<D>;
    return all;
  }
  template <int Number>
    requires(cca::detail::is_request<D>(Number))
  static leaving_output facts_of_output() {
    constexpr bool is_order = cca::detail::is_order<D>(Number);
    constexpr int from =
        (Number - cca::detail::counts_of<D>.output_count) % cca::detail::environment_count<D>;
    constexpr int numbers = cca::detail::size_of_leaving<D, Number>;
    return {from,
            "cca/" + std::string(cca::detail::name_of_environment<D>(from)) +
                (is_order ? "/orders" : "/requests"),
            "cca::requests_" + deployment_facts::as_text(numbers),
            static_cast<std::size_t>(numbers),
            cca::detail::ring_capacity<D, Number>,
            is_order ? ~std::uint64_t{0} >> (64 - environment_count) : readers_of_requests<from>()};
  }
  template <int From>
  static constexpr std::uint64_t readers_of_requests() {
    return []<int... E>(std::integer_sequence<int, E...>) {
      return (std::uint64_t{0} | ... | (std::uint64_t{cca::detail::is_asked_by<D, E>(From)} << E));
    }(std::make_integer_sequence<int, cca::detail::environment_count<D>>{});
  }
  template <int Number>
    requires(!cca::detail::is_request<D>(Number))
  static leaving_output facts_of_output() {
    constexpr const auto& port = cca::detail::output_port_of<D, Number>;
    constexpr int node = cca::detail::call_of<D, cca::detail::output_of<D, Number>.call>.node;
    const space_schema schema(*port.space);
    std::string name = "cca/" + cca::detail::path_of_node<D>(node) + "." + std::string(port.name);
    std::ranges::replace(name, '.', '/');
    return {cca::detail::plan_of<D>.nodes[node].place,
            name,
            "cca::sample_" + deployment_facts::as_text(schema.hash()),
            static_cast<std::size_t>(schema.field_count()),
            cca::detail::ring_capacity<D, Number>,
            readers_of<Number>()};
  }
  template <int Number>
  static leaving_output facts_of_arrived() {
    leaving_output facts = facts_of_output<Number>();
    facts.environment = 0;
    facts.topic += "/arrived";
    return facts;
  }
  template <int Number>
  static leaving_output facts_of_gathered() {
    leaving_output facts = facts_of_output<Number>();
    facts.environment = 0;
    facts.topic += "/gathered";
    facts.type += "_numbered";
    facts.size += 1;
    facts.depth = cca::detail::gathered_capacity<D, Number>;
    return facts;
  }
  template <int E>
  static leaving_output facts_of_results() {
    using results = results_on_the_way<D, E>;
    return {E,
            "cca/" + std::string(cca::detail::name_of_environment<D>(E)) + "/results",
            "cca::results_" + deployment_facts::as_text(results::hash()),
            results::size(),
            1,
            1};
  }
  template <int Number>
  static constexpr std::uint64_t readers_of() {
    return []<int... E>(std::integer_sequence<int, E...>) {
      return (std::uint64_t{0} | ... | (std::uint64_t{cca::detail::is_read_in<D, E, Number>()} << E));
    }(std::make_integer_sequence<int, cca::detail::environment_count<D>>{});
  }

  // In an order in which all that a number promises has been written when it is read: first the numbers of
  // runs and the position, then what they promise.
  void read(std::size_t e, status& to) const override {
    const auto& from = own.environments[e];
    to[status::arrived] = from.arrived.load(std::memory_order_acquire);
    to[status::ready] = from.ready.load(std::memory_order_acquire);
    to[status::finished] = from.finished.load(std::memory_order_acquire);
    to[status::position] = from.position.load(std::memory_order_acquire);
    to[status::begun] = from.begun.load(std::memory_order_acquire);
    const std::int64_t begun_at = from.begun_at[from.slot_of(to[status::begun])];
    to[status::begun_age] =
        std::max<std::int64_t>(begun_at ? cca::detail::monotonic_clock::now() - begun_at : 0, 0);
    to[status::interval] = from.interval;
    to[status::stop_at] = from.stop_at.load(std::memory_order_acquire);
    to[status::fault_position] = from.fault.position.load(std::memory_order_acquire);
    to.reason = {};
    to[status::fault_node] = -1;
    if (to[status::fault_position] != no_position) {
      std::memcpy(to.reason.data(), from.fault.reason.data(), sizeof to.reason);
      to[status::fault_node] = from.fault.node;
    }
    to[status::beat] = from.beat;
    to[status::length] = from.length;
    to[status::stopped] = from.stopped;
    to[status::flags] = (from.is_exact ? status::is_exact : 0) | (from.all_meet ? status::all_meet : 0) |
                        (from.is_paused ? status::is_paused : 0);
    if constexpr (DeploymentOfModes<D>) {
      to[status::mode] = own.modes[e].mode;
      to[status::switches] = own.modes[e].switches;
    }
    for (std::size_t p = 0; p < to.wishes.size(); ++p)
      if constexpr (requires { own.wishes; }) to.wishes[p] = own.wishes[e][p];
    to[status::overruns] = from.overruns;
    to[status::lost_periods] = from.lost_periods;
    for (std::size_t x = 0; x < environment_count; ++x) to.late[x] = from.late[x];
  }
  // The other way round. The time at which a beat began is told as an age, because clocks differ between
  // machines.
  void write(std::size_t e, const status& from, std::int64_t at) override {
    auto& to = own.environments[e];
    const bool brings_end =
        to.fault.position != from[status::fault_position] || to.stop_at != from[status::stop_at];
    to.overruns = from[status::overruns];
    to.lost_periods = from[status::lost_periods];
    for (std::size_t x = 0; x < environment_count; ++x) to.late[x] = from.late[x];
    to.beat = from[status::beat];
    to.length = from[status::length];
    to.is_exact = (from[status::flags] & status::is_exact) != 0;
    to.all_meet = (from[status::flags] & status::all_meet) != 0;
    if (to.fault.position != from[status::fault_position]) {
      if (from[status::fault_position] != no_position) {
        std::memcpy(to.fault.reason.data(), from.reason.data(), sizeof from.reason);
        to.fault.node = static_cast<std::int32_t>(from[status::fault_node]);
      }
      to.fault.position.store(from[status::fault_position], std::memory_order_release);
    }
    to.is_paused = (from[status::flags] & status::is_paused) != 0;
    if constexpr (DeploymentOfModes<D>) {
      own.modes[e].mode = from[status::mode];
      own.modes[e].switches = from[status::switches];
    }
    for (std::size_t p = 0; p < from.wishes.size(); ++p)
      if constexpr (requires { own.wishes; }) own.wishes[e][p] = from.wishes[p];
    to.stopped.store(from[status::stopped], std::memory_order_release);
    to.stop_at.store(from[status::stop_at], std::memory_order_release);
    to.interval = from[status::interval];
    if (const std::int64_t beat = from[status::begun]; to.begun != beat)
      to.begun_at[to.slot_of(beat)] = at - from[status::begun_age];
    to.begun.store(from[status::begun], std::memory_order_release);
    to.position.store(from[status::position], std::memory_order_release);
    to.finished.store(from[status::finished], std::memory_order_release);
    to.ready.store(from[status::ready], std::memory_order_release);
    to.arrived.store(from[status::arrived], std::memory_order_release);
    if (brings_end) own.ends.ring();
  }

  void forget(std::size_t e) override { own.environments[e].position.store(-1, std::memory_order_release); }

  template <class Ring>
  static bool take_from(const Ring& ring, std::uint64_t& next, words& message) {
    typename Ring::sample one;
    if (!ring.take(next, no_position, one)) return false;
    message.clear();
    message.push_back(next - 1);
    message.push_back(static_cast<std::uint64_t>(one.published_in) |
                      (one.is_repeated ? sample_message::is_repeated : 0));
    message.push_back(static_cast<std::uint64_t>(one.origin));
    for (const double value : one.vector) message.push_back(std::bit_cast<std::uint64_t>(value));
    return true;
  }
  // keep(number, values, origin, beat): for queues that keep what came first.
  template <class Ring, class Keep>
  static void put_into(Ring& ring, std::span<const std::uint64_t> message, Keep keep) {
    decltype(Ring::sample::vector) values;
    for (int i = 0; i < values.size(); ++i)
      values[i] = std::bit_cast<double>(message[sample_message::head + cca::detail::array_size(i)]);
    const auto origin = static_cast<std::int64_t>(message[2]);
    const bool is_repeated = (message[1] & sample_message::is_repeated) != 0;
    const std::uint64_t number = ring.put(values, origin, sample_message::beat(message), false, is_repeated);
    if (!is_repeated) keep(number, values, origin, sample_message::beat(message));
  }

  // Where the first environment runs here it takes the results of cycles itself.
  template <int E>
  bool take_results(std::uint64_t& next, words& message) const {
    if (runs_first) return false;
    const std::int64_t beat = own.environments[0].begun.load(std::memory_order_relaxed);
    return std::get<results_on_the_way<D, E>>(sent).take(own.template results<E>(), beat, next, message);
  }

  template <int Number, bool IsGathered>
  auto keep() {
    // Not [this]: where no sample waits it would not be used.
    return [&](std::uint64_t number, const auto& v, std::int64_t origin, std::int64_t k) {
      if constexpr (cca::detail::most_waiting<D, Number> > 0)
        if constexpr (IsGathered == cca::detail::is_gathered<D, Number>)
          own.template keep<Number>(number, v, origin, k);
    };
  }

  bool take([[maybe_unused]] std::size_t output,
            [[maybe_unused]] std::uint64_t& next,
            [[maybe_unused]] words& message) const override {
    [[maybe_unused]] std::size_t number = 0;
    bool has = false;
    ((number++ == output ? void(has = take_from(own.template ring<Output>(), next, message)) : void()), ...);
    ((number++ == output ? void(has = take_from(own.template arrived<FreeOutput>(), next, message)) : void()),
     ...);
    ((number++ == output ? void(has = take_from(own.template gathered<Gathered>(), next, message)) : void()),
     ...);
    ((number++ == output ? void(has = take_results<Free>(next, message)) : void()), ...);
    return has;
  }
  void put([[maybe_unused]] std::size_t output,
           [[maybe_unused]] std::span<const std::uint64_t> message) override {
    [[maybe_unused]] std::size_t number = 0;
    ((number++ == output ? put_into(own.template ring<Output>(), message, keep<Output, false>()) : void()),
     ...);
    ((number++ == output ? put_into(own.template arrived<FreeOutput>(), message, [](auto&&...) {}) : void()),
     ...);
    ((number++ == output ? put_into(own.template gathered<Gathered>(), message, keep<Gathered, true>())
                         : void()),
     ...);
    ((number++ == output ? results_on_the_way<D, Free>::put(own.template results<Free>(), message) : void()),
     ...);
  }

  std::int64_t newest_beat() const override {
    std::int64_t newest = 0;
    for (int e = 0; e < static_cast<int>(environment_count); ++e) newest = std::max(newest, own.position(e));
    return newest / cca::detail::exchange<D>::calls_and_one;
  }
  std::int64_t run_ready(std::size_t e) const override { return own.environments[e].ready; }
  std::int64_t run_arrived(std::size_t e) const override { return own.environments[e].arrived; }
  std::int64_t run_finished(std::size_t e) const override { return own.environments[e].finished; }

  std::shared_ptr<refusals> refused;
  mutable std::tuple<results_on_the_way<D, Free>...> sent{};
  mutable bells own_rings;
  mutable cca::detail::exchange<D> own{};  // to take results changes it
  bool runs_first;
  mutable std::optional<process_transport> transport;  // last: its threads use the exchange
};

}  // namespace cca::dds::detail
