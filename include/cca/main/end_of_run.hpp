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
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/after_run.hpp>
#include <cca/component/lifecycle.hpp>

namespace cca {

template <class Controller>
std::vector<std::string> summaries_of(const Controller& c) {
  std::vector<std::string> lines;
  c.for_each_component([&]<class C>(std::string_view path, const C& component) {
    if constexpr (detail::HasSummary<C>)
      if (const std::string said = component.summary(); !said.empty())
        lines.push_back("`" + std::string(path) + "`: " + said);
  });
  c.for_each_queue([&](const std::string& input, std::int64_t lost, int room) {
    if (lost > 0)
      lines.push_back("`" + input + "`: its queue of " + std::to_string(room) + " was full and lost " +
                      std::to_string(lost) + (lost == 1 ? " sample" : " samples"));
  });
  return lines;
}

// In the order in which they began; of one beat in the order of declaration, the fault last.
template <class Controller>
std::vector<std::string> causes_of(const Controller& c) {
  std::multimap<std::int64_t, std::string> lines;  // by their beats
  const auto at = [](std::int64_t beat) {
    return detail::formatted("after %.3f s", 1e-9 * static_cast<double>(beat * Controller::period()));
  };
  const bool has_faulted = c.state() == state::faulted;
  const std::string faulted = has_faulted ? c.fault_path() : std::string();
  std::string of_fault;
  c.for_each_component([&]<class C>(std::string_view path, const C& component) {
    if constexpr (detail::HasCause<C>)
      if (const cause said = component.cause()) {
        if (has_faulted && path == faulted) of_fault = ": " + said.what;
        else lines.emplace(said.beat, "`" + std::string(path) + "`, " + at(said.beat) + ": " + said.what);
      }
  });
  if constexpr (requires { c.fault_cause(); })  // of a deployment that has lost contact
    if (const std::string why = c.fault_cause(); !why.empty()) of_fault = ": " + why;
  if (has_faulted)
    lines.emplace(c.beat_index(), "fault" + (faulted.empty() ? "" : " in `" + faulted + "`") + ", " +
                                      at(c.beat_index()) + ": " + c.fault().reason() + of_fault);
  std::vector<std::string> texts;
  for (auto& [beat, text] : lines) texts.push_back(std::move(text));
  return texts;
}

}  // namespace cca
