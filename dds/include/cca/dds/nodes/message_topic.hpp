// A topic in DDS whose messages are of a message_type. The descriptor that Cyclone needs is made here, no
// code generator is involved.
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <cca/dds/domain/channel.hpp>
#include <cca/dds/nodes/message_type.hpp>

namespace cca::dds::detail {

// The instructions by which Cyclone reads and writes a message. Nested messages of fixed number lie flat in
// plain CDR, so they need none of their own.
class instructions {
public:
  explicit instructions(const message_type& of) {
    add(of, 0);
    end();
  }
  const std::vector<std::uint32_t>& words() const { return all; }
  std::uint32_t count() const { return number; }

private:
  using number_32 = std::uint32_t;

  void add(const message_type& of, std::size_t base) {
    for (const message_field& f : of.fields) {
      const auto at = static_cast<number_32>(base + f.offset);
      if (f.count == message_field::sequence) add_sequence(f, at);
      else if (f.of == kind::message) add(*f.nested, at);
      else if (f.count > 1)
        put({op(DDS_OP_ADR, DDS_OP_TYPE_ARR, value_of(f.of) << 8, flags_of(f.of)), at,
             static_cast<number_32>(f.count)});
      else put({op(DDS_OP_ADR, value_of(f.of) << 16, flags_of(f.of)), at});
    }
  }
  void add_sequence(const message_field& f, number_32 at) {
    if (f.of != kind::message)
      return put({op(DDS_OP_ADR, DDS_OP_TYPE_SEQ, value_of(f.of) << 8, flags_of(f.of)), at});
    const std::size_t first = all.size();
    put({op(DDS_OP_ADR, DDS_OP_TYPE_SEQ, DDS_OP_SUBTYPE_STU), at, static_cast<number_32>(f.nested->size), 0});
    add(*f.nested, 0);
    end();
    all[first + 3] = static_cast<number_32>(all.size() - first) << 16 | 4u;  // after it, and the element
  }
  void put(std::initializer_list<number_32> instruction) {
    all.insert(all.end(), instruction);
    ++number;
  }
  void end() { put({number_32{DDS_OP_RTS}}); }

  static number_32 value_of(kind k) {
    if (k == kind::uint8) return DDS_OP_VAL_1BY;
    if (k == kind::int32 || k == kind::uint32) return DDS_OP_VAL_4BY;
    return k == kind::string ? DDS_OP_VAL_STR : DDS_OP_VAL_8BY;
  }
  static number_32 flags_of(kind k) {
    if (k == kind::float64) return DDS_OP_FLAG_FP;
    return k == kind::int32 || k == kind::int64 ? DDS_OP_FLAG_SGN : 0;
  }

  std::vector<number_32> all;
  std::uint32_t number = 0;
};

class message_topic {
public:
  // `name` and `type` as they are in DDS.
  message_topic(const participant& in, const std::string& name, std::string type, const message_type& of)
      : type_name(std::move(type)),
        program(of),
        about{.m_size = static_cast<std::uint32_t>(of.size),
              .m_align = static_cast<std::uint32_t>(of.alignment),
              .m_flagset = 0,
              .m_nkeys = 0,
              .m_typename = type_name.c_str(),
              .m_keys = nullptr,
              .m_nops = program.count(),
              .m_ops = program.words().data(),
              .m_meta = "",
              .type_information = {},
              .type_mapping = {},
              .restrict_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1},
        own(dds_create_topic(in.get(), &about, name.c_str(), nullptr, nullptr), "topic `" + name + "`") {}
  message_topic(const message_topic&) = delete;
  message_topic& operator=(const message_topic&) = delete;

  dds_entity_t get() const { return own.get(); }
  // What Cyclone has allocated in a message.
  void free_contents(void* message) const { dds_sample_free(message, &about, DDS_FREE_CONTENTS); }

private:
  std::string type_name;
  instructions program;
  dds_topic_descriptor_t about;
  entity own;
};

}  // namespace cca::dds::detail
