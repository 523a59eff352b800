// Frames on their way from a loop to the thread that writes them.
#include <doctest/doctest.h>

#include <cstdint>
#include <thread>
#include <vector>

#include <cca/runtime/observers/frame_ring.hpp>

namespace {

using ring = cca::detail::frame_ring<8, 2>;

bool put(ring& r, std::int64_t k) {
  std::int64_t* const frame = r.frame();
  frame[0] = k;
  frame[1 + k % 2] = k;  // the other output is not published in this beat
  return r.commit(frame);
}
bool is_untouched(const std::int64_t* frame) { return frame[1] == cca::never && frame[2] == cca::never; }

}  // namespace

TEST_CASE("A ring has room for so many frames, and gives them in their order, again and again") {
  for (const std::size_t most : {1u, 2u, 3u, 7u}) {
    ring r(most);
    CHECK(r.oldest() == nullptr);
    std::int64_t written = 0, read = 0;
    for (int round = 0; round < 20; ++round) {
      for (std::size_t n = 0; n < most; ++n) REQUIRE(put(r, written++));
      CHECK(r.is_almost_full());
      while (const std::int64_t* const frame = r.oldest()) {
        CHECK(frame[0] == read);
        CHECK(frame[1 + read % 2] == read);
        CHECK(frame[2 - read % 2] == cca::never);
        ++read;
        r.take();
      }
      CHECK(read == written);
      CHECK_FALSE(r.is_almost_full());
    }
  }
}

TEST_CASE("Where a ring is full, a frame is written again, and waits or is lost") {
  ring r(3);
  for (std::int64_t k = 0; k < 3; ++k) REQUIRE(put(r, k));
  CHECK_FALSE(put(r, 3));
  std::int64_t* const place = r.frame();
  CHECK(place[0] == 3);  // as it was left: it may still go
  CHECK_FALSE(r.commit_last());
  r.drop();
  CHECK(r.frame() == place);
  CHECK(is_untouched(place));
  CHECK_FALSE(put(r, 5));
  CHECK(r.oldest()[0] == 0);
  r.take();
  CHECK(r.commit_last());  // it has waited
  CHECK_FALSE(put(r, 6));
  r.drop();
  std::vector<std::int64_t> beats;
  for (; r.oldest(); r.take()) beats.push_back(r.oldest()[0]);
  CHECK(beats == std::vector<std::int64_t>{1, 2, 5});
  for (int n = 0; n < 8; ++n) {
    CHECK(is_untouched(r.frame()));
    REQUIRE(put(r, n));
    r.take();
  }
}

TEST_CASE("A thread reads what another one writes, whole and in order") {
  constexpr std::int64_t beats = 100'000;
  ring r(1000);
  std::int64_t wrong = 0;
  std::jthread reader([&] {
    for (std::int64_t k = 0; k < beats;) {
      const std::int64_t* const frame = r.oldest();
      if (!frame) {
        std::this_thread::yield();
        continue;
      }
      wrong += frame[0] != k || frame[1 + k % 2] != k || frame[2 - k % 2] != cca::never;
      ++k;
      r.take();
    }
  });
  for (std::int64_t k = 0; k < beats; ++k)
    if (!put(r, k))
      while (!r.commit_last()) std::this_thread::yield();
  reader.join();
  CHECK(wrong == 0);
}
