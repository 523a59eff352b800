#pragma once
// The cores that the runs of a program share: those of this machine, or, where the component cca::mpi is
// there, those of all machines on which mpirun has started the program.
#if CCA_HAS_MPI
#include <cca/mpi/ranks.hpp>

namespace trot {
using all_cores = cca::mpi::ranks;
}
#else
#include <cstddef>
#include <utility>

#include <cca/sim/rollouts.hpp>

namespace trot {

struct all_cores {
  all_cores(int, char**) {}
  static constexpr bool is_first() { return true; }
  static constexpr int count() { return 1; }
  template <class Run>
  static auto rollouts(std::size_t count, Run run, const cca::sim::rollout_settings& settings = {}) {
    return cca::sim::rollouts(count, std::move(run), settings);
  }
};

}  // namespace trot
#endif
