// The hashes of the types, computed as REP 2011 says from the fields that the library states: sha256 of the
// description as JSON. They are the published ones.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <string>

#include "spaces.hpp"

using namespace ros2_test;
using cca::ros2::detail::kind;
using cca::ros2::detail::message_field;
using cca::ros2::detail::message_type;

namespace {

// FIPS 180-4, sections 5.1.1 and 6.2.
std::string sha256(std::string text) {
  static constexpr std::array<std::uint32_t, 64> k{
      0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
      0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
      0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
      0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
      0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
      0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
      0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
      0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};
  std::array<std::uint32_t, 8> h{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  const std::uint64_t bits = 8 * text.size();
  text += '\x80';
  while (text.size() % 64 != 56) text += '\0';
  for (int shift = 56; shift >= 0; shift -= 8) text += static_cast<char>(bits >> shift & 0xff);
  for (std::size_t at = 0; at < text.size(); at += 64) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i) w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(text[at + i]);
    for (std::size_t i = 16; i < 64; ++i)
      w[i] = w[i - 16] + (std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ w[i - 15] >> 3) + w[i - 7] +
             (std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ w[i - 2] >> 10);
    auto [a, b, c, d, e, f, g, last] = h;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint32_t first =
          last + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + k[i] + w[i];
      const std::uint32_t second =
          (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
      last = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
    }
    const std::array<std::uint32_t, 8> added{a, b, c, d, e, f, g, last};
    for (std::size_t i = 0; i < 8; ++i) h[i] += added[i];
  }
  std::string hex;
  for (const std::uint32_t word : h)
    for (int shift = 28; shift >= 0; shift -= 4) hex += "0123456789abcdef"[word >> shift & 15];
  return hex;
}

std::string fields_of(const message_type& of, std::map<std::string, const message_type*>& others) {
  std::string all;
  for (const message_field& f : of.fields) {
    const bool is_sequence = f.count == message_field::sequence, is_array = f.count > 1;
    const int id = static_cast<int>(f.of) + (is_sequence ? 144 : is_array ? 48 : 0);
    if (f.nested && others.emplace(f.nested->name, f.nested).second) fields_of(*f.nested, others);
    all += std::string(all.empty() ? "" : ", ") + "{\"name\": \"" + std::string(f.name) +
           "\", \"type\": {\"type_id\": " + std::to_string(id) +
           ", \"capacity\": " + std::to_string(is_array ? f.count : 0) +
           ", \"string_capacity\": 0, \"nested_type_name\": \"" +
           (f.nested ? std::string(f.nested->name) : "") + "\"}}";
  }
  return "\"fields\": [" + all + "]";
}

std::string hash_of(const message_type& of) {
  std::map<std::string, const message_type*> others;  // by name, as REP 2011 orders them
  std::string text = "{\"type_description\": {\"type_name\": \"" + std::string(of.name) + "\", " +
                     fields_of(of, others) + "}, \"referenced_type_descriptions\": [";
  std::string rest;
  for (const auto& [name, type] : others) {
    std::map<std::string, const message_type*> known = others;
    rest += std::string(rest.empty() ? "" : ", ") + "{\"type_name\": \"" + name + "\", " +
            fields_of(*type, known) + "}";
  }
  return "RIHS01_" + sha256(text + rest + "]}");
}

}  // namespace

TEST_SUITE("ros 2 types") {
  TEST_CASE("sha256") {
    CHECK_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  }
  TEST_CASE("the hash of each type is that of its description") {
    CHECK_EQ(hash_of(joints::type), joints::type.hash);
    CHECK_EQ(hash_of(inertial::type), inertial::type.hash);
    CHECK_EQ(hash_of(loads::type), loads::type.hash);
    CHECK_EQ(hash_of(motions::type), motions::type.hash);
    CHECK_EQ(hash_of(array::type), array::type.hash);
    CHECK_EQ(hash_of(places::type), places::type.hash);
    CHECK_EQ(hash_of(commands::type), commands::type.hash);
    CHECK_EQ(hash_of(transforms::type), transforms::type.hash);
    CHECK_EQ(hash_of(tree::type), tree::type.hash);
    CHECK_EQ(hash_of(ways::type), ways::type.hash);
    CHECK_EQ(hash_of(pictures::type), pictures::type.hash);
  }
  TEST_CASE("a type has the name that ROS 2 gives it in DDS") {
    CHECK_EQ(cca::ros2::detail::type_name_in_dds("sensor_msgs/msg/JointState"),
             "sensor_msgs::msg::dds_::JointState_");
  }
}
