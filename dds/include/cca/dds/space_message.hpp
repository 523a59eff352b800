// A sample of any space as a message for other programs; `cca::idl<Space>()` is its type as IDL.
//
//   space    which space it is, as `cca::idl` gives it: a sample of another one is refused
//   age      ns from the origin of the sample until it was sent; clocks of two machines are not compared
//   values   the coordinates in the order of the space
//
// Refused: another space, an age below zero, a number that is not finite, and what space_guard.hpp names.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <cca/base/array_size.hpp>
#include <cca/dds/nodes/message_type.hpp>
#include <cca/dds/nodes/space_guard.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::dds::detail {

// 63 bits: a constant of this size has the same meaning in every language that IDL is translated to. It is
// computed at run time, because a picture has thousands of numbers.
template <class Space>
std::int64_t space_number() {
  static const auto number =
      static_cast<std::int64_t>(space_schema(cca::detail::space_of<Space>).hash() >> 1);
  return number;
}

template <int Size>
struct numbered_sample {
  std::int64_t space = 0, age = 0;
  std::array<double, cca::detail::array_size(Size)> values{};
};
template <int Size>
inline constexpr std::array numbered_sample_fields{
    message_field{"space", kind::int64, offsetof(numbered_sample<Size>, space)},
    message_field{"age", kind::int64, offsetof(numbered_sample<Size>, age)},
    message_field{"values", kind::float64, offsetof(numbered_sample<Size>, values), Size},
};

template <class Space>
struct space_message {
  using message = numbered_sample<Space::size>;
  static constexpr int size = Space::size;
  static constexpr std::size_t most_bytes = sizeof(message) + 64;
  static constexpr message_type type{"", numbered_sample_fields<size>, sizeof(message), alignof(message)};

  class maker {
  public:
    maker() { made.space = space_number<Space>(); }
    maker(const maker&) = delete;
    maker& operator=(const maker&) = delete;

    const message* make(const double* from, std::int64_t age) {
      made.age = age;
      std::copy_n(from, size, made.values.begin());
      return &made;
    }

  private:
    message made;
  };

  // Null, or why it is refused.
  static const char* read(const message& m, double* to) {
    if (m.space != space_number<Space>()) return "a sample of another space";
    if (m.age < 0 || m.age > longest_age) return "an age that can't be";
    std::copy_n(m.values.begin(), size, to);
    return space_guard<typename Space::domain>::refuse(to, Space::axes::count);
  }
  static std::int64_t age_of(const message& m) { return m.age; }

private:
  static constexpr std::int64_t longest_age = std::int64_t{1} << 61;
};

}  // namespace cca::dds::detail
