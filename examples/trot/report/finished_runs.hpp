#pragma once
// Many independent runs on all cores, with a bar. After ctrl-c those that are over remain.
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/runtime/interruption.hpp>

#include "parallel.hpp"
#include "progress.hpp"

namespace trot {

// What run(0) to run(count - 1) return, in this order, without those that were interrupted. A run ends early
// once `interrupted`. `program`: the name in the messages.
template <class Run>
auto finished_runs(const std::string& program,
                   std::size_t count,
                   const cca::interruption& interrupted,
                   Run run) {
  using result = std::invoke_result_t<Run&, std::size_t>;
  std::vector<std::optional<result>> results(count);
  progress_bar bar(program);
  on_all_cores(
      count,
      [&](std::size_t i) {
        if (interrupted) return;
        result one = run(i);
        if (!interrupted) results[i] = std::move(one);
      },
      [&](std::size_t finished) { bar.show(static_cast<double>(finished) / static_cast<double>(count)); });
  bar.done();
  std::vector<result> over;
  for (auto& one : results)
    if (one) over.push_back(*std::move(one));
  if (interrupted) std::cerr << program << ": interrupted after " << over.size() << " runs\n";
  return over;
}

}  // namespace trot
