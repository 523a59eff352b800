// Topics whose messages are a fixed number of 64-bit words: doubles and integers, little or big endian as the
// machine that writes. The descriptor that Cyclone needs is made here, no code generator is involved.
//
// Cyclone drops a message that is shorter than its type. It would take the beginning of a longer one, so the
// length is compared here.
#pragma once

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <cca/dds/domain/participant.hpp>

namespace cca::dds::detail {

using words = std::vector<std::uint64_t>;

// One instruction of a type's descriptor.
constexpr std::uint32_t op(auto... parts) { return (static_cast<std::uint32_t>(parts) | ...); }

class topic {
public:
  topic(const participant& in, const std::string& name, const std::string& type, std::size_t size)
      : ops{op(DDS_OP_ADR, DDS_OP_TYPE_ARR, DDS_OP_SUBTYPE_8BY), 0, static_cast<std::uint32_t>(size),
            DDS_OP_RTS} {
    const dds_topic_descriptor_t descriptor{.m_size = static_cast<std::uint32_t>(8 * size),
                                            .m_align = 8,
                                            .m_flagset = DDS_TOPIC_FIXED_SIZE,
                                            .m_nkeys = 0,
                                            .m_typename = type.c_str(),
                                            .m_keys = nullptr,
                                            .m_nops = 2,
                                            .m_ops = ops.data(),
                                            .m_meta = "",
                                            .type_information = {},
                                            .type_mapping = {},
                                            .restrict_data_representation = 0};
    own = {dds_create_topic(in.get(), &descriptor, name.c_str(), nullptr, nullptr), "topic `" + name + "`"};
  }
  dds_entity_t get() const { return own.get(); }

private:
  std::array<std::uint32_t, 4> ops;
  entity own;
};

class channel_writer {
public:
  channel_writer(const participant& in,
                 const std::string& name,
                 const std::string& type,
                 std::size_t size,
                 std::int32_t depth)
      : on(in, name, type, size),
        own(dds_create_writer(in.writes(), on.get(), quality::of_writer(depth).get(), nullptr),
            "writer of `" + name + "`") {}

  // False: a reader holds it up, and it has to be tried again.
  bool write(const words& message) const { return dds_write(own.get(), message.data()) == DDS_RETCODE_OK; }
  // At the end: until those that still listen have everything.
  void wait_for_readers() const { dds_wait_for_acks(own.get(), DDS_MSECS(200)); }

private:
  topic on;
  entity own;
};

// Where a message comes from. Names of participants are kept, because a writer that has ended is unknown to
// DDS.
class sources {
public:
  explicit sources(dds_entity_t of) : reader(of) {}

  identity of(dds_instance_handle_t writer) {
    for (const auto& [handle, from] : known)
      if (handle == writer) return from;
    dds_builtintopic_endpoint_t* const found = dds_get_matched_publication_data(reader, writer);
    if (!found) return {};
    const identity from = identity_of(found->participant_key);
    dds_builtintopic_free_endpoint(found);
    if (known.size() == most) known.erase(known.begin());
    known.emplace_back(writer, from);
    return from;
  }

private:
  static constexpr std::size_t most = 64;
  dds_entity_t reader;
  std::vector<std::pair<dds_instance_handle_t, identity>> known;
};

class channel_reader {
public:
  channel_reader(const participant& in, const std::string& name, const std::string& type, std::size_t size)
      : on(in, name, type, size),
        own(dds_create_reader(in.reads(), on.get(), quality::of_reader(most_untaken).get(), nullptr),
            "reader of `" + name + "`"),
        from(own.get()),
        message(size) {}

  dds_entity_t get() const { return own.get(); }

  // take(message, identity of the sender) for each that has come, up to what the reader keeps: a flood ends
  // here. An empty message: it was no message of this length.
  template <class F>
  void take_all(F take) {
    for (int batch = 0; batch < most_untaken / 16; ++batch) {
      ddsi_serdata* some[16];
      dds_sample_info_t about[16];
      const int count = dds_takecdr(own.get(), some, 16, about, DDS_ANY_STATE);
      if (count <= 0) return;
      for (int i = 0; i < count; ++i) {
        const bool is_whole = about[i].valid_data && ddsi_serdata_size(some[i]) == 4 + 8 * message.size() &&
                              ddsi_serdata_to_sample(some[i], message.data(), nullptr, nullptr);
        const bool is_message = about[i].valid_data;
        ddsi_serdata_unref(some[i]);
        if (is_message)
          take(is_whole ? std::span<const std::uint64_t>(message) : std::span<const std::uint64_t>(),
               from.of(about[i].publication_handle));
      }
    }
  }

private:
  static constexpr std::int32_t most_untaken = 1024;

  topic on;
  entity own;
  sources from;
  words message;
};

}  // namespace cca::dds::detail
