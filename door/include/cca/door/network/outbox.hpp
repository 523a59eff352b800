// What waits to be sent to one client: answers, the time, and samples. Samples are bounded: the oldest are
// lost first, and counted. Answers are never lost: a client that does not read them is dropped.
//
// A sample is a message of its own, as Foxglove's protocol has it. A client that offers `cca.batches.v1` gets
// all that wait in one message: a browser pays some ten microseconds for a message, and nearly nothing for a
// sample.
#pragma once

#include <cstdint>
#include <cstring>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <cca/door/network/frames_functions.hpp>
#include <cca/door/network/limits.hpp>

namespace cca::detail::door_network {

// Numbers of the protocol are little endian, as those of this machine (record/mcap/bytes.hpp).
template <class Number>
void add_number(std::string& to, Number number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  to.append(bytes, sizeof number);
}

// The first byte of a message with many samples; each is a subscription (4 bytes), a time (8), the size of
// its data (4), and the data.
inline constexpr char op_of_batch = '\xca';

class outbox {
public:
  outbox(const door_limits& all, bool takes_batches) : limits(all), in_batches(takes_batches) {}

  // False if the client has left too many unread.
  bool answer(frame_kind kind, std::string_view payload) {
    add_frame(answers, kind, payload);
    return answers.size() <= limits.answers;
  }
  void time(std::uint64_t ns) { now = ns; }  // only the newest is sent
  // `is_kept(channel)`: the client gets the last sample of that channel, whatever is lost.
  template <class IsKept>
  void sample(IsKept&& is_kept,
              std::uint16_t channel,
              std::uint32_t subscription,
              std::uint64_t ns,
              std::string_view data) {
    const std::size_t begin = samples.size();
    if (!in_batches) {
      add_frame_head(samples, frame_kind::binary, 13 + data.size());
      samples += '\1';
    }
    add_number(samples, subscription);
    add_number(samples, ns);
    if (in_batches) add_number(samples, static_cast<std::uint32_t>(data.size()));
    samples.append(data);
    each.push_back({samples.size() - begin, channel});
    while (each.size() > 1 &&
           (each.size() > limits.waiting_messages || samples.size() - sent > limits.waiting_bytes)) {
      const std::uint16_t of = each.front().channel;
      drop_first();
      ++lost;
      if (is_kept(of)) owed.insert(of);
    }
  }

  // The next bytes, in whole frames: answers first, then the time, then about 64 KiB of samples.
  bool take(std::string& to) {
    give_back(to);
    to.clear();
    if (!answers.empty()) {
      std::swap(to, answers);
      return true;
    }
    if (now) {
      std::string payload = "\2";
      add_number(payload, *now);
      now.reset();
      add_frame(to, frame_kind::binary, payload);
    }
    std::size_t size = 0;
    while (!each.empty() && size < (64u << 10)) {
      size += each.front().size;
      each.pop_front();
    }
    if (in_batches && size > 0) {
      add_frame_head(to, frame_kind::binary, 1 + size);
      to += op_of_batch;
    }
    to.append(samples, sent, size);
    sent += size;
    tidy();
    return !to.empty();
  }
  void take_answers(std::string& to) { to = std::exchange(answers, {}); }
  // For tests: bytes of memory for samples, waiting or not.
  std::size_t holds() const { return samples.capacity(); }
  bool has_room() const { return samples.size() - sent < limits.waiting_bytes / 2; }

  std::uint64_t lost = 0;
  std::set<std::uint16_t>
      owed{};  // kept channels whose last sample may be lost: to be sent once there is room

private:
  struct waiting_sample {
    std::size_t size;
    std::uint16_t channel;
  };
  const door_limits& limits;
  const bool in_batches;
  std::string answers{}, samples{};
  std::deque<waiting_sample> each{};
  std::size_t sent = 0;  // the bytes of `samples` before that are gone
  std::optional<std::uint64_t> now{};

  // What a client that was slow for a moment has needed. An assignment would keep it.
  static void give_back(std::string& bytes) {
    if (bytes.capacity() > (256u << 10)) std::string().swap(bytes);
  }

  void drop_first() {
    sent += each.front().size;
    each.pop_front();
    tidy();
  }
  void tidy() {
    if (sent == samples.size() || sent * 2 > samples.size() + 4096) {
      samples.erase(0, sent);
      sent = 0;
    }
    if (samples.empty()) give_back(samples);
  }
};

}  // namespace cca::detail::door_network
