// What the system refused to the threads of environments that are to run in real time: an error where they
// must, else said once.
#pragma once

#include <array>
#include <iostream>
#include <string>

#include <cca/base/refused.hpp>
#include <cca/runtime/environments/exchange.hpp>
#include <cca/runtime/environments/realtime.hpp>

namespace cca::detail {

template <class D>
class real_time_refusals {
public:
  template <int E>
  void report(const std::string& refusal) {
    if (refusal.empty()) return;
    const std::string text = "cca::deployed: environment `" + std::string(name_of_environment<D>(E)) +
                             "` does not run in real time: " + refusal;
    if (wish_of_environment<D, E>.is_needed) throw refused(text);
    if (!is_told[E]) std::cerr << text << '\n';
    is_told[E] = true;
  }

private:
  std::array<bool, array_size(environment_count<D>)> is_told{};
};

}  // namespace cca::detail
