// Sends what the environments of this process publish, in a thread of its own: a beat only writes its
// numbers. In a fast run the only environment of a process sends itself, between two beats.
//
// It sleeps until an environment rings: when a beat begins and when it is done. Every millisecond it looks at
// what changes between runs. A status goes out after the samples that it counts, and at least every 100 ms.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <cca/dds/deployment/deployment_facts.hpp>
#include <cca/runtime/environments/exchange/bell.hpp>
#include <cca/runtime/pace.hpp>

namespace cca::dds::detail {

class sender {
public:
  sender(const participant& in,
         const deployment_facts& of,
         const exchange_of_process& from,
         const contacts& others,
         cca::detail::bell& to_hear)
      : facts(of), numbers(from), peers(others), news(to_hear) {
    for (std::size_t e = 0; e < facts.environments.size(); ++e)
      if (facts.is_here(e)) all.push_back(std::make_unique<environment>(in, facts, e));
  }

  // Until `is_over()`. Then it says that it leaves.
  template <class F>
  void run(F is_over) {
    while (!is_over()) {
      const std::uint32_t before = news.count();
      std::int64_t sleep = 0;
      {
        const std::lock_guard lock(one_at_a_time);
        sleep = send_all();
      }
      news.wait(before, sleep);
    }
    for (auto& one : all) send(*one, cca::detail::monotonic_clock::now(), status::is_leaving);
    for (auto& one : all) one->writer.wait_for_readers();
  }

  // The same, in the thread of an environment. False: something is left for `run` to send.
  bool try_to_send() {
    const std::unique_lock lock(one_at_a_time, std::try_to_lock);
    return lock && send_all() != shortest_sleep;
  }

private:
  static constexpr std::int64_t shortest_sleep = 50'000, longest_sleep = 1'000'000;
  static constexpr std::int64_t longest_silence = 100'000'000;

  struct output {
    std::size_t number;
    channel_writer writer;
    std::uint64_t next = 0;
    words message{};
    bool is_waiting = false;  // the message has been taken and not been sent
  };
  struct environment {
    environment(const participant& in, const deployment_facts& facts, std::size_t e)
        : number(e),
          now(facts.environments.size(), facts.outputs_of(e).size(), facts.limits.parts),
          writer(in,
                 facts.status_topic(e),
                 facts.status_type(),
                 status::size(now.late.size(), now.published.size(), now.wishes.size()),
                 1) {
      for (const std::size_t o : facts.outputs_of(e)) {
        const leaving_output& out = facts.outputs[o];
        outputs.push_back({o, {in, out.topic, out.type, sample_message::head + out.size, out.depth}});
      }
    }
    std::size_t number;
    status now;
    channel_writer writer;
    std::vector<output> outputs{};
    words message{}, sent{};
    std::int64_t sent_at = 0;
  };

  // How long until the next look at the latest.
  std::int64_t send_all() {
    const std::int64_t now = cca::detail::monotonic_clock::now();
    std::int64_t sleep = longest_sleep;
    for (auto& one : all) sleep = std::min(sleep, send(*one, now, 0));
    return sleep;
  }
  std::int64_t send(environment& e, std::int64_t now, std::int64_t flags) {
    numbers.read(e.number, e.now);  // before the samples: they are at least those that its position promises
    for (std::size_t o = 0; o < e.outputs.size(); ++o) {
      if (!send_samples(e.outputs[o])) return shortest_sleep;
      e.now.published[o] = static_cast<std::int64_t>(e.outputs[o].next);
    }
    e.now[status::flags] |= flags;
    for (std::size_t x = 0; x < e.now.accepted.size(); ++x) {
      e.now.accepted[x] = peers[x].accepted.load(std::memory_order_acquire);
      e.now.accepted_in[x] = peers[x].accepted_in.load(std::memory_order_relaxed);
    }
    const std::int64_t age = std::exchange(e.now[status::begun_age], 0);
    e.now.write_to(e.message);
    const std::int64_t silence = now - e.sent_at;
    if (e.message == e.sent && silence < longest_silence) return longest_sleep;
    if (may_wait(e) && silence < longest_hold(e)) return std::min(longest_hold(e) - silence, longest_sleep);
    std::swap(e.message, e.sent);
    e.message = e.sent;
    e.message[status::begun_age] = static_cast<std::uint64_t>(age);
    if (!e.writer.write(e.message)) e.sent.clear();  // once more
    e.sent_at = now;
    return longest_sleep;
  }
  // In a fast run, and nothing is new but how far it is: if its samples tell that, a status in each
  // beat would only cost time. Where all environments meet after each beat, all wait for it.
  bool may_wait(const environment& e) const {
    const auto behind = static_cast<std::ptrdiff_t>(e.outputs.size());
    return facts.environments[e.number].samples_tell &&
           (e.now[status::flags] & (status::is_exact | status::all_meet)) == status::is_exact &&
           e.message.size() == e.sent.size() && e.message[status::flags] == e.sent[status::flags] &&
           std::equal(e.message.begin() + status::position + 1, e.message.end() - behind,
                      e.sent.begin() + status::position + 1);
  }
  // Somebody may wait for a status only if it can't see from samples how far this environment is.
  std::int64_t longest_hold(const environment& e) const {
    if (facts.environments[e.number].samples_tell_all) return 10'000'000;
    const auto at = [](const words& message) { return static_cast<std::int64_t>(message[status::position]); };
    return at(e.message) - at(e.sent) < 2 * facts.limits.calls_and_one ? 500'000 : 0;
  }
  // All there are. False: a reader holds them up.
  bool send_samples(output& o) {
    while (o.is_waiting || numbers.take(o.number, o.next, o.message)) {
      o.is_waiting = !o.writer.write(o.message);
      if (o.is_waiting) return false;
    }
    return true;
  }

  const deployment_facts& facts;
  const exchange_of_process& numbers;
  const contacts& peers;
  cca::detail::bell& news;
  std::vector<std::unique_ptr<environment>> all;
  std::mutex one_at_a_time;
};

}  // namespace cca::dds::detail
