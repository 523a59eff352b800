// A type of messages as data: its name, and where its fields lie in the struct that holds a message. From
// this the descriptor for DDS is made (message_topic.hpp), and the length of a message that has come is
// checked. Of a type of ROS 2 it also has the published hash; tests compute it from the fields, as REP 2011
// demands: sha256 of the type's description.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace cca::dds::detail {

// The numbers that REP 2011 gives them.
enum class kind : std::uint8_t {
  message = 1,
  uint8 = 3,
  int32 = 6,
  uint32 = 7,
  int64 = 8,
  float64 = 11,
  string = 17
};

constexpr std::size_t bytes_of(kind k) {
  if (k == kind::uint8) return 1;
  return k == kind::int64 || k == kind::float64 ? 8 : 4;
}

struct message_type;

struct message_field {
  static constexpr int sequence = 0;  // as `count`: of any length

  std::string_view name;
  kind of;
  std::size_t offset;
  int count = 1;  // above 1: an array
  const message_type* nested = nullptr;
};

struct message_type {
  std::string_view name;  // "sensor_msgs/msg/JointState"
  std::span<const message_field> fields;
  std::size_t size, alignment;
  std::string_view hash{};  // of those of ROS 2 that have a topic
};

// As Cyclone and its generated code lay out a sequence.
template <class Type>
struct message_sequence {
  std::uint32_t maximum = 0, length = 0;
  Type* buffer = nullptr;
  bool release = false;

  std::span<Type> all() const { return {buffer, length}; }
};

// Of a sequence in a message.
template <class Type>
message_sequence<Type> borrowed(Type* first, std::size_t count) {
  const auto length = static_cast<std::uint32_t>(count);
  return {length, length, first, false};
}

// How many bytes a message takes in plain CDR (XCDR1), without its head of four. A longer one that has come
// is another message: Cyclone would take its beginning.
class cdr_length {
public:
  explicit cdr_length(const message_type& of, const void* message) { add(of, message); }
  std::size_t bytes() const { return at; }

private:
  void add(const message_type& of, const void* message) {
    for (const message_field& f : of.fields) {
      const auto* const here = static_cast<const std::byte*>(message) + f.offset;
      if (f.count != message_field::sequence) {
        add_all(f, here, static_cast<std::size_t>(f.count));
      } else {
        message_sequence<std::byte> all;
        std::memcpy(&all, here, sizeof all);
        put(4, 1);
        add_all(f, all.buffer, all.length);
      }
    }
  }
  void add_all(const message_field& f, const std::byte* first, std::size_t count) {
    if (f.of == kind::message) {
      for (std::size_t i = 0; i < count; ++i) add(*f.nested, first + i * f.nested->size);
    } else if (f.of == kind::string) {
      for (std::size_t i = 0; i < count; ++i) {
        const char* text = nullptr;
        std::memcpy(static_cast<void*>(&text), first + i * sizeof text, sizeof text);
        put(4, 1);
        at += std::strlen(text) + 1;
      }
    } else if (count > 0) {
      put(bytes_of(f.of), count);
    }
  }
  void put(std::size_t size, std::size_t count) { at = (at + size - 1) / size * size + size * count; }

  std::size_t at = 0;
};

}  // namespace cca::dds::detail
