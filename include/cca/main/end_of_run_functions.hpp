// The sentences after a run. end_of_run.hpp includes this, unless they are compiled once for the program
// (cca/base/separate/compiled.hpp).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/main/end_of_run.hpp>

namespace cca::detail {

CCA_MAIN_INLINE void add_summary(std::string_view path,
                                 const std::string& said,
                                 std::vector<std::string>& lines) {
  if (!said.empty()) lines.push_back("`" + std::string(path) + "`: " + said);
}

CCA_MAIN_INLINE void add_lost_samples(const std::string& input,
                                      std::int64_t lost,
                                      int room,
                                      std::vector<std::string>& lines) {
  if (lost > 0)
    lines.push_back("`" + input + "`: its queue of " + std::to_string(room) + " was full and lost " +
                    std::to_string(lost) + (lost == 1 ? " sample" : " samples"));
}

CCA_MAIN_INLINE std::vector<std::string> causes_of_run::sentences(const fault_of_run* fault) const {
  std::multimap<std::int64_t, std::string> lines;  // by beat; of one beat, as they come
  const auto at = [this](std::int64_t beat) {
    return formatted("after %.3f s", 1e-9 * static_cast<double>(beat * period));
  };
  std::string of_fault;
  for (const auto& [path, said] : all) {
    if (!said) continue;
    if (fault && path == fault->path) of_fault = ": " + said.what;
    else lines.emplace(said.beat, "`" + path + "`, " + at(said.beat) + ": " + said.what);
  }
  if (fault) {
    if (!fault->cause.empty()) of_fault = ": " + fault->cause;
    lines.emplace(fault->beat, "fault" + (fault->path.empty() ? "" : " in `" + fault->path + "`") + ", " +
                                   at(fault->beat) + ": " + fault->reason + of_fault);
  }
  std::vector<std::string> texts;
  for (auto& [beat, text] : lines) texts.push_back(std::move(text));
  return texts;
}

}  // namespace cca::detail
