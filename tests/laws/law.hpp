// A law of a suite. In a test it is checked as it stands. In the trial of a useless model
// (tests/useless_models) it is counted: a law that such a model breaks has caught it.
#pragma once

#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

namespace laws {

// One suite before one model that must not pass.
struct trial {
  std::string suite{}, model{};
  std::vector<std::string> caught{}, passed{};  // the laws that the model broke, and the others
  std::size_t failed_checks = 0;
};
inline trial* now_tried = nullptr;  // null: this is a test

template <class Check>
void law(const char* name, Check check) {
  if (now_tried == nullptr) return check();
  const std::size_t before = now_tried->failed_checks;
  try {
    check();
  } catch (const doctest::detail::TestFailureException&) {  // a failed REQUIRE, which is counted already
  } catch (const std::exception&) { ++now_tried->failed_checks; }
  auto& list = now_tried->failed_checks > before ? now_tried->caught : now_tried->passed;
  list.emplace_back(name);
}

}  // namespace laws
