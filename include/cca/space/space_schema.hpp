// What a message with a sample of a space contains: a number for each coordinate, with name and unit, and a
// hash by which two programs see whether they mean the same. Transports and recordings use it.
//
//   constexpr auto schema = cca::schema_of<leg_angles>;
//   schema.text();  // "float64 hip  # rad, -0.9 to 0.9\nfloat64 knee  # rad, -1.8 to 0\n"
//
// The hash covers domain type with its frame, names, units, limits and rate, and not the space's own name:
// spaces match whatever their names. It is the same on all compilers. Compile time only, but for `text`.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#include <cca/base/fixed_string.hpp>
#include <cca/space/info.hpp>

namespace cca {

// One number of a message. The layout is that of plain CDR, little endian, with 8-byte alignment (XCDR1).
struct schema_field {
  static constexpr std::size_t most_letters = 63;
  char letters[most_letters + 1] = {};
  std::size_t length = 0;
  std::string_view unit{};
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  int offset = 0;  // bytes after the first number

  constexpr std::string_view name() const { return {letters, length}; }

  // Letters, digits and underscores, as languages for messages demand.
  constexpr void append(std::string_view text) {
    for (const char c : text)
      if (length < most_letters) letters[length++] = is_letter(c) ? c : '_';
  }
  constexpr void append(int number) {
    if (number >= 10) append(number / 10);
    const char digit = static_cast<char>('0' + number % 10);
    append({&digit, 1});
  }

private:
  static constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  }
};

class space_schema {
public:
  constexpr explicit space_schema(const detail::space_info& of) : space(&of), hashed(hash_of_all()) {}

  constexpr std::string_view domain() const { return space->domain; }  // with its frame
  constexpr double hz() const { return space->hz; }                    // 0: the space states no rate
  constexpr int field_count() const { return space->size; }
  constexpr int bytes() const { return 8 * space->size; }
  // False: its numbers are no axes' and the domain type names none, so they are called c0, c1, ...
  constexpr bool has_names() const { return space->coordinates || space->size == space->axis_count; }
  constexpr std::uint64_t hash() const { return hashed; }

  constexpr schema_field field(int i) const {
    schema_field f;
    f.offset = 8 * i;
    const bool is_axis = space->size == space->axis_count;
    if (space->coordinates) f.append(space->coordinates[i]);
    else if (is_axis) f.append(space->labels[i]);
    else f.append("c"), f.append(i);
    f.unit = space->coordinate_units ? space->coordinate_units[i] : space->unit;
    if (is_axis) {
      f.lower = space->lower[i];
      f.upper = space->upper[i];
    }
    return f;
  }

  // A line for each number, as in a message of ROS 2: unit and limits are a comment.
  std::string text() const {
    std::ostringstream all;
    for (int i = 0; i < field_count(); ++i) {
      const schema_field f = field(i);
      all << "float64 " << f.name();
      const bool has_limits = f.lower > -std::numeric_limits<double>::infinity() ||
                              f.upper < std::numeric_limits<double>::infinity();
      if (!f.unit.empty() || has_limits) all << "  #";
      if (!f.unit.empty()) all << ' ' << f.unit;
      if (has_limits) all << (f.unit.empty() ? " " : ", ") << f.lower << " to " << f.upper;
      all << '\n';
    }
    return all.str();
  }

private:
  // Bit by bit: how a number is printed depends on the library.
  static constexpr std::uint64_t hash_of(double number, std::uint64_t seed) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (unsigned shift = 0; shift < 64; shift += 8) {
      const auto letter = static_cast<char>(bits >> shift & 0xff);
      seed = detail::hash({&letter, 1}, seed);
    }
    return seed;
  }
  constexpr std::uint64_t hash_of_all() const {
    std::uint64_t seed = hash_of(hz(), detail::hash(domain()));
    for (int i = 0; i < field_count(); ++i) {
      const schema_field f = field(i);
      seed = detail::hash("|", seed);
      seed = detail::hash(f.name(), seed);
      seed = detail::hash("|", seed);
      seed = detail::hash(f.unit, seed);
      seed = hash_of(f.upper, hash_of(f.lower, seed));
    }
    return seed;
  }

  const detail::space_info* space;
  std::uint64_t hashed;
};

template <class Space>
inline constexpr space_schema schema_of{detail::space_of<Space>};

}  // namespace cca
