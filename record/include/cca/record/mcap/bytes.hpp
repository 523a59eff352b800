// Bytes of a file: numbers are little endian, and a text or a block begins with its length.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace cca::recording::detail {

static_assert(std::endian::native == std::endian::little, "cca::record: only on little-endian machines");

using byte_view = std::span<const unsigned char>;
using text_map = std::map<std::string, std::string>;

inline byte_view bytes_of(std::string_view text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

class byte_writer {
public:
  template <class Number>
    requires std::is_arithmetic_v<Number>
  byte_writer& add(Number number) {
    return add_raw(&number, sizeof number);
  }
  byte_writer& add(std::string_view text) {
    return add(static_cast<std::uint32_t>(text.size())).add_raw(text.data(), text.size());
  }
  byte_writer& add(const text_map& map) {
    byte_writer entries;
    for (const auto& [key, value] : map) entries.add(key).add(value);
    return add(static_cast<std::uint32_t>(entries.size())).add(entries.view());
  }
  byte_writer& add(byte_view bytes) { return add_raw(bytes.data(), bytes.size()); }
  byte_writer& add_raw(const void* from, std::size_t size) {
    const std::size_t end = all.size();
    all.resize(end + size);
    if (size > 0) std::memcpy(all.data() + end, from, size);
    return *this;
  }

  byte_view view() const { return all; }
  std::size_t size() const { return all.size(); }
  void clear() { all.clear(); }

private:
  std::vector<unsigned char> all;
};

// Behind a mistake everything that is read is zero or empty.
class byte_reader {
public:
  explicit byte_reader(byte_view of) : left(of) {}

  template <class Number>
    requires std::is_arithmetic_v<Number>
  Number number() {
    Number value{};
    if (const byte_view from = block(sizeof value); !from.empty())
      std::memcpy(&value, from.data(), sizeof value);
    return value;
  }
  std::string text() {
    const byte_view from = block(number<std::uint32_t>());
    return {from.begin(), from.end()};
  }
  text_map texts() {
    byte_reader entries(block(number<std::uint32_t>()));
    text_map all;
    while (!entries.is_bad() && entries.size() > 0) {
      std::string key = entries.text();
      all[std::move(key)] = entries.text();
    }
    bad = bad || entries.is_bad();
    return all;
  }
  byte_view block(std::uint64_t size) {
    if (bad || size > left.size()) return bad = true, byte_view{};
    const byte_view result = left.first(static_cast<std::size_t>(size));
    left = left.subspan(static_cast<std::size_t>(size));
    return result;
  }
  byte_view rest() { return block(left.size()); }

  std::size_t size() const { return left.size(); }
  bool is_bad() const { return bad; }

private:
  byte_view left;
  bool bad = false;
};

}  // namespace cca::recording::detail
