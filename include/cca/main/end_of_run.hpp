// What the components of a controller say after a run (base/after_run.hpp), each with its path.
//
//   cca::causes_of(c)      what stopped it, a line each, the first cause first
//   cca::summaries_of(c)   what was limited, a line for each component that limited something, and what full
//                          queues have lost, a line for each input
//
// `c` is a cca::controller or a cca::deployed, between two beats. A fault is among the causes, with what its
// component says about it. Test: tests/runtime/programs/descriptions.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/after_run.hpp>
#include <cca/base/separate/compiled.hpp>
#include <cca/component/lifecycle.hpp>

namespace cca {
namespace detail {

void add_summary(std::string_view path, const std::string& said, std::vector<std::string>& lines);
void add_lost_samples(const std::string& input, std::int64_t lost, int room, std::vector<std::string>& lines);

struct fault_of_run {
  std::int64_t beat;
  std::string path, reason, cause;  // `cause`: of a deployment that has lost contact
};

class causes_of_run {
public:
  explicit causes_of_run(std::int64_t nanoseconds) : period(nanoseconds) {}

  void add(std::string_view path, cause said) { all.push_back({std::string(path), std::move(said)}); }
  // A sentence for each, in the order in which they began. `fault`: the one that ended the run, or null.
  std::vector<std::string> sentences(const fault_of_run* fault) const;

private:
  struct of_component {
    std::string path;
    cause said;
  };
  std::int64_t period;  // of a beat, ns
  std::vector<of_component> all{};
};

}  // namespace detail

template <class Controller>
std::vector<std::string> summaries_of(const Controller& c) {
  std::vector<std::string> lines;
  c.for_each_component([&]<class C>(std::string_view path, const C& component) {
    if constexpr (detail::HasSummary<C>) detail::add_summary(path, component.summary(), lines);
  });
  c.for_each_queue([&](const std::string& input, std::int64_t lost, int room) {
    detail::add_lost_samples(input, lost, room, lines);
  });
  return lines;
}

// In the order in which they began; of one beat in the order of declaration, the fault last.
template <class Controller>
std::vector<std::string> causes_of(const Controller& c) {
  detail::causes_of_run causes(Controller::period());
  c.for_each_component([&]<class C>(std::string_view path, const C& component) {
    if constexpr (detail::HasCause<C>) causes.add(path, component.cause());
  });
  if (c.state() != state::faulted) return causes.sentences(nullptr);
  detail::fault_of_run fault{c.beat_index(), c.fault_path(), std::string(c.fault().reason()), {}};
  if constexpr (requires { c.fault_cause(); }) fault.cause = c.fault_cause();
  return causes.sentences(&fault);
}

}  // namespace cca

#if !CCA_HAS_COMPILED_MAIN
#include <cca/main/end_of_run_functions.hpp>
#endif
