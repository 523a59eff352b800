// Carries messages between rank 0 and the others, and knows who lives. All of MPI but its beginning and end
// is called by one thread, which this starts; it never waits in MPI, because there a dead rank could hold it.
//
// A rank that says nothing for the silence that is allowed is lost for good. Its thread speaks for it ten
// times as often, also while a run lasts for hours, so only a process that is dead or stands still is silent.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <deque>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <mpi.h>

#include <cca/mpi/message.hpp>

namespace cca::mpi::detail {

class post {
public:
  using clock = std::chrono::steady_clock;

  // `alone`: called on another rank than 0 once it has lost rank 0, unless that has left it out.
  post(int own_rank, int rank_count, clock::duration allowed_silence, std::function<void()> without_first)
      : rank(own_rank),
        count(rank_count),
        silence(allowed_silence),
        alone(std::move(without_first)),
        others(static_cast<std::size_t>(count)) {
    for (other& each : others) each.heard = clock::now();
    carrier = std::jthread([this] { carry(); });
  }
  ~post() { close(); }
  post(const post&) = delete;
  post& operator=(const post&) = delete;

  const int rank, count;

  void send(int to, message one) {
    const std::lock_guard lock(at_hand);
    outbox.emplace_back(to, std::move(one));
  }
  void send_all(const message& one) {
    for (int to = 1; to < count; ++to)
      if (!is_lost(to)) send(to, one);
  }
  std::optional<message> next() {
    const std::lock_guard lock(at_hand);
    if (inbox.empty()) return std::nullopt;
    message one = std::move(inbox.front());
    inbox.pop_front();
    return one;
  }
  // Until a message comes, a rank is lost, or somebody calls `wake`.
  void wait_for_news(clock::duration most) {
    std::unique_lock lock(at_hand);
    changed.wait_for(lock, most, [&] { return !inbox.empty() || has_news; });
    has_news = false;
  }
  void wake() {
    {
      const std::lock_guard lock(at_hand);
      has_news = true;
    }
    changed.notify_all();
  }
  bool is_lost(int which) const {
    const std::lock_guard lock(at_hand);
    return others[static_cast<std::size_t>(which)].lost;
  }
  std::string why_lost(int which) const {
    const std::lock_guard lock(at_hand);
    return others[static_cast<std::size_t>(which)].why;
  }
  int count_lost() const {
    int sum = 0;
    for (int i = 0; i < count; ++i) sum += is_lost(i);
    return sum;
  }
  // From here on nothing is sent to it, and nothing of it is heard.
  void lose(int which, const std::string& why) {
    {
      const std::lock_guard lock(at_hand);
      other& it = others[static_cast<std::size_t>(which)];
      if (it.lost) return;
      it.lost = true;
      it.why = why;
      has_news = true;
    }
    if (rank != 0 && !left_out) alone();
    if (rank == 0)
      std::fprintf(stderr, "cca::mpi: rank %d of %d %s: it is left out, the others make its runs\n", which,
                   count, why.c_str());
    changed.notify_all();
  }
  // While the program works with others, answers come at once; else the thread looks less often.
  void hurry(bool is_at_work) { quick = is_at_work; }
  // What is under way still leaves, for as long as a silence may last.
  void close() {
    if (!carrier.joinable()) return;
    {
      const std::lock_guard lock(at_hand);
      closes = true;
    }
    carrier.join();
  }

private:
  static constexpr int tag = 1;
  static constexpr std::size_t most_bytes = 16 << 20;  // in a piece

  struct other {
    clock::time_point heard{}, spoken{};
    bool lost = false, told = false;
    std::string why;
    std::string pieces;  // of a message whose end is not yet there
  };
  struct letter {
    int other;
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  void carry() {
    clock::time_point looked = clock::now(), end = clock::time_point::max();
    while (true) {
      const auto now = clock::now();
      // If this process stood still, that says nothing of the others.
      if (now - looked > silence / 4)
        for (other& each : others) each.heard += now - looked;
      looked = now;
      receive(now);
      bool is_closing = false;
      {
        const std::lock_guard lock(at_hand);
        is_closing = closes;
        for (; !outbox.empty(); outbox.pop_front()) write(outbox.front().first, outbox.front().second);
      }
      if (is_closing && end == clock::time_point::max()) end = now + silence;
      if (!is_closing) {
        speak(now);
        listen(now);
      }
      deliver();
      if (is_closing && (leaving.empty() || now > end)) return;
      std::this_thread::sleep_for(std::chrono::microseconds(quick ? 200 : 2000));
    }
  }

  int first_other() const { return rank == 0 ? 1 : 0; }
  int last_other() const { return rank == 0 ? count - 1 : 0; }

  void write(int to, const message& one) {
    std::size_t at = 0;
    do {
      const std::size_t size = std::min(most_bytes, one.bytes.size() - at);
      const message_head head{one.what, at + size < one.bytes.size(), one.call, one.number, one.other};
      letter& next = leaving.emplace_back(letter{to, std::string(sizeof head + size, '\0')});
      std::memcpy(next.bytes.data(), &head, sizeof head);
      std::memcpy(next.bytes.data() + sizeof head, one.bytes.data() + at, size);
      MPI_Isend(next.bytes.data(), static_cast<int>(next.bytes.size()), MPI_BYTE, to, tag, MPI_COMM_WORLD,
                &next.request);
      at += size;
    } while (at < one.bytes.size());
    others[static_cast<std::size_t>(to)].spoken = clock::now();
  }

  // What is on its way to a lost rank stays where it is: MPI may still look at it.
  void deliver() {
    for (auto at = leaving.begin(); at != leaving.end();) {
      int is_over = 0;
      if (is_lost(at->other)) {
        auto next = std::next(at);
        abandoned.splice(abandoned.end(), leaving, at);
        at = next;
      } else {
        const int error = MPI_Test(&at->request, &is_over, MPI_STATUS_IGNORE);
        if (error != MPI_SUCCESS) lose(at->other, "can't be reached");
        at = is_over && error == MPI_SUCCESS ? leaving.erase(at) : std::next(at);
      }
    }
  }

  void receive(clock::time_point now) {
    while (true) {
      int is_there = 0;
      MPI_Message handle;
      MPI_Status status;
      if (MPI_Improbe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &is_there, &handle, &status) != MPI_SUCCESS ||
          !is_there)
        break;
      int size = 0;
      MPI_Get_count(&status, MPI_BYTE, &size);
      letter& next =
          arriving.emplace_back(letter{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')});
      MPI_Imrecv(next.bytes.data(), size, MPI_BYTE, &handle, &next.request);
    }
    std::vector<bool> waits(static_cast<std::size_t>(count), false);  // for an earlier one of the same rank
    for (auto at = arriving.begin(); at != arriving.end();) {
      const auto from = static_cast<std::size_t>(at->other);
      int is_over = 0;
      if (waits[from] || MPI_Test(&at->request, &is_over, MPI_STATUS_IGNORE) != MPI_SUCCESS || !is_over) {
        waits[from] = true;
        ++at;
        continue;
      }
      read(*at, now);
      at = arriving.erase(at);
    }
  }

  void read(const letter& one, clock::time_point now) {
    if (one.bytes.size() < sizeof(message_head)) return;
    message_head head;
    std::memcpy(&head, one.bytes.data(), sizeof head);
    if (head.what == kind::left_out) {
      left_out = true;
      return lose(one.other, "has left out this rank, which was silent for too long");
    }
    bool is_heard = false;
    {
      const std::lock_guard lock(at_hand);
      other& it = others[static_cast<std::size_t>(one.other)];
      if (it.lost) {
        if (rank == 0 && !std::exchange(it.told, true)) write(one.other, {.what = kind::left_out});
        return;
      }
      it.heard = now;
      it.pieces.append(one.bytes, sizeof head);
      if (head.goes_on != 0 || head.what == kind::alive) return;
      inbox.push_back(
          {head.what, head.call, head.number, head.other, std::exchange(it.pieces, {}), one.other});
      is_heard = true;
    }
    if (is_heard) changed.notify_all();
  }

  void speak(clock::time_point now) {
    for (int to = first_other(); to <= last_other(); ++to) {
      if (is_lost(to)) continue;
      if (now - others[static_cast<std::size_t>(to)].spoken > silence / 10) write(to, {.what = kind::alive});
    }
  }
  void listen(clock::time_point now) {
    for (int from = first_other(); from <= last_other(); ++from) {
      if (now - others[static_cast<std::size_t>(from)].heard <= silence) continue;
      char text[80];
      std::snprintf(text, sizeof text, "has been silent for %.3g s",
                    std::chrono::duration<double>(silence).count());
      lose(from, text);
    }
  }

  const clock::duration silence;
  const std::function<void()> alone;
  mutable std::mutex at_hand;
  std::condition_variable changed;
  std::deque<std::pair<int, message>> outbox;
  std::deque<message> inbox;
  bool has_news = false, closes = false;
  std::atomic<bool> quick = false;
  std::vector<other> others;                       // heard, spoken, pieces: of the thread alone
  std::list<letter> leaving, arriving, abandoned;  // of the thread alone
  bool left_out = false;                           // of the thread alone
  std::jthread carrier;
};

}  // namespace cca::mpi::detail
