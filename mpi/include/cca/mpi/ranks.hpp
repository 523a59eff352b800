// Many independent runs on the cores of several machines, by MPI: cca::sim::rollouts, for a program that
// mpirun starts several times.
//
//   int main(int count, char** words) {
//     cca::mpi::ranks all(count, words);   // first in main
//     const std::vector<double> distances = all.rollouts(100, [&](std::size_t i) { return distance(i); });
//     if (all.is_first()) write(distances);
//   }
//
//   mpirun -n 4 program
//
// Each rank is the whole program. All of them make the same calls; what run(i) has returned stands at i on
// every rank, so a deterministic program goes on in the same way everywhere, with the same bits on any number
// of ranks. Without mpirun it is cca::sim::rollouts.
//
// A rank that dies, or says nothing for `silence`, is left out for good; the others make its runs again. If
// rank 0 is lost, the others end: `rollouts` throws lost_contact there.
//
// Errors: run.not_sent, when it is compiled. An exception of a run ends the call on all ranks: each throws
// failed_run with the text of that with the lowest number. Test: tests/mpi/ranks.py; docs/cluster.md.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/type_name.hpp>
#include <cca/mpi/job.hpp>
#include <cca/mpi/packing.hpp>
#include <cca/mpi/shared_call.hpp>
#include <cca/sim/rollouts.hpp>

namespace cca::mpi {

struct rank_settings {
  std::chrono::duration<double> silence = std::chrono::seconds(10);  // the same on all ranks
};

class ranks {
public:
  // First in main(): the process that mpirun has started waits here, a child of it is the rank.
  // Throws std::logic_error if there are threads already, or another `ranks` was made.
  ranks(int count, char** words, const rank_settings& settings = {})
      : job_(detail::job::of_this_process(
            count, words, std::chrono::duration_cast<detail::post::clock::duration>(settings.silence))) {}
  ranks(const ranks&) = delete;
  ranks& operator=(const ranks&) = delete;

  // Rank 0 writes files and prints. Without mpirun there is no other.
  bool is_first() const { return rank() == 0; }
  int rank() const { return job_ ? job_->rank() : 0; }
  int count() const { return job_ ? job_->count() : 1; }

  // As cca::sim::rollouts, on all ranks. `threads`: of each rank; 0: its part of the machine's cores.
  // `stops`: asked on each rank; once it is true on one, the call ends early on all, with the same results.
  // `over`: called on rank 0. One call at a time, not from within a run.
  template <class Run>
  auto rollouts(std::size_t count, Run run, const sim::rollout_settings& settings = {}) {
    if constexpr (!sim::detail::MakesRollouts<Run>) {
      return sim::rollouts(count, std::move(run), settings);  // says what is wrong
    } else {
      using returned = std::invoke_result_t<Run&, std::size_t>;
      using result = typename sim::detail::result_of_run<returned>::type;
      static_assert(cca::detail::holds_or_tells<detail::Packable<result>, detail::not_sent<result>>::value);
      if constexpr (detail::Packable<result>) {
        if (!job_) return sim::rollouts(count, std::move(run), settings);
        const unsigned threads = settings.threads > 0 ? settings.threads : job_->threads();
        const std::size_t at_once =
            sim::detail::places_of_thread<returned>(count, threads * static_cast<std::size_t>(this->count()));
        const auto work = [&run, at_once](detail::local_runs& own) {
          sim::detail::make_runs(
              run, at_once, [&own](bool is_idle) { return own.next(is_idle); },
              [&own](std::size_t i, const result& one) {
                std::string bytes;
                detail::put(bytes, one);
                own.done(i, std::move(bytes));
              },
              [&own](std::size_t i) { own.failed(i); });
        };
        detail::call_facts call{0,
                                count,
                                std::to_string(count) + " runs that return `" +
                                    std::string(cca::detail::type_name<result>()) + "`",
                                threads,
                                at_once,
                                work};
        std::vector<result> all;
        for (const std::string& one : make(call, settings)) {
          std::string_view bytes = one;
          all.push_back(detail::get<result>(bytes));
        }
        return all;
      } else {
        return std::vector<result>{};
      }
    }
  }

private:
  std::vector<std::string> make(detail::call_facts& call, const sim::rollout_settings& settings) {
    if (is_calling_.exchange(true))
      throw std::logic_error("cca::mpi: rollouts is called within a run, or from two threads at once");
    struct at_work {
      detail::post& mail;
      std::atomic<bool>& is_calling;
      ~at_work() { mail.hurry(false), is_calling = false; }
    } const during{job_->mail(), is_calling_};
    call.number = job_->next_call();
    job_->mail().hurry(true);
    detail::call_outcome outcome = detail::shared_call(job_->mail(), call, settings).make();
    if (outcome.failed.is_one()) throw failed_run(outcome.failed.number, outcome.failed.text);
    return std::move(outcome.results);
  }

  detail::job* job_;
  std::atomic<bool> is_calling_ = false;
};

}  // namespace cca::mpi
