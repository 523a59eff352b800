// The messages of a recording on their way to the thread of the door: bounded, and handed over many at a
// time. A channel that nobody has subscribed to costs one look at an atomic.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/door/network/channels_functions.hpp>
#include <cca/door/network/limits.hpp>
#include <cca/door/network/twin_functions.hpp>
#include <cca/record/file/message_sink.hpp>

namespace cca::detail::door_network {

class inbox final : public recording::message_sink {
public:
  struct batch {
    std::vector<recording::channel_info> channels{};
    std::map<std::string, recording::detail::text_map> notes{};
    std::string bytes{};  // channel, time, size, data
    std::uint64_t lost = 0;

    template <class Each>
    void each(Each&& function) const {
      for (std::size_t at = 0; at < bytes.size();) {
        head one;
        std::memcpy(&one, bytes.data() + at, sizeof one);
        at += sizeof one;
        function(one.channel, one.time, std::string_view(bytes).substr(at, one.size));
        at += one.size;
      }
    }
  };

  // `wake` comes from the recording's thread, at most once before the next `take`.
  inbox(const door_limits& all, wanted_channels& which, kept_for_twins& kept, std::function<void()> function)
      : limits(all), wanted(which), twins(kept), wake(std::move(function)) {}

  void channel(const recording::channel_info& one) override {
    twins.channel(one);
    if (one.is_kept)
      wanted.set(one.id, true);  // its next message may come before the door's thread has looked
    {
      const std::scoped_lock lock(guard);
      waiting.channels.push_back(one);
    }
    call();
  }
  void message(std::uint16_t channel,
               std::uint64_t log_time,
               std::uint64_t,
               recording::detail::byte_view data) override {
    latest.store(log_time, std::memory_order_relaxed);
    twins.message(channel, data);
    if (!wanted[channel] || channel >= first_own_channel) return;
    bool is_much;
    {
      const std::scoped_lock lock(guard);
      if (!waiting.bytes.empty() && waiting.bytes.size() + data.size() > limits.handed_over) {
        ++waiting.lost;
        return;
      }
      const head one{log_time, static_cast<std::uint32_t>(data.size()), channel};
      waiting.bytes.append(reinterpret_cast<const char*>(&one), sizeof one);
      waiting.bytes.append(reinterpret_cast<const char*>(data.data()), data.size());
      is_much = waiting.bytes.size() > (32u << 10);
    }
    has_some.store(true, std::memory_order_relaxed);
    if (is_much) call();
  }
  void metadata(const std::string& name, const recording::detail::text_map& entries) override {
    twins.metadata(name, entries);
    {
      const std::scoped_lock lock(guard);
      waiting.notes[name] = entries;
    }
    call();
  }
  void hand_over() override {
    if (has_some.exchange(false, std::memory_order_relaxed)) call();
  }

  // The thread of the door.
  void take(batch& to) {
    to.channels.clear(), to.notes.clear(), to.bytes.clear(), to.lost = 0;
    if (to.bytes.capacity() > (1u << 20)) std::string().swap(to.bytes);  // of a door that was held up
    is_called.store(false);
    const std::scoped_lock lock(guard);
    std::swap(to, waiting);
  }
  std::uint64_t time() const { return latest.load(std::memory_order_relaxed); }

private:
  struct head {
    std::uint64_t time = 0;
    std::uint32_t size = 0;
    std::uint16_t channel = 0;
  };
  const door_limits& limits;
  wanted_channels& wanted;
  kept_for_twins& twins;
  std::function<void()> wake;
  std::mutex guard{};
  batch waiting{};
  std::atomic<std::uint64_t> latest{0};
  std::atomic<bool> has_some{false}, is_called{false};

  void call() {
    if (!is_called.exchange(true)) wake();
  }
};

}  // namespace cca::detail::door_network
