// Runs each suite of laws before its useless models. Prints how many of its laws caught each, and fails where
// fewer did than stated: a law has been weakened, or a model has become useful.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdio>
#include <string>

#include "trials.hpp"

namespace {

// Counts failed checks, and says nothing: they are what is wanted here.
struct counter : doctest::IReporter {
  explicit counter(const doctest::ContextOptions&) {}
  void log_assert(const doctest::AssertData& check) override {
    if (!check.m_failed) return;
    if (laws::now_tried) ++laws::now_tried->failed_checks;
    else std::printf("%s:%d: outside of a trial: %s\n", check.m_file, check.m_line, check.m_expr);
  }
  void test_case_exception(const doctest::TestCaseException& thrown) override {
    std::printf("an exception outside of a law: %s\n", thrown.error_string.c_str());
    ++strays;
  }
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_start(const doctest::TestCaseData&) override {}
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
  static inline int strays = 0;
};
REGISTER_REPORTER("counter", 1, counter);

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : "; ") + name;
  return all;
}

}  // namespace

int main(int count, char** arguments) {
  doctest::Context tests;
  tests.setOption("reporters", "counter");
  tests.applyCommandLine(count, arguments);
  tests.run();
  std::size_t wrong = 0;
  for (const auto& [found, least] : useless::results) {
    const bool is_wrong = found.caught.size() < least || found.caught.empty();
    wrong += is_wrong;
    std::printf("%s%-18s a model that %s: caught by %zu of %zu laws\n", is_wrong ? "WRONG " : "",
                found.suite.c_str(), found.model.c_str(), found.caught.size(),
                found.caught.size() + found.passed.size());
    if (is_wrong)
      std::printf("      expected at least %zu; these let it pass: %s\n", least,
                  joined(found.passed).c_str());
  }
  std::printf("%zu passed, %zu failed\n", useless::results.size() - wrong,
              wrong + static_cast<std::size_t>(counter::strays));
  return wrong > 0 || counter::strays > 0 || useless::results.empty();
}
