// The reader: a million messages, files that are cut anywhere, and bytes that mean nothing.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "graphs.hpp"

using namespace record_test;

namespace {

std::vector<unsigned char> message_of(std::int64_t k) {
  std::vector<unsigned char> bytes{0, 1, 0, 0};
  bytes.resize(20);
  const double value = 0.5 * static_cast<double>(k);
  std::memcpy(&bytes[4], &k, sizeof k);
  std::memcpy(&bytes[12], &value, sizeof value);
  return bytes;
}
void write(const std::string& name, std::int64_t count, std::size_t chunk = 1 << 20, bool closes = true) {
  cca::recording::mcap_writer file(name, chunk);
  const auto channel = file.channel("/a/b", "cca/msg/b", "int64 beat\nfloat64 value\n", {{"units", "1"}});
  file.metadata("note", {{"seed", "17"}});
  for (std::int64_t k = 0; k < count; ++k) {
    const auto time = static_cast<std::uint64_t>(k) * 1'000'000;
    file.message(channel, time, time, message_of(k));
  }
  if (closes) file.close();
}
// How many messages can be read; each must be the next.
std::int64_t read(const std::string& name, std::string* damage = nullptr) {
  cca::recording::mcap_reader file(name);
  std::int64_t k = 0;
  for (cca::recording::mcap_message m; file.next(m); ++k) {
    const auto expected = message_of(k);
    REQUIRE(std::equal(m.data.begin(), m.data.end(), expected.begin(), expected.end()));
  }
  if (damage) *damage = file.damage();
  return k;
}
std::vector<char> bytes_in(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
void put_bytes(const std::string& name, const std::vector<char>& bytes, std::size_t count) {
  std::ofstream(name, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(count));
}

}  // namespace

TEST_CASE("a million messages") {
  const temporary_file file("million");
  write(file.path, 1'000'000);
  std::string damage;
  CHECK(read(file.path, &damage) == 1'000'000);
  CHECK(damage == "");
}

TEST_CASE("a file that is cut anywhere is read up to its last whole chunk") {
  const temporary_file file("anywhere");
  write(file.path, 2000, 1000);
  const auto all = bytes_in(file.path);
  std::mt19937 random(1);
  std::int64_t most = 0;
  for (int i = 0; i < 300; ++i) {
    const std::size_t size = 8 + random() % (all.size() - 8);
    put_bytes(file.path, all, size);
    std::string damage;
    const auto count = read(file.path, &damage);
    most = std::max(most, count);
    if (count < 2000) CHECK(damage != "");
  }
  CHECK(most > 1000);
}

TEST_CASE("without the end, every whole chunk is there") {
  const temporary_file file("no_end");
  write(file.path, 2000, 1000, false);
  std::filesystem::rename(file.path + ".part", file.path);
  CHECK(read(file.path) > 1900);
}

TEST_CASE("damaged bytes are never taken for messages, and never crash the reader") {
  const temporary_file file("damaged");
  write(file.path, 2000, 1000);
  const auto all = bytes_in(file.path);
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    auto bytes = all;
    for (unsigned n = 1 + random() % 4; n > 0; --n)
      bytes[8 + random() % (bytes.size() - 8)] ^= char(1 + random() % 255);
    put_bytes(file.path, bytes, bytes.size());
    cca::recording::mcap_reader reader(file.path);
    for (cca::recording::mcap_message m; reader.next(m);) {
      std::int64_t k = -1;
      REQUIRE(m.data.size() == 20);
      std::memcpy(&k, &m.data[4], sizeof k);
      const auto expected = message_of(k);
      REQUIRE(std::equal(m.data.begin(), m.data.end(), expected.begin(), expected.end()));
    }
    // Behind the end of the data nothing is read.
    if (!reader.has_ended()) CHECK(reader.damage() != "");
  }
  for (int i = 0; i < 2000; ++i) {
    std::vector<char> bytes(8 + random() % 500);
    for (char& b : bytes) b = static_cast<char>(random());
    std::memcpy(bytes.data(), cca::recording::detail::magic.data(), 8);
    put_bytes(file.path, bytes, bytes.size());
    cca::recording::mcap_reader reader(file.path);
    for (cca::recording::mcap_message m; reader.next(m);) {}
    CHECK(reader.damage() != "");
  }
}

TEST_CASE("the checksum is that of the standard") {
  CHECK(cca::recording::detail::crc_of(cca::recording::detail::bytes_of("123456789")) == 0xcbf43926u);
}
