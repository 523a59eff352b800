// Suites of laws before models that no robot can use: one does nothing, one refuses everything, one answers
// with the last value. A suite that such a model passes proves nothing.
//
//   TEST_CASE("learner") { of<a_case>("learner", "does nothing", laws::learner<a_case>); }
//
// `try_model` runs the suite and keeps what each of its laws found. main.cpp prints the results, and fails
// where no law has caught the model, or fewer than `least`.
#pragma once

#include <string_view>
#include <vector>

#include "../laws/law.hpp"

namespace useless {

struct result {
  laws::trial found;
  std::size_t least;
};
inline std::vector<result> results;

template <class Suite>
void try_model(std::string_view suite, std::string_view model, std::size_t least, Suite check_all) {
  laws::trial now{std::string(suite), std::string(model)};
  laws::now_tried = &now;
  check_all();
  laws::now_tried = nullptr;
  results.push_back({std::move(now), least});
}

inline constexpr std::string_view does_nothing = "does nothing", refuses = "refuses everything",
                                  repeats = "answers with the last value";

}  // namespace useless
