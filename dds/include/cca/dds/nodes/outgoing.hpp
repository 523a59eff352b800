// What a publisher leaves for the thread of the connection, which makes messages of it and sends them.
#pragma once

#include <dds/dds.h>

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include <cca/dds/nodes/connection.hpp>
#include <cca/dds/nodes/message_topic.hpp>
#include <cca/dds/nodes/quality.hpp>
#include <cca/runtime/environments/exchange/sample_ring.hpp>

namespace cca::dds::detail {

// `Message` says how a message is made of numbers: ros2/messages, dds/space_message.hpp.
template <class Message, class Quality>
class outgoing final : public endpoint {
public:
  outgoing(std::shared_ptr<connection> over, const address& at)
      : net(std::move(over)),
        on(net->in(), at.topic, at.type, Message::type),
        writer(dds_create_writer(net->in().writes(),
                                 on.get(),
                                 qos_of(terms_of_writer<Message, Quality>, Message::type.hash).get(),
                                 nullptr),
               "publisher of `" + at.topic + "`") {
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
    std::uint64_t expected = next;
    for (; ring.take(next, std::numeric_limits<std::int64_t>::max(), one); expected = next) {
      const auto lost = static_cast<std::int64_t>(next - 1 - expected);
      const bool went = dds_write(writer.get(), message.make(one.vector.data(), one.origin)) >= 0;
      sent_count.fetch_add(went, std::memory_order_relaxed);
      dropped_count.fetch_add(lost + !went, std::memory_order_relaxed);
    }
    dropped_count.fetch_add(static_cast<std::int64_t>(next - expected), std::memory_order_relaxed);
  }

private:
  static constexpr int capacity = Message::size > 4096 ? 8 : 64;  // a picture takes room
  using ring_type = cca::detail::sample_ring<Message::size, capacity>;

  std::shared_ptr<connection> net;
  message_topic on;
  entity writer;
  ring_type ring;
  std::uint64_t next = 0;
  typename ring_type::sample one;
  typename Message::maker message;
  std::atomic<std::int64_t> sent_count{0}, dropped_count{0};
};

}  // namespace cca::dds::detail
