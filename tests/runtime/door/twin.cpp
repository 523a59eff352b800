// What a door keeps for twins, and a twin of a program behind it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

#include <cca/door.hpp>
#include <cca/record/twin.hpp>

#include "../record/graphs.hpp"
#include "opened.hpp"

using namespace door_test;

namespace {

struct graph : record_test::walking<> {};

std::uint64_t size_in(const std::string& data) {
  std::uint64_t size = 0;
  REQUIRE(data.size() >= 8);
  std::memcpy(&size, data.data(), 8);
  return size;
}
std::string piece(client& c, const std::string& of, std::uint64_t from) {
  const auto got = c.fetch("cca://twin/" + of + "?from=" + std::to_string(from));
  CHECK(got.why == "");
  return got.data;
}
// A sample of two numbers, as a recording has it.
std::string sample(std::int64_t beat, double x) {
  std::string message("\0\1\0\0", 4);
  for (const std::int64_t word : {beat, beat * 1000})
    message.append(reinterpret_cast<const char*>(&word), sizeof word);
  return message.append(reinterpret_cast<const char*>(&x), sizeof x);
}
void add_channel(opened& one, std::uint16_t id, cca::recording::replay_role role) {
  one.door.sink().channel(
      {.id = id, .topic = "/a/" + std::to_string(id), .type = "a", .schema = "", .role = role});
}
using role = cca::recording::replay_role;

constexpr std::size_t much = 16 << 20;  // bytes

}  // namespace

TEST_CASE("A door keeps what was sensed from the first beat on, and gives it in pieces") {
  opened one({.twin_memory = much});
  add_channel(one, 1, role::fed);
  add_channel(one, 2, role::none);
  client c(one.port());
  for (std::int64_t k = 0; k < 20000; ++k) one.message(1, 0, sample(k, 0.5)), one.message(2, 0, sample(k, 1));
  std::string all;
  CHECK(soon([&] {
    const std::string got = piece(c, "stream", all.size());
    CHECK(got.size() <= 8 + (256 << 10));
    all += got.substr(8);
    return all.size() == size_in(got) && all.size() > 20000 * 28;
  }));
  // The channel; then of each beat its number, and the channel, origin and one number.
  CHECK(all.size() == 2 + 2 + 1 + 4 + 4 + 4 + 20000 * (2 + 8 + 2 + 8 + 8));
  CHECK(
      c.fetch("cca://twin/stream?from=" + std::to_string(all.size() + 1)).why.starts_with("from: expected"));
}

TEST_CASE("Memory for twins is bounded - who comes too late is told so") {
  opened one({.twin_memory = 300'000});
  add_channel(one, 1, role::fed);
  client c(one.port());
  for (std::int64_t k = 0; k < 20000; ++k) one.message(1, 0, sample(k, 0.5));
  CHECK(soon([&] {
    return c.fetch("cca://twin/stream?from=0").why.starts_with("too late: this door keeps the last ");
  }));
  const auto end = size_in(piece(c, "stream", 19 + 28 * 19000));
  CHECK(end == 17 + 28 * 20000);
  CHECK(c.fetch("cca://twin/stream?from=" + std::to_string(end - 300'000 - 200'000)).why != "");
}

TEST_CASE("A door for which no twin is named keeps nothing for twins, and says how to name one") {
  const laws::temporary_file file("twin.wasm");
  std::ofstream(file.path, std::ios::binary) << "code";
  const auto size_of_stream = [](const cca::door_settings& s) -> std::optional<std::uint64_t> {
    opened one(s);
    add_channel(one, 1, role::fed);
    add_channel(one, 2, role::computed);
    client c(one.port());
    for (std::int64_t k = 0; k < 100; ++k) one.message(1, 0, sample(k, 0.5)), one.message(2, 0, sample(k, 1));
    CHECK(c.fetch("cca://twin/value?channel=2&beat=99").why ==
          (s.kept_for_twins() ? "" : "this value is no longer kept"));
    const auto got = c.fetch("cca://twin/stream?from=0");
    if (got.why.empty()) return size_in(got.data);
    CHECK(got.why ==
          "this door keeps nothing for twins: name one, by --twin FILE.wasm or door_settings::twin, or state "
          "door_settings::twin_memory");
    return {};
  };
  constexpr std::uint64_t whole = 2 * 17 + 100 * (2 + 8 + 2 + 8 + 8 + 2 + 4);
  CHECK(size_of_stream({}) == std::nullopt);
  CHECK(size_of_stream({.twin = file.path, .twin_memory = 0}) == std::nullopt);
  CHECK(size_of_stream({.twin = file.path}) == whole);
  CHECK(size_of_stream({.twin_memory = much}) == whole);
}

TEST_CASE("A door has the last values of what components computed") {
  opened one({.twin_memory = much});
  add_channel(one, 1, role::computed);
  add_channel(one, 2, role::computed);
  client c(one.port());
  for (std::int64_t k = 0; k < 50'000; ++k)
    one.message(1, 0, sample(k, 0.5 * static_cast<double>(k))), one.message(2, 0, sample(k, -1));
  CHECK(soon([&] { return c.fetch("cca://twin/value?channel=2&beat=49999").data == sample(49'999, -1); }));
  CHECK(c.fetch("cca://twin/value?channel=1&beat=45000").data == sample(45'000, 22'500));
  CHECK(c.fetch("cca://twin/value?channel=1&beat=100").why == "this value is no longer kept");
  CHECK(c.fetch("cca://twin/value?channel=9&beat=45000").why == "this value is no longer kept");
  // A hash each in the stream, and no number.
  CHECK(size_in(piece(c, "stream", 0)) == 2 * 17 + 50'000 * (10 + 2 * 6));
}

TEST_CASE("The program of a twin comes in pieces - without it the answer says how to give it") {
  const laws::temporary_file file("twin.wasm");
  std::string code = "\0asm";
  for (unsigned i = 0; i < 600'000; ++i) code += static_cast<char>(i * i >> 7);
  std::ofstream(file.path, std::ios::binary) << code;
  opened one({.twin = file.path});
  client c(one.port());
  std::string all;
  for (int i = 0; i < 3; ++i) {
    const std::string got = piece(c, "program", all.size());
    CHECK(size_in(got) == code.size());
    all += got.substr(8);
  }
  CHECK(all == code);
  CHECK(c.fetch("cca://twin/program?from=600001000").why == "from: expected a place in the program");

  opened none;
  client of_none(none.port());
  CHECK(of_none.fetch("cca://twin/program?from=0").why.find("--twin FILE.wasm") != std::string::npos);
  CHECK(of_none.fetch("package://robot/leg.stl").why.starts_with("this door has no such asset"));
  of_none.text({{"op", "fetchAsset"}, {"uri", "cca://twin/stream?from=0"}});
  CHECK(of_none.is_told("fetchAsset: expected a whole number requestId"));
  CHECK_THROWS_WITH_AS(opened({.twin = "/nowhere/twin.wasm"}),
                       doctest::Contains("door_settings::twin: the file /nowhere/twin.wasm"), cca::refused);
}

TEST_CASE("Who may not read the channels may not have the twin either") {
  opened one({.address = "0.0.0.0"});
  client c(one.port());
  c.text({{"op", "fetchAsset"}, {"uri", "cca://twin/stream?from=0"}, {"requestId", 1}});
  CHECK(c.is_told("reading needs the token, too"));
  CHECK(c.assets.empty());
}

TEST_CASE("A twin on the other side of a door computes the same as the program that runs") {
  cca::controller<graph> c;
  cca::door door(c, {.port = 0, .tells_where = false, .twin_memory = much});
  c.load();
  c.start();
  std::thread run([&] { c.run(cca::for_beats<1500>{}, cca::at_wall_clock(), door); });
  client of(door.port());
  cca::recording::twin<graph> twin;
  std::uint64_t from = 0;
  CHECK(of.waits(
      [&] {
        const std::string got = piece(of, "stream", from).substr(8);
        from += got.size();
        twin.take(cca::recording::detail::bytes_of(got));
        return twin.result().beats > 1400 || !twin.result();
      },
      10000ms));
  INFO(twin.result());
  CHECK(twin.result());
  CHECK(twin.result().samples > 2 * 1400);
  run.join();
}
