// std_msgs/Float64MultiArray, of any space.
//
//   float64_multi_array<motor_currents>   port "data": the coordinates in the order of the axes
//
// The layout has one dimension, whose label is the names of the coordinates: "hip,knee". A message with
// another number of coordinates or another layout is refused. An empty layout or an empty label is accepted:
// messages published by hand often have them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <cca/base/array_size.hpp>
#include <cca/ros2/messages/header.hpp>
#include <cca/ros2/messages/ports.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::ros2 {

namespace detail {

struct array_dimension {
  char* label = nullptr;
  std::uint32_t size = 0, stride = 0;
};
inline constexpr std::array array_dimension_fields{
    message_field{"label", kind::string, offsetof(array_dimension, label)},
    message_field{"size", kind::uint32, offsetof(array_dimension, size)},
    message_field{"stride", kind::uint32, offsetof(array_dimension, stride)},
};
inline constexpr message_type array_dimension_type{"std_msgs/msg/MultiArrayDimension", array_dimension_fields,
                                                   sizeof(array_dimension), alignof(array_dimension)};

struct array_layout {
  message_sequence<array_dimension> dim;
  std::uint32_t data_offset = 0;
};
inline constexpr std::array array_layout_fields{
    message_field{"dim", kind::message, offsetof(array_layout, dim), message_field::sequence,
                  &array_dimension_type},
    message_field{"data_offset", kind::uint32, offsetof(array_layout, data_offset)},
};
inline constexpr message_type array_layout_type{"std_msgs/msg/MultiArrayLayout", array_layout_fields,
                                                sizeof(array_layout), alignof(array_layout)};

struct array_message {
  array_layout layout;
  message_sequence<double> data;
};
inline constexpr std::array array_message_fields{
    message_field{"layout", kind::message, offsetof(array_message, layout), 1, &array_layout_type},
    message_field{"data", kind::float64, offsetof(array_message, data), message_field::sequence},
};

}  // namespace detail

template <class Space>
struct float64_multi_array {
  using ports = detail::port_list<detail::message_port<"data", Space>>;
  using message = detail::array_message;
  static constexpr int size = Space::size;
  static constexpr detail::message_type type{
      "std_msgs/msg/Float64MultiArray", detail::array_message_fields, sizeof(message), alignof(message),
      "RIHS01_1025ddc6b9552d191f89ef1a8d2f60f3d373e28b283d8891ddcc974e8c55397f"};

  class maker {
  public:
    maker() : dimension{label.data(), count, count} {
      made.layout.dim = detail::borrowed(&dimension, 1);
      made.data = detail::borrowed(values.data(), values.size());
    }
    maker(const maker&) = delete;
    maker& operator=(const maker&) = delete;

    const message* make(const double* from, std::int64_t) {  // this message has no stamp
      std::copy_n(from, size, values.begin());
      return &made;
    }

  private:
    std::string label = names();
    detail::array_dimension dimension;
    std::array<double, cca::detail::array_size(size)> values{};
    message made;
  };

  static const char* read(const message& m, double* to) {
    static const std::string wanted = names();
    if (m.data.length != count) return "another number of coordinates";
    if (m.layout.data_offset != 0 || m.layout.dim.length > 1) return "a layout of something else";
    for (const auto& d : m.layout.dim.all())
      if (d.size != count || (*d.label != '\0' && d.label != wanted)) return "a layout of something else";
    std::copy_n(m.data.buffer, size, to);
    return nullptr;
  }

private:
  static constexpr std::uint32_t count = static_cast<std::uint32_t>(size);

  static std::string names() {
    std::string all;
    for (int i = 0; i < size; ++i) all += (i == 0 ? "" : ",") + std::string(schema_of<Space>.field(i).name());
    return all;
  }
};

}  // namespace cca::ros2
