// Which environments of a deployment this process runs; other processes run the rest.
//
//   cca::deployed<split> d(cca::only{"robot"}, cca::shared_memory("/trot"));
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/nearest.hpp>
#include <cca/base/refused.hpp>
#include <cca/runtime/environments/exchange/exchange.hpp>

namespace cca {

struct only {
  only(std::initializer_list<std::string_view> environments)
      : names(environments.begin(), environments.end()) {}
  explicit only(const std::vector<std::string>& environments) : names(environments) {}
  std::vector<std::string> names;
};

namespace detail {

template <class D>
[[noreturn]] void refuse_environment(std::string_view name) {
  std::array<std::string_view, environments_here<D>().size()> names{};
  for (std::size_t e = 0; e < names.size(); ++e) names[e] = name_of_environment<D>(e);
  std::string text = "cca::only: the deployment has no environment `";  // append: docs/compilers.md
  text.append(name).append("`");
  if (const auto near = nearest_name(name, names); !near.empty())
    text.append("; did you mean `").append(near).append("`?");
  throw refused(text);
}

template <class D>
environments_here<D> chosen_environments(const only& environments) {
  environments_here<D> here{};
  for (const std::string& name : environments.names) {
    std::size_t e = 0;
    while (e < here.size() && name_of_environment<D>(e) != name) ++e;
    if (e == here.size()) refuse_environment<D>(name);
    here[e] = true;
  }
  if (environments.names.empty()) throw refused("cca::only: it names no environment");
  return here;
}

}  // namespace detail
}  // namespace cca
