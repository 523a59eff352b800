// Which environments of a deployment this process runs; other processes run the rest.
//
//   cca::deployed<split> d(cca::only{"robot"}, cca::shared_memory("/trot"));
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace cca {

struct only {
  only(std::initializer_list<std::string_view> environments)
      : names(environments.begin(), environments.end()) {}
  explicit only(const std::vector<std::string>& environments) : names(environments) {}
  std::vector<std::string> names;
};

}  // namespace cca
