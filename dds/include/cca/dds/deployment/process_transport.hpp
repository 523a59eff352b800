// The transport of one process: it looks for the other processes, then a thread sends and a thread receives.
// Where one environment runs here, its own thread does the work of both in a fast run.
#pragma once

#include <atomic>
#include <bit>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <cca/dds/deployment/receiver.hpp>
#include <cca/dds/deployment/sender.hpp>
#include <cca/runtime/environments/exchange/peers.hpp>

namespace cca::dds::detail {

class process_transport {
public:
  process_transport(std::uint32_t domain,
                    const std::string& partition,
                    const network& by,
                    deployment_facts of,
                    exchange_of_process& exchanged,
                    cca::detail::peers::bells& to_ring,
                    refusals& counted,
                    std::string_view (*name_of)(int))
      : facts(std::move(of)),
        numbers(exchanged),
        rings(to_ring),
        refused(counted),
        name(name_of),
        in(domain, partition, by),
        peers(std::make_unique<contact[]>(facts.environments.size())),
        known(in, facts.here, facts.manifest),
        to_here(in, facts, numbers, peers, known, refused) {
    look_for_others();
    known.settle();
    from_here.emplace(in, facts, numbers, peers, rings.leaving);
    receiving = std::thread([this] { receive_all(); });
    sending = std::thread([this] { from_here->run([this] { return is_over.load(); }); });
  }
  ~process_transport() {
    is_over = true;
    sending.join();  // it says that it leaves, while others still hear
    receiving.join();
  }
  process_transport(const process_transport&) = delete;
  process_transport& operator=(const process_transport&) = delete;

  // Its process has ended or is silent, it was refused, or it came again and is not part of this run.
  bool is_gone(std::size_t environment) const {
    if (facts.is_here(environment)) return false;
    const contact& other = peers[environment];
    const std::size_t own = facts.first_here();
    return other.has_left.load(std::memory_order_acquire) ||
           to_here.is_silent_since(other.heard.load(std::memory_order_acquire)) ||
           other.accepted_in.load(std::memory_order_relaxed) >= numbers.run_ready(own) ||
           numbers.run_finished(environment) >= numbers.run_arrived(own);
  }
  std::int64_t newest_run_before() const { return to_here.newest_run_before(); }

  // ---- in the thread of the only environment ----

  bool works_in_environment() const { return std::has_single_bit(facts.here); }
  void send() noexcept {
    if (!from_here || !from_here->try_to_send()) rings.leaving.ring();
  }
  bool receive_instead(std::int64_t longest) noexcept {
    replaced_at = cca::detail::monotonic_clock::now();
    return receive(longest);
  }

  // Never waits for the thread that receives: without a complaint it takes no lock.
  void check() const {
    if (!has_complaint.load(std::memory_order_acquire)) return;
    const std::lock_guard lock(one_at_a_time);
    throw cca::refused("cca::dds: " + complaint);
  }

private:
  // Until all environments have a process, but not for long: others may come later.
  void look_for_others() {
    const std::int64_t begin = cca::detail::monotonic_clock::now();
    std::int64_t waited = 0;
    do {
      to_here.work(longest_wait);
      look();
      check();
      waited = cca::detail::monotonic_clock::now() - begin;
    } while (waited < shortest_look || (waited < longest_look && !to_here.is_complete()));
  }
  void look() {
    const std::string found = known.look(refused, name);
    if (!found.empty()) complain(found);
  }
  void complain(const std::string& why) {
    const std::lock_guard lock(one_at_a_time);
    if (complaint.empty()) complaint = why;
    has_complaint.store(true, std::memory_order_release);
  }
  // The receiving thread rests while an environment does its work.
  void receive_all() {
    while (!is_over) {
      const std::int64_t now = cca::detail::monotonic_clock::now();
      if (now - replaced_at < longest_rest) cca::detail::monotonic_clock::sleep_until(now + longest_rest);
      else if (receive(longest_wait)) rings.arriving.ring();
    }
  }
  // False: another thread is at it.
  bool receive(std::int64_t longest) noexcept {
    const std::unique_lock alone(receives, std::try_to_lock);
    if (!alone) return false;
    try {
      to_here.work(longest);
      look();
    } catch (const std::exception& e) { complain(e.what()); }
    return true;
  }

  static constexpr std::int64_t longest_wait = 20'000'000, longest_rest = 2'000'000;
  static constexpr std::int64_t shortest_look = 60'000'000, longest_look = 300'000'000;

  deployment_facts facts;
  exchange_of_process& numbers;
  cca::detail::peers::bells& rings;
  refusals& refused;
  std::string_view (*name)(int);
  participant in;
  contacts peers;
  presence known;
  receiver to_here;
  std::optional<sender> from_here;
  mutable std::mutex one_at_a_time;
  std::string complaint;  // why this process has to go
  std::atomic<bool> has_complaint{false};
  std::mutex receives;
  std::atomic<std::int64_t> replaced_at{0};  // when an environment received last (ns)
  std::atomic<bool> is_over{false};
  std::thread sending, receiving;
};

}  // namespace cca::dds::detail
