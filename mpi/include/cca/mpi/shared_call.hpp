// One call of `rollouts` on all ranks: rank 0 hands out the runs, collects their results, and tells all of
// them to all ranks. Both sides know results only as bytes.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <cca/mpi/hand_out.hpp>
#include <cca/mpi/local_runs.hpp>
#include <cca/mpi/message.hpp>
#include <cca/mpi/packing.hpp>
#include <cca/mpi/post.hpp>
#include <cca/sim/rollouts.hpp>

namespace cca::mpi {

// Rank 0 is gone, or it takes this rank for dead: this rank can't go on.
struct lost_contact : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// What a run, or a setting, has thrown on any rank: its text, on every rank.
struct failed_run : std::runtime_error {
  failed_run(std::uint64_t of_run, const std::string& text) : std::runtime_error(text), number(of_run) {}
  std::uint64_t number;  // the number of runs: not a run, but a setting has thrown
};

namespace detail {

struct call_facts {
  std::uint64_t number;  // of the call
  std::size_t count;     // runs
  std::string in_words;  // the same on all ranks
  unsigned threads;
  std::size_t at_once;    // runs of a thread
  local_runs::work make;  // on each thread
};

struct call_outcome {
  failure failed{};
  std::vector<std::string> results{};
};

inline constexpr std::chrono::milliseconds longest_wait{20};  // between two questions whether to stop

class shared_call {
public:
  shared_call(post& carrier, const call_facts& facts, const sim::rollout_settings& settings)
      : mail(carrier),
        call(facts),
        s(settings),
        own(call.count, facts.threads, facts.at_once, facts.make, s.stops, [this] { mail.wake(); }) {}

  call_outcome make() { return mail.rank == 0 ? hand_out_all() : help(); }

private:
  // ---- rank 0 ----

  struct asker {
    std::size_t idle = 0, threads = 0;
    bool lost = false;
  };

  call_outcome hand_out_all() {
    hand_out book(call.count);
    std::vector<asker> askers(static_cast<std::size_t>(mail.count));
    askers[0].threads = own.thread_count();
    std::size_t told = 0;
    bool is_told_to_cease = false;
    while (true) {
      for (finished_run& one : own.take_finished()) note(book, 0, std::move(one));
      for (auto m = mail.next(); m; m = mail.next()) hear(book, askers, *m);
      for (int r = 1; r < mail.count; ++r) {
        asker& it = askers[static_cast<std::size_t>(r)];
        if (it.lost || !mail.is_lost(r)) continue;
        it = {.lost = true};
        book.is_lost(r);
      }
      if (const auto wrong = call_settings([&] {
            if (own.is_stopped() || (s.stops && s.stops())) book.cease();
            for (; told < book.count_finished() && !book.failed().is_one(); ++told)
              if (s.over) s.over(told + 1);
          }))
        book.has_failed(0, call.count, *wrong);
      if (book.has_ceased() && !is_told_to_cease) {
        is_told_to_cease = true;
        own.cease();
        mail.send_all({.what = kind::cease, .call = call.number});
      }
      if (book.is_over()) break;
      give(book, askers);
      mail.wait_for_news(longest_wait);
    }
    call_outcome outcome{book.failed(), book.take_results()};
    message all{.what = kind::outcome, .call = call.number, .number = outcome.failed.number};
    if (outcome.failed.is_one()) put(all.bytes, outcome.failed.text);
    else put(all.bytes, outcome.results);
    mail.send_all(all);
    return outcome;
  }

  void give(hand_out& book, std::vector<asker>& askers) {
    std::size_t threads = 0;
    for (const asker& each : askers) threads += each.threads;
    askers[0].idle = own.idle();
    for (std::size_t r = 0; r < askers.size(); ++r) {
      if (askers[r].idle == 0) continue;
      const auto runs = book.take(static_cast<int>(r), askers[r].idle, askers[r].threads, threads);
      if (runs.empty()) return;
      askers[r].idle = 0;
      if (r == 0) {
        own.add(runs);
        continue;
      }
      message grant{.what = kind::grant, .call = call.number};
      put(grant.bytes, runs);
      mail.send(static_cast<int>(r), std::move(grant));
    }
  }

  void hear(hand_out& book, std::vector<asker>& askers, const message& m) {
    if (m.what == kind::goodbye) mail.lose(m.from, "has ended, with exit code " + std::to_string(m.number));
    if (m.call != call.number) return;
    std::string_view bytes = m.bytes;
    if (m.what == kind::ask) {
      askers[static_cast<std::size_t>(m.from)] = {m.number, m.other, false};
      if (const auto words = get<std::string>(bytes); words != call.in_words)
        book.has_failed(m.from, call.count,
                        "cca::mpi: rank " + std::to_string(m.from) + " asks for " + words +
                            " where rank 0 makes " + call.in_words +
                            ": all ranks must make the same calls, with the same numbers");
    }
    if (m.what == kind::stopping) book.cease();
    while (m.what == kind::finished && !bytes.empty()) {
      finished_run one{get<std::uint64_t>(bytes), get<finished_run::end>(bytes)};
      one.bytes = get<std::string>(bytes);
      note(book, m.from, std::move(one));
    }
  }

  static void note(hand_out& book, int rank, finished_run one) {
    if (one.how == finished_run::end::done) book.is_done(rank, one.number, std::move(one.bytes));
    if (one.how == finished_run::end::dropped) book.is_dropped(rank, one.number);
    if (one.how == finished_run::end::failed) book.has_failed(rank, one.number, std::move(one.bytes));
  }

  // ---- the others ----

  call_outcome help() {
    bool has_asked = false, has_ceased = false;
    while (true) {
      for (auto m = mail.next(); m; m = mail.next()) {
        std::string_view bytes = m->bytes;
        if (m->what == kind::ended) throw lost_contact("cca::mpi: rank 0 has ended before this rank's call");
        if (m->call != call.number) continue;
        if (m->what == kind::outcome) return outcome_of(*m);
        if (m->what == kind::grant) {
          own.add(get<std::vector<std::uint64_t>>(bytes));
          has_asked = false;
        }
        if (m->what == kind::cease) {
          has_ceased = true;
          own.cease();
        }
      }
      if (mail.is_lost(0)) throw lost_contact("cca::mpi: rank 0 " + mail.why_lost(0));
      std::vector<finished_run> over = own.take_finished();
      const auto wrong = call_settings([&] {
        if (has_ceased || !(own.is_stopped() || (s.stops && s.stops()))) return;
        has_ceased = true;
        own.cease();
        mail.send(0, {.what = kind::stopping, .call = call.number});
      });
      if (wrong && !has_ceased) {
        has_ceased = true;
        over.push_back({call.count, finished_run::end::failed, *wrong});
      }
      tell(over);
      if (const std::size_t idle = own.idle(); !has_asked && !has_ceased && idle > 0) {
        has_asked = true;
        message ask{.what = kind::ask, .call = call.number, .number = idle, .other = own.thread_count()};
        put(ask.bytes, call.in_words);
        mail.send(0, std::move(ask));
      }
      mail.wait_for_news(longest_wait);
    }
  }

  void tell(const std::vector<finished_run>& over) {
    if (over.empty()) return;
    message finished{.what = kind::finished, .call = call.number};
    for (const finished_run& one : over) {
      put(finished.bytes, one.number);
      put(finished.bytes, one.how);
      put(finished.bytes, one.bytes);
    }
    mail.send(0, std::move(finished));
  }

  static call_outcome outcome_of(const message& m) {
    std::string_view bytes = m.bytes;
    call_outcome outcome;
    outcome.failed.number = m.number;
    if (outcome.failed.is_one()) outcome.failed.text = get<std::string>(bytes);
    else outcome.results = get<std::vector<std::string>>(bytes);
    return outcome;
  }

  // ---- both ----

  template <class F>
  static std::optional<std::string> call_settings(const F& f) {
    try {
      f();
      return std::nullopt;
    } catch (...) { return text_of(std::current_exception()); }
  }

  post& mail;
  const call_facts& call;
  const sim::rollout_settings& s;
  local_runs own;
};

}  // namespace detail
}  // namespace cca::mpi
