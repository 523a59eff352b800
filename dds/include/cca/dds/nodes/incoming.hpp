// What the thread of the connection receives for a subscriber: it checks each message, and leaves the numbers
// of the newest for the beat.
//
// A message waits at most 0.1 s of wall-clock time for a beat. So a controller that was stopped or faulted
// does not go on with an old command. Of `transient_local` it waits as long as it takes.
#pragma once

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include <cca/dds/nodes/connection.hpp>
#include <cca/dds/nodes/message_topic.hpp>
#include <cca/dds/nodes/quality.hpp>
#include <cca/runtime/environments/exchange/sample_ring.hpp>
#include <cca/runtime/pace.hpp>

namespace cca::dds::detail {

// What `Message::read` says of a message that is meant for others: it is neither used nor refused.
inline constexpr char is_for_others[] = "";

// `Message` says how numbers are read from a message: ros2/messages, dds/space_message.hpp.
template <class Message, class Quality>
class incoming final : public endpoint {
public:
  incoming(std::shared_ptr<connection> over, const address& at)
      : net(std::move(over)),
        on(net->in(), at.topic, at.type, Message::type),
        reader(dds_create_reader(net->in().reads(),
                                 on.get(),
                                 qos_of(terms_of_reader<Message, Quality>, Message::type.hash).get(),
                                 nullptr),
               "subscriber of `" + at.topic + "`") {
    net->listen_to(reader.get());
    net->add(*this);
  }
  ~incoming() override { net->remove(*this); }

  using vector_type = Eigen::Matrix<double, Message::size, 1>;

  // The beat's: the newest message since it last asked, and its age in ns as its sender says. False: there is
  // none, and `to` may hold anything.
  bool take(vector_type& to, std::int64_t& age) noexcept {
    bool has = false;
    taken_sample one{0, 0, to};
    for (int i = 0; i < 2 * capacity && ring.take(next, everything, one); ++i) {
      has = one.published_in == is_message;
      age = one.origin;
    }
    taken.store(next, std::memory_order_relaxed);
    return has;
  }
  // At a start: what came before is too old.
  void forget() noexcept {
    if constexpr (is_kept<Quality>) return;
    vector_type unused;
    std::int64_t age = 0;
    take(unused, age);
  }

  std::int64_t received() const { return received_count.load(std::memory_order_relaxed); }
  std::int64_t refused() const { return refused_count.load(std::memory_order_relaxed); }
  std::int64_t too_late() const { return late_count.load(std::memory_order_relaxed); }
  // Of the newest one that was refused; empty: none was.
  std::string_view why_refused() const {
    const char* const why = reason.load(std::memory_order_acquire);
    return why ? why : "";
  }

  void work() override {
    expire();
    ddsi_serdata* some[16];
    dds_sample_info_t about[16];
    const int count = dds_takecdr(reader.get(), some, 16, about, DDS_ANY_STATE);
    for (int i = 0; i < count; ++i) {
      if (about[i].valid_data) hear(*some[i]);
      ddsi_serdata_unref(some[i]);
    }
  }

private:
  static constexpr int capacity = 4;
  static constexpr std::int64_t everything = std::numeric_limits<std::int64_t>::max();
  static constexpr std::int64_t is_message = 0, is_nothing = 1;
  static constexpr std::int64_t longest_wait = 100'000'000;
  static constexpr std::uint32_t head = 4, most_padding = 3;
  // A message whose size is known, as a picture, may be longer than the others.
  static constexpr std::uint32_t most_bytes = [] {
    if constexpr (requires { Message::most_bytes; })
      return std::max<std::uint32_t>(65'536, static_cast<std::uint32_t>(Message::most_bytes));
    else return std::uint32_t{65'536};
  }();

  struct taken_sample {
    std::int64_t published_in, origin;
    vector_type& vector;
  };

  // A reason is a literal, so other threads may read it.
  void hear(const ddsi_serdata& one) {
    std::int64_t age = 0;
    if (const char* const why = read(one, age)) {
      if (why == is_for_others) return;
      reason.store(why, std::memory_order_release);
      refused_count.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    put(age, is_message);
    received_count.fetch_add(1, std::memory_order_relaxed);
  }
  // Null, or why it is refused.
  const char* read(const ddsi_serdata& one, std::int64_t& age) {
    const std::uint32_t size = ddsi_serdata_size(&one);
    if (size > most_bytes)
      return most_bytes == 65'536 ? "longer than 65536 bytes" : "longer than a message of this type can be";
    message = {};
    const char* why = "no message of this type";
    if (ddsi_serdata_to_sample(&one, &message, nullptr, nullptr)) {
      const std::size_t whole = head + cdr_length(Message::type, &message).bytes();
      why = size < whole || size > whole + most_padding ? "longer than a message of this type"
                                                        : Message::read(message, values.data());
      if constexpr (requires { Message::age_of(message); }) age = Message::age_of(message);
    }
    on.free_contents(&message);
    if (!why && !values.allFinite()) why = "a number that is not finite";
    return why;
  }
  void put(std::int64_t age, std::int64_t what) {
    ring.put(values, age, what);
    ++count_put;
    put_at = cca::detail::monotonic_clock::now();
    is_waiting = what == is_message;
  }
  void expire() {
    if (is_kept<Quality> || !is_waiting) return;
    if (taken.load(std::memory_order_relaxed) >= count_put) {
      is_waiting = false;
    } else if (cca::detail::monotonic_clock::now() - put_at > longest_wait) {
      put(0, is_nothing);
      late_count.fetch_add(1, std::memory_order_relaxed);
    }
  }

  std::shared_ptr<connection> net;
  message_topic on;
  entity reader;
  cca::detail::sample_ring<Message::size, capacity> ring;
  std::uint64_t next = 0;               // the beat's
  std::atomic<std::uint64_t> taken{0};  // the same, for the thread
  typename Message::message message{};  // the thread's
  vector_type values = vector_type::Zero();
  std::uint64_t count_put = 0;
  std::int64_t put_at = 0;
  bool is_waiting = false;
  std::atomic<std::int64_t> received_count{0}, refused_count{0}, late_count{0};
  std::atomic<const char*> reason{nullptr};
};

}  // namespace cca::dds::detail
