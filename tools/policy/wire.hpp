// The wire format of protocol buffers, as ONNX files have it: fields one after the other. Every length is
// compared with what is left of the file before anything is taken, so nothing is allocated for a lie.
// Source: protobuf.dev/programming-guides/encoding.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/refused.hpp>

namespace cca_policy {

[[noreturn]] inline void refuse(const std::string& why) { throw cca::refused(why); }

class message {
public:
  explicit message(std::string_view all) : rest_(all) {}

  // The next field; false: no more. Groups, which protobuf 3 does not have, are refused.
  bool next() {
    if (rest_.empty()) return false;
    const std::uint64_t key = varint();
    if (key >> 32 || key >> 3 == 0) refuse("not an ONNX file, or damaged: a field without a number");
    field = static_cast<std::uint32_t>(key >> 3);
    number = 0;
    bytes = {};
    is_bytes = (key & 7) == 2;
    switch (key & 7) {
      case 0:
        number = varint();
        return true;
      case 1:
        number = fixed<std::uint64_t>();
        return true;
      case 2:
        bytes = take(varint());
        return true;
      case 5:
        number = fixed<std::uint32_t>();
        return true;
      default:
        refuse("not an ONNX file, or damaged: field " + std::to_string(field) + " has an unknown wire type");
    }
  }

  std::uint32_t field = 0;
  std::uint64_t number = 0;  // of a varint or a fixed width
  std::string_view bytes;    // of what has a length
  bool is_bytes = false;

  std::string text() const {
    if (!is_bytes) refuse("damaged: field " + std::to_string(field) + " is no text");
    return std::string(bytes);
  }
  std::string_view inner() const {
    if (!is_bytes) refuse("damaged: field " + std::to_string(field) + " is no message");
    return bytes;
  }
  float real() const { return std::bit_cast<float>(static_cast<std::uint32_t>(number)); }
  std::int64_t whole() const { return static_cast<std::int64_t>(number); }

  // Repeated numbers: packed, or one field each.
  template <class Add>
  void each_varint(Add add) const {
    if (!is_bytes) return add(number);
    for (message packed(bytes); !packed.rest_.empty();) add(packed.varint());
  }
  template <class Word, class Add>
  void each_fixed(Add add) const {
    if (!is_bytes) return add(static_cast<Word>(number));
    if (bytes.size() % sizeof(Word) != 0) refuse("damaged: packed numbers that end within one");
    for (message packed(bytes); !packed.rest_.empty();) add(packed.fixed<Word>());
  }

private:
  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 70; shift += 7) {
      const auto byte = static_cast<unsigned char>(take(1)[0]);
      if (shift < 64) value |= static_cast<std::uint64_t>(byte & 127u) << shift;
      if (byte < 128) return value;
    }
    refuse("damaged: a number of more than ten bytes");
  }
  template <class Word>
  Word fixed() {
    const std::string_view from = take(sizeof(Word));
    Word value = 0;
    for (std::size_t i = 0; i < sizeof(Word); ++i)
      value |= static_cast<Word>(static_cast<unsigned char>(from[i])) << (8 * i);
    return value;
  }
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) refuse("damaged: it ends too early");
    const auto taken = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(static_cast<std::size_t>(count));
    return taken;
  }

  std::string_view rest_;
};

}  // namespace cca_policy
