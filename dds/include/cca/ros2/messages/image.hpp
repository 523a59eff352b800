// sensor_msgs/Image, of a space with a number for each channel of each pixel: row by row, from the left, the
// channels of a pixel beside each other.
//
//   struct gray : cca::record<64 * 48> {};
//   struct picture : cca::space<gray, cca::axes<camera>> {};
//   image<picture, 64, 48, "mono8">          port "image"
//
//   encoding                numbers of a pixel   each
//   mono8, 8UC1             1                    0 to 255
//   rgb8, bgr8              3                    0 to 255
//   rgba8, bgra8            4                    0 to 255
//   mono16, 16UC1           1                    0 to 65535; 16UC1 as a depth in mm
//   32FC1                   1                    any; as a depth in m
//
// frame_id is the frame of the space's domain type, if it has one. What is sent is rounded to the nearest
// whole number in the range, and what is not finite is sent as 0, but for 32FC1, which is sent as it is. Of a
// picture that comes, a pixel of 32FC1 that is not finite becomes 0, which means "nothing measured" (REP
// 118). Refused: another size, encoding or frame, and lengths that do not fit each other.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <cca/base/array_size.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/ros2/messages/header.hpp>
#include <cca/ros2/messages/message_mistakes.hpp>
#include <cca/ros2/messages/ports.hpp>

namespace cca::ros2 {

namespace detail {

struct image_message {
  header head;
  std::uint32_t height = 0, width = 0;
  char* encoding = nullptr;
  std::uint8_t is_bigendian = 0;
  std::uint32_t step = 0;
  message_sequence<std::uint8_t> data;
};
inline constexpr std::array image_fields{
    message_field{"header", kind::message, offsetof(image_message, head), 1, &header_type},
    message_field{"height", kind::uint32, offsetof(image_message, height)},
    message_field{"width", kind::uint32, offsetof(image_message, width)},
    message_field{"encoding", kind::string, offsetof(image_message, encoding)},
    message_field{"is_bigendian", kind::uint8, offsetof(image_message, is_bigendian)},
    message_field{"step", kind::uint32, offsetof(image_message, step)},
    message_field{"data", kind::uint8, offsetof(image_message, data), message_field::sequence},
};

struct pixel_format {
  std::string_view name;
  int channels = 0, bytes = 0;
};
inline constexpr std::array pixel_formats{
    pixel_format{"mono8", 1, 1},  pixel_format{"8UC1", 1, 1},  pixel_format{"rgb8", 3, 1},
    pixel_format{"bgr8", 3, 1},   pixel_format{"rgba8", 4, 1}, pixel_format{"bgra8", 4, 1},
    pixel_format{"mono16", 1, 2}, pixel_format{"16UC1", 1, 2}, pixel_format{"32FC1", 1, 4},
};
constexpr pixel_format format_named(std::string_view name) {
  for (const auto& one : pixel_formats)
    if (one.name == name) return one;
  return {};
}

// One number of a picture, as it lies in its bytes.
template <int Bytes>
struct channel_bytes;
template <>
struct channel_bytes<1> {
  static constexpr double most = 255;
  static void put(double value, std::uint8_t* to) { *to = static_cast<std::uint8_t>(value); }
  static double get(const std::uint8_t* from, bool) { return *from; }
};
template <>
struct channel_bytes<2> {
  static constexpr double most = 65535;
  static void put(double value, std::uint8_t* to) {
    const auto number = static_cast<std::uint16_t>(value);
    std::memcpy(to, &number, sizeof number);
  }
  static double get(const std::uint8_t* from, bool is_big) {
    return is_big ? from[0] * 256 + from[1] : from[1] * 256 + from[0];
  }
};
template <>
struct channel_bytes<4> {
  static void put(double value, std::uint8_t* to) {
    const auto number = static_cast<float>(value);
    std::memcpy(to, &number, sizeof number);
  }
  static double get(const std::uint8_t* from, bool is_big) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) bits = bits << 8 | from[is_big ? i : 3 - i];
    const auto number = std::bit_cast<float>(bits);
    return std::isfinite(number) ? number : 0;
  }
};

template <fixed_string Encoding>
struct unknown_encoding {
  static constexpr void tell(auto& m) {
    m << "cca::ros2::image: the encoding `" << Encoding.view() << "` is unknown: take ";
    std::size_t n = 0;
    for (const auto& one : pixel_formats)
      m << (n++ == 0 ? "" : n == pixel_formats.size() ? " or " : ", ") << one.name;
  }
};
template <class Space, int Width, int Height, fixed_string Encoding>
struct other_pixels {
  static constexpr void tell(auto& m) {
    constexpr int channels = format_named(Encoding.view()).channels;
    m << "space.mismatch: " << cca::detail::space_in_words<Space>() << " has " << Space::size
      << (Space::size == 1 ? " number" : " numbers") << ", and a cca::ros2::image of " << Width << " x "
      << Height << " pixels with " << channels << (channels == 1 ? " channel" : " channels") << " each ("
      << Encoding.view() << ") has " << Width * Height * channels
      << ": give the space as many, or the image another size";
  }
};

}  // namespace detail

template <class Space, int Width, int Height, fixed_string Encoding>
struct image {
  static constexpr auto format = detail::format_named(Encoding.view());
  static_assert(cca::detail::holds_or_tells<(format.bytes > 0), detail::unknown_encoding<Encoding>>::value);
  static_assert(
      cca::detail::holds_or_tells<(format.bytes == 0 || Space::size == Width * Height * format.channels),
                                  detail::other_pixels<Space, Width, Height, Encoding>>::value);

  using ports = detail::port_list<detail::message_port<"image", Space>>;
  using message = detail::image_message;
  static constexpr int size = Space::size;
  static constexpr std::size_t row = cca::detail::array_size(Width * format.channels * format.bytes);
  static constexpr std::size_t most_bytes = 2 * row * Height + 65'536;  // rows may be padded
  static constexpr detail::message_type type{
      "sensor_msgs/msg/Image", detail::image_fields, sizeof(message), alignof(message),
      "RIHS01_d31d41a9a4c4bc8eae9be757b0beed306564f7526c88ea6a4588fb9582527d47"};

  // Holds what a message points to.
  class maker {
  public:
    maker() {
      made.head.frame_id = frame.data();
      made.height = Height;
      made.width = Width;
      made.encoding = encoding.data();
      made.is_bigendian = std::endian::native == std::endian::big;
      made.step = static_cast<std::uint32_t>(row);
      made.data = detail::borrowed(bytes.data(), bytes.size());
    }
    maker(const maker&) = delete;
    maker& operator=(const maker&) = delete;

    const message* make(const double* from, std::int64_t age) {
      made.head.stamp = detail::stamp_of(age);
      for (int i = 0; i < size; ++i) channel::put(sendable(from[i]), bytes.data() + at(i));
      return &made;
    }

  private:
    std::string frame = wanted_frame(), encoding{Encoding.view()};
    std::array<std::uint8_t, row * Height> bytes{};
    message made;
  };

  // Null, or why it is refused.
  static const char* read(const message& m, double* to) {
    static const std::string wanted = wanted_frame();
    if (!wanted.empty() && !detail::is_frame(m.head.frame_id, wanted)) return "another frame_id";
    if (m.width != Width || m.height != Height) return "a picture of another size";
    if (m.encoding != Encoding.view()) return "another encoding";
    if (m.step < row || std::uint64_t{m.step} * Height != m.data.length)
      return "lengths that do not fit the picture";
    for (int y = 0; y < Height; ++y) {
      const std::uint8_t* pixel = m.data.buffer + std::size_t{m.step} * cca::detail::array_size(y);
      for (std::size_t i = 0; i < row; i += format.bytes)
        *to++ = channel::get(pixel + i, m.is_bigendian != 0);
    }
    return nullptr;
  }

private:
  using channel = detail::channel_bytes<format.bytes == 0 ? 1 : format.bytes>;

  static constexpr std::size_t at(int i) { return cca::detail::array_size(i * format.bytes); }
  static double sendable(double value) {
    if constexpr (format.bytes == 4) return value;
    else return std::isfinite(value) ? std::clamp(math::floor(value + 0.5), 0.0, channel::most) : 0;
  }
  static std::string wanted_frame() {
    return detail::frame_name<typename detail::frame_along<typename Space::domain>::type>();
  }
};

}  // namespace cca::ros2
