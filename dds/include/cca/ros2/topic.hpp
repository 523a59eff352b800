// A topic of ROS 2 in DDS: `joint_states` is `rt/joint_states`, and `sensor_msgs/msg/JointState` is
// `sensor_msgs::msg::dds_::JointState_`. The descriptor that Cyclone needs is made from the message_type.
// Source: https://design.ros2.org/articles/topic_and_service_names.html.
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <cca/dds/channel.hpp>
#include <cca/ros2/message_type.hpp>

namespace cca::ros2::detail {

inline std::string type_name_in_dds(std::string_view name) {
  std::string all;
  std::string_view last = name;
  for (std::size_t slash; (slash = last.find('/')) != last.npos; last.remove_prefix(slash + 1))
    all += std::string(last.substr(0, slash)) + "::";
  return all + "dds_::" + std::string(last) + "_";
}

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
  static constexpr number_32 float_8 = cca::dds::detail::op(DDS_OP_TYPE_8BY, DDS_OP_FLAG_FP);

  void add(const message_type& of, std::size_t base) {
    for (const message_field& f : of.fields) {
      const auto at = static_cast<number_32>(base + f.offset);
      if (f.count == message_field::sequence) add_sequence(f, at);
      else if (f.of == kind::message) add(*f.nested, at);
      else if (f.count > 1) put({array_of(f.of), at, static_cast<number_32>(f.count)});
      else put({one_of(f.of), at});
    }
  }
  void add_sequence(const message_field& f, number_32 at) {
    if (f.of != kind::message) return put({sequence_of(f.of), at});
    const std::size_t first = all.size();
    put({cca::dds::detail::op(DDS_OP_ADR, DDS_OP_TYPE_SEQ, DDS_OP_SUBTYPE_STU), at,
         static_cast<number_32>(f.nested->size), 0});
    add(*f.nested, 0);
    end();
    all[first + 3] = static_cast<number_32>(all.size() - first) << 16 | 4u;  // behind it, and the element
  }
  void put(std::initializer_list<number_32> instruction) {
    all.insert(all.end(), instruction);
    ++number;
  }
  void end() { put({number_32{DDS_OP_RTS}}); }

  static number_32 one_of(kind k) {
    using cca::dds::detail::op;
    if (k == kind::int32) return op(DDS_OP_ADR, DDS_OP_TYPE_4BY, DDS_OP_FLAG_SGN);
    if (k == kind::uint32) return op(DDS_OP_ADR, DDS_OP_TYPE_4BY);
    if (k == kind::string) return op(DDS_OP_ADR, DDS_OP_TYPE_STR);
    return op(DDS_OP_ADR, float_8);
  }
  static number_32 array_of(kind k) {
    using cca::dds::detail::op;
    return k == kind::float64 ? op(DDS_OP_ADR, DDS_OP_TYPE_ARR, DDS_OP_SUBTYPE_8BY, DDS_OP_FLAG_FP)
                              : op(DDS_OP_ADR, DDS_OP_TYPE_ARR, DDS_OP_SUBTYPE_4BY);
  }
  static number_32 sequence_of(kind k) {
    using cca::dds::detail::op;
    if (k == kind::string) return op(DDS_OP_ADR, DDS_OP_TYPE_SEQ, DDS_OP_SUBTYPE_STR);
    return k == kind::float64 ? op(DDS_OP_ADR, DDS_OP_TYPE_SEQ, DDS_OP_SUBTYPE_8BY, DDS_OP_FLAG_FP)
                              : op(DDS_OP_ADR, DDS_OP_TYPE_SEQ, DDS_OP_SUBTYPE_4BY);
  }

  std::vector<number_32> all;
  std::uint32_t number = 0;
};

class topic {
public:
  topic(const cca::dds::detail::participant& in, std::string_view name, const message_type& of)
      : type_name(type_name_in_dds(of.name)),
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
        own(dds_create_topic(in.get(), &about, ("rt/" + std::string(name)).c_str(), nullptr, nullptr),
            "topic `rt/" + std::string(name) + "`") {}
  topic(const topic&) = delete;
  topic& operator=(const topic&) = delete;

  dds_entity_t get() const { return own.get(); }
  // What Cyclone has allocated in a message.
  void free_contents(void* message) const { dds_sample_free(message, &about, DDS_FREE_CONTENTS); }

private:
  std::string type_name;
  instructions program;
  dds_topic_descriptor_t about;
  cca::dds::detail::entity own;
};

}  // namespace cca::ros2::detail
