// The runs that a rank makes, several at once on a thread: how many could begin, and what ends how.
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <cca/mpi/local_runs.hpp>

using namespace cca::mpi::detail;

namespace {

using end = finished_run::end;
using numbers = std::vector<std::uint64_t>;

// Until it is so, or for five seconds.
bool becomes(const std::function<bool()>& so) {
  for (int k = 0; k < 5000 && !so(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return so();
}

// A thread that begins and ends runs when the test says so.
class led {
public:
  explicit led(std::size_t at_once, std::function<bool()> stops = {})
      : all(100, 1, at_once, [this](local_runs& own) { lead(own); }, std::move(stops), [this] { ++woken; }) {}
  ~led() {
    const std::lock_guard lock(at_hand);
    ends = true;
  }
  void end_of(std::uint64_t i) {
    const std::lock_guard lock(at_hand);
    to_end.insert(i);
  }
  void fail(std::uint64_t i) {
    const std::lock_guard lock(at_hand);
    to_fail.insert(i);
  }
  std::set<std::uint64_t> begun() {
    const std::lock_guard lock(at_hand);
    return has_begun;
  }
  // All that were over until this many are.
  std::map<std::uint64_t, finished_run> over(std::size_t count) {
    becomes([&] {
      for (finished_run& one : all.take_finished()) was_over[one.number] = std::move(one);
      return was_over.size() >= count;
    });
    return was_over;
  }

private:
  void lead(local_runs& own) {
    std::set<std::uint64_t> under_way;
    for (;;) {
      if (const auto i = own.next(under_way.empty())) {
        under_way.insert(*i);
        const std::lock_guard lock(at_hand);
        has_begun.insert(*i);
      } else if (under_way.empty()) {
        return;
      }
      std::this_thread::yield();
      for (const std::uint64_t i : std::vector(under_way.begin(), under_way.end())) {
        bool fails = false, is_over = false;
        {
          const std::lock_guard lock(at_hand);
          fails = to_fail.contains(i), is_over = ends || to_end.contains(i);
        }
        if (!fails && !is_over) continue;
        under_way.erase(i);
        try {
          if (fails) throw std::runtime_error("run " + std::to_string(i));
          own.done(i, "result " + std::to_string(i));
        } catch (...) { own.failed(i); }
      }
    }
  }

  std::mutex at_hand;
  std::set<std::uint64_t> to_end, to_fail, has_begun;
  std::map<std::uint64_t, finished_run> was_over;
  bool ends = false;
  std::atomic<int> woken = 0;

public:
  local_runs all;  // the last: its thread ends before the rest is gone
};

}  // namespace

TEST_SUITE("local runs") {
  TEST_CASE("a thread with room begins another run while some are under way, and each is over by itself") {
    led one(4);
    CHECK_EQ(one.all.idle(), 4);
    one.all.add({7, 8});
    CHECK_EQ(one.all.idle(), 2);
    CHECK(becomes([&] { return one.begun() == std::set<std::uint64_t>{7, 8}; }));
    CHECK_EQ(one.all.idle(), 2);
    one.all.add({9, 10, 11});
    CHECK(becomes([&] { return one.begun().contains(9); }));
    CHECK_EQ(one.all.idle(), 0);
    one.end_of(8);
    auto over = one.over(1);
    REQUIRE(over.contains(8));
    CHECK(over[8].how == end::done);
    CHECK_EQ(over[8].bytes, "result 8");
    for (const std::uint64_t i : {7u, 9u, 10u, 11u}) one.end_of(i);
    CHECK_EQ(one.over(5).size(), 5);
    CHECK_EQ(one.all.idle(), 4);
    one.all.add({12});  // a thread that was idle goes on
    one.end_of(12);
    CHECK_EQ(one.over(6).size(), 6);
  }

  TEST_CASE("a run that fails ends by itself, and none that waits is dropped by it") {
    led one(3);
    one.all.add({1, 2, 3});
    CHECK(becomes([&] { return one.begun().size() == 3; }));
    one.fail(2);
    auto over = one.over(1);
    REQUIRE(over.contains(2));
    CHECK(over[2].how == end::failed);
    CHECK_EQ(over[2].bytes, "run 2");
    one.end_of(1), one.end_of(3);
    over = one.over(3);
    CHECK(over[1].how == end::done);
    CHECK(over[3].how == end::done);
  }

  TEST_CASE("once it ceases, what waits is dropped, and what is under way comes to its end") {
    led one(4);
    one.all.add({1, 2});
    CHECK(becomes([&] { return one.begun().size() == 2; }));
    one.all.cease();
    one.all.add({3});
    auto over = one.over(1);
    CHECK(over[3].how == end::dropped);
    one.end_of(1), one.end_of(2);
    over = one.over(3);
    CHECK(over[1].how == end::done);
    CHECK(over[2].how == end::done);
    CHECK_EQ(one.begun().size(), 2);
  }

  TEST_CASE("after a stop no run begins, and what is under way is dropped when it ends") {
    std::atomic<bool> stop = false;
    led one(4, [&] { return stop.load(); });
    one.all.add({1});
    CHECK(becomes([&] { return one.begun().size() == 1; }));
    stop = true;
    one.all.add({2});
    auto over = one.over(1);
    CHECK(over[2].how == end::dropped);
    CHECK(one.all.is_stopped());
    one.end_of(1);
    over = one.over(2);
    CHECK(over[1].how == end::dropped);
    CHECK_EQ(one.all.idle(), 4);
  }

  TEST_CASE("a stop that can't be asked fails by the number of runs, and drops the run") {
    std::atomic<bool> wrong = false;
    led one(2, [&]() -> bool { return wrong ? throw std::runtime_error("asked") : false; });
    one.all.add({1});
    CHECK(becomes([&] { return one.begun().size() == 1; }));
    wrong = true;
    one.all.add({2});
    auto over = one.over(2);
    CHECK(over[2].how == end::dropped);
    CHECK(over[100].how == end::failed);
    CHECK_EQ(over[100].bytes, "asked");
    one.end_of(1);
    CHECK(one.over(3)[1].how == end::dropped);
    CHECK_EQ(one.all.idle(), 2);
  }
}
