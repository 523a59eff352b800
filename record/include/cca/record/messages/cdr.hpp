// Plain CDR, little endian (XCDR1): what ROS 2 sends. Numbers are aligned to their size, counted from after
// the four bytes of the head. Neither writer nor reader allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace cca::recording::detail {

inline constexpr std::size_t cdr_head = 4;

// Into memory that is large enough, or, without memory, only counts. What does not fit is not written.
class cdr_writer {
public:
  explicit cdr_writer(std::span<unsigned char> memory) : to(memory) {
    constexpr unsigned char head[cdr_head] = {0, 1, 0, 0};
    put(head, sizeof head);
  }

  template <class Number>
  cdr_writer& add(Number number) {
    align(sizeof number);
    put(&number, sizeof number);
    return *this;
  }
  cdr_writer& add(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size() + 1));
    put(text.data(), text.size());
    put("", 1);
    return *this;
  }

  std::size_t size() const { return used; }
  std::span<const unsigned char> view() const { return to.first(used < to.size() ? used : to.size()); }

private:
  void align(std::size_t size) {
    constexpr unsigned char zeros[8] = {};
    const std::size_t past = (used - cdr_head) % size;
    if (past > 0) put(zeros, size - past);
  }
  void put(const void* from, std::size_t size) {
    if (used + size <= to.size()) std::memcpy(to.data() + used, from, size);
    used += size;
  }

  std::span<unsigned char> to;
  std::size_t used = 0;
};

// Behind a mistake everything that is read is zero or empty.
class cdr_reader {
public:
  explicit cdr_reader(std::span<const unsigned char> message) : from(message) {
    bad = from.size() < cdr_head || from[0] != 0 || from[1] != 1;
    at = cdr_head;
  }

  template <class Number>
  Number number() {
    const std::size_t past = (at - cdr_head) % sizeof(Number);
    Number value{};
    const auto bytes = block((past > 0 ? sizeof(Number) - past : 0), sizeof(Number));
    if (!bytes.empty()) std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }
  std::string_view text() {
    const auto size = number<std::uint32_t>();
    const auto bytes = block(0, size);
    if (bytes.empty() || bytes.back() != 0) return bad = true, std::string_view{};
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size() - 1};
  }
  bool is_bad() const { return bad; }
  bool is_at_end() const { return !bad && at == from.size(); }

private:
  std::span<const unsigned char> block(std::size_t skipped, std::size_t size) {
    if (bad || skipped > from.size() - at || size > from.size() - at - skipped)
      return bad = true, std::span<const unsigned char>{};
    at += skipped + size;
    return from.subspan(at - size, size);
  }

  std::span<const unsigned char> from;
  std::size_t at = 0;
  bool bad = false;
};

}  // namespace cca::recording::detail
