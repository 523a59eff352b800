// Raw: Cyclone DDS by its C functions, reliable, the last sample kept, waiting on a waitset.
#pragma once

#include <dds/dds.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "processes.hpp"

namespace bench {

// This machine only, and enough participants for 16 reflectors.
inline void use_only_this_machine() {
  ::setenv("CYCLONEDDS_URI",
           "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface name=\"lo\" "
           "multicast=\"false\"/></Interfaces><AllowMulticast>false</AllowMulticast></General><Discovery>"
           "<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>60</MaxAutoParticipantIndex>"
           "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery></Domain></CycloneDDS>",
           0);
}

class cyclone {
public:
  explicit cyclone(std::size_t message)
      : bytes(message), name("bench_" + std::to_string(message)), taken(new unsigned char[message]{}) {
    use_only_this_machine();
    participant = checked(::dds_create_participant(domain, nullptr, nullptr));
    waitset = checked(::dds_create_waitset(participant));
  }
  ~cyclone() { ::dds_delete(participant); }
  cyclone(const cyclone&) = delete;
  cyclone& operator=(const cyclone&) = delete;

  dds_entity_t writer(const std::string& topic) {
    const quality of;
    return checked(::dds_create_writer(participant, make_topic(topic), of.kept.get(), nullptr));
  }
  dds_entity_t reader(const std::string& topic) {
    const quality of;
    const auto one = checked(::dds_create_reader(participant, make_topic(topic), of.kept.get(), nullptr));
    checked(::dds_waitset_attach(waitset, checked(::dds_create_readcondition(one, DDS_ANY_STATE)), 0));
    return one;
  }

  static void write(dds_entity_t writer, const void* message) { checked(::dds_write(writer, message)); }
  // The message number `n`, or any if n is 0. Null: nothing came within `ms`.
  const unsigned char* take(dds_entity_t reader, std::uint64_t n, int ms) {
    const std::int64_t until = nanoseconds() + ms * std::int64_t{1'000'000};
    for (;;) {
      void* buffer[1] = {taken.get()};
      dds_sample_info_t info{};
      if (::dds_take(reader, buffer, &info, 1, 1) > 0) {
        if (info.valid_data && (n == 0 || number_in(taken.get()) == n)) return taken.get();
        continue;
      }
      if (nanoseconds() > until) return nullptr;
      ::dds_waitset_wait(waitset, nullptr, 0, DDS_MSECS(20));
    }
  }
  static std::uint64_t number_in(const unsigned char* message) {
    std::uint64_t n = 0;
    std::memcpy(&n, message, sizeof n);
    return n;
  }

private:
  static constexpr dds_domainid_t domain = 77;

  struct quality {
    struct deleted {
      void operator()(dds_qos_t* q) const { ::dds_delete_qos(q); }
    };
    std::unique_ptr<dds_qos_t, deleted> kept{::dds_create_qos()};
    quality() {
      ::dds_qset_reliability(kept.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
      ::dds_qset_history(kept.get(), DDS_HISTORY_KEEP_LAST, 1);
    }
  };
  dds_entity_t make_topic(const std::string& topic) {
    return checked(::dds_create_topic(participant, &descriptor, topic.c_str(), nullptr, nullptr));
  }
  static dds_entity_t checked(dds_return_t result) {
    if (result < 0) throw std::runtime_error(std::string("Cyclone DDS: ") + ::dds_strretcode(result));
    return result;
  }

  std::size_t bytes;
  std::string name;
  std::unique_ptr<unsigned char[]> taken;
  std::array<std::uint32_t, 4> operations{
      std::uint32_t{DDS_OP_ADR} | std::uint32_t{DDS_OP_TYPE_ARR} | std::uint32_t{DDS_OP_SUBTYPE_8BY}, 0,
      static_cast<std::uint32_t>(bytes / 8), DDS_OP_RTS};
  dds_topic_descriptor_t descriptor{.m_size = static_cast<std::uint32_t>(bytes),
                                    .m_align = 8,
                                    .m_flagset = DDS_TOPIC_FIXED_SIZE,
                                    .m_nkeys = 0,
                                    .m_typename = name.c_str(),
                                    .m_keys = nullptr,
                                    .m_nops = 2,
                                    .m_ops = operations.data(),
                                    .m_meta = "",
                                    .type_information = {},
                                    .type_mapping = {},
                                    .restrict_data_representation = 0};
  dds_entity_t participant = 0, waitset = 0;
};

inline round_of_times raw_dds(int fan_out, std::size_t bytes, const amount& of) {
  static constexpr std::uint64_t end = ~std::uint64_t{0};
  const std::int64_t since = nanoseconds();
  // Names of this round alone: a round before, or another benchmark, may still be there.
  const std::string ping = "ping_" + std::to_string(::getpid()) + "_" + std::to_string(since);
  const auto pong = [&](int reflector) { return "pong" + std::to_string(reflector) + ping; };
  return in_processes(
      fan_out, of.round_trips,
      [&](int reflector) {
        stay_on(core_of(reflector + 1, fan_out));
        cyclone dds(bytes);
        const auto writer = dds.writer(pong(reflector)), reader = dds.reader(ping);
        while (const auto* message = dds.take(reader, 0, 10'000)) {
          if (dds.number_in(message) == end) return;
          dds.write(writer, message);
        }
      },
      [&](round_of_times& round) {
        stay_on(core_of(0, fan_out));
        cyclone dds(bytes);
        const auto writer = dds.writer(ping);
        std::vector<dds_entity_t> readers;
        for (int r = 0; r < fan_out; ++r) readers.push_back(dds.reader(pong(r)));
        const auto message = std::make_unique<unsigned char[]>(bytes);
        drive(round, of, since, [&](std::uint64_t n) {
          std::memcpy(message.get(), &n, sizeof n);
          dds.write(writer, message.get());
          for (const auto reader : readers) {
            int times = 0;  // while they don't know each other, messages are lost
            while (!dds.take(reader, n, n == 1 ? 50 : 2000)) {
              if (++times > (n == 1 ? 200 : 0)) throw std::runtime_error("Cyclone DDS: a message is lost");
              dds.write(writer, message.get());
            }
          }
          return true;
        });
        std::memcpy(message.get(), &end, sizeof end);
        dds.write(writer, message.get());
        ::usleep(100'000);  // until it has arrived
      });
}

}  // namespace bench
