// This process as one of the ranks that mpirun has started: MPI's beginning, and its end with the program.
//
// At the end of the program all ranks wait for one another, and MPI ends in order. If one is lost, the last
// act of rank 0 is MPI_Abort with the exit code of its program: MPI_Finalize would wait for the lost one, and
// mpirun for its process.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <sched.h>

#include <mpi.h>

#include <cca/mpi/keeper.hpp>
#include <cca/mpi/message.hpp>
#include <cca/mpi/post.hpp>

namespace cca::mpi::detail {

class job {
public:
  // Null: no mpirun has started this process.
  static job* of_this_process(int& words_count, char**& words, post::clock::duration silence) {
    static bool is_made = false;
    if (std::exchange(is_made, true))
      throw std::logic_error("cca::mpi: a program has one `ranks`, because MPI begins once");
    if (!is_launched()) return nullptr;
    if (std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}) != 1)
      throw std::logic_error("cca::mpi: make `ranks` first in main(), before any thread");
    return new job(words_count, words, silence);  // until the process ends
  }

  post& mail() { return *carrier; }
  int rank() const { return own_rank; }
  int count() const { return all; }
  unsigned threads() const { return share; }
  std::uint64_t next_call() { return ++calls; }

private:
  // The launchers of Open MPI, of PMIx and of PMI say so to their processes.
  static bool is_launched() {
    return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMIX_RANK") || std::getenv("PMI_RANK");
  }

  job(int& words_count, char**& words, post::clock::duration silence) {
    int has = 0;
    MPI_Init_thread(&words_count, &words, MPI_THREAD_SERIALIZED, &has);
    if (has < MPI_THREAD_SERIALIZED)
      throw std::runtime_error("cca::mpi: this MPI has no MPI_THREAD_SERIALIZED, which ranks need");
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    MPI_Comm_rank(MPI_COMM_WORLD, &own_rank);
    MPI_Comm_size(MPI_COMM_WORLD, &all);
    share = cores_of_this_rank();
    process.is_begun(own_rank);
    carrier = std::make_unique<post>(own_rank, all, silence, [this] { process.is_released(); });
    if (::on_exit([](int code, void* self) { static_cast<job*>(self)->end(code); }, this) != 0)
      throw std::runtime_error("cca::mpi: on_exit failed");
  }

  // Those that mpirun allows to this rank, but of those that ranks of this machine share only its part.
  static unsigned cores_of_this_rank() {
    MPI_Comm machine;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    int ranks = 1;
    MPI_Comm_size(machine, &ranks);
    cpu_set_t own, together;
    CPU_ZERO(&own);
    ::sched_getaffinity(0, sizeof own, &own);
    MPI_Allreduce(&own, &together, sizeof own, MPI_BYTE, MPI_BOR, machine);
    MPI_Comm_free(&machine);
    return static_cast<unsigned>(std::max(1, std::min(CPU_COUNT(&own), CPU_COUNT(&together) / ranks)));
  }

  void end(int code) {
    std::cout.flush();
    std::fflush(nullptr);
    own_rank == 0 ? end_all(code) : end_one(code);
  }

  void end_all(int code) {
    post& mail = *carrier;
    mail.send_all({.what = kind::ended});
    wait_for_all(kind::goodbye);
    if (mail.count_lost() == 0) {
      mail.send_all({.what = kind::release});
      wait_for_all(kind::last);
    }
    const int lost = mail.count_lost();
    mail.close();
    if (lost == 0) {
      MPI_Finalize();
      return;
    }
    std::fprintf(stderr,
                 "cca::mpi: %d of %d ranks were lost; MPI_Abort ends what is left, with exit code %d\n", lost,
                 all, code);
    MPI_Abort(MPI_COMM_WORLD, code);
  }

  void wait_for_all(kind word) {
    post& mail = *carrier;
    std::vector<bool> has_said(static_cast<std::size_t>(all), false);
    const auto is_done = [&] {
      for (int r = 1; r < all; ++r)
        if (!has_said[static_cast<std::size_t>(r)] && !mail.is_lost(r)) return false;
      return true;
    };
    while (!is_done()) {
      for (auto m = mail.next(); m; m = mail.next())
        if (m->what == word) has_said[static_cast<std::size_t>(m->from)] = true;
      mail.wait_for_news(std::chrono::milliseconds(20));
    }
  }

  void end_one(int code) {
    post& mail = *carrier;
    mail.send(0, {.what = kind::goodbye, .number = static_cast<std::uint64_t>(code)});
    while (!mail.is_lost(0)) {
      for (auto m = mail.next(); m; m = mail.next()) {
        if (m->what != kind::release) continue;
        mail.send(0, {.what = kind::last});
        mail.close();
        process.is_released();
        MPI_Finalize();
        return;
      }
      mail.wait_for_news(std::chrono::milliseconds(20));
    }
    // Without rank 0 the job is over: mpirun ends the others as soon as this process ends, unless rank 0 has
    // only left it out.
    mail.close();
    std::_Exit(code);
  }

  keeper process;  // the first: what follows happens in the child
  int own_rank = 0, all = 1;
  unsigned share = 1;
  std::uint64_t calls = 0;
  std::unique_ptr<post> carrier;
};

}  // namespace cca::mpi::detail
