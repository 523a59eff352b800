// What a publisher leaves for the thread of the connection, which makes messages of it and sends them.
#pragma once

#include <dds/dds.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include <cca/ros2/connection.hpp>
#include <cca/ros2/messages/header.hpp>
#include <cca/ros2/quality.hpp>
#include <cca/ros2/topic.hpp>
#include <cca/runtime/environments/sample_ring.hpp>

namespace cca::ros2::detail {

// `Message` is one of ros2/messages: it says how a message is made of numbers.
template <class Message, class Quality>
class outgoing final : public endpoint {
public:
  outgoing(std::shared_ptr<connection> over, std::string_view topic_name)
      : net(std::move(over)),
        on(net->in(), topic_name, Message::type),
        writer(dds_create_writer(net->in().writes(),
                                 on.get(),
                                 qos_of(Quality::is_reliable, Quality::depth, Message::type.hash).get(),
                                 nullptr),
               "publisher of `" + std::string(topic_name) + "`") {
    net->add(*this);
  }
  ~outgoing() override { net->remove(*this); }

  // The beat's: numbers, and their age in ns.
  template <class Vector>
  void put(const Vector& values, std::int64_t age) noexcept {
    ring.put(values, age, 0);
  }

  std::int64_t sent() const { return sent_count.load(std::memory_order_relaxed); }
  std::int64_t dropped() const { return dropped_count.load(std::memory_order_relaxed); }

  void work() override {
    typename decltype(ring)::sample one;
    std::uint64_t expected = next;
    for (; ring.take(next, std::numeric_limits<std::int64_t>::max(), one); expected = next) {
      const auto lost = static_cast<std::int64_t>(next - 1 - expected);
      const bool went = dds_write(writer.get(), message.make(one.vector.data(), stamp_of(one.origin))) >= 0;
      sent_count.fetch_add(went, std::memory_order_relaxed);
      dropped_count.fetch_add(lost + !went, std::memory_order_relaxed);
    }
    dropped_count.fetch_add(static_cast<std::int64_t>(next - expected), std::memory_order_relaxed);
  }

private:
  // ROS time is the wall clock. The beat has none, so it is asked here, and the age counted back.
  static time_stamp stamp_of(std::int64_t age) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const std::int64_t at = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count() - age;
    return {static_cast<std::int32_t>(at / 1'000'000'000), static_cast<std::uint32_t>(at % 1'000'000'000)};
  }

  std::shared_ptr<connection> net;
  topic on;
  cca::dds::detail::entity writer;
  cca::detail::sample_ring<Message::size, 64> ring;
  std::uint64_t next = 0;
  typename Message::maker message;
  std::atomic<std::int64_t> sent_count{0}, dropped_count{0};
};

}  // namespace cca::ros2::detail
