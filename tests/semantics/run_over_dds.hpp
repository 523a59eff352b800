// Runs an architecture that is spread over environments: as threads, and as processes over Cyclone DDS.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <memory>
#include <string>

#include <cca/dds.hpp>

#include "run_deployed.hpp"

namespace semantics {

template <class Deployment, class Around>
outcome run_over_dds(int chance) {
  static const auto domain = static_cast<std::uint32_t>(::getpid()) % 200;
  outcome o = run_deployed<Deployment, Around>(chance);
  o.processes_agree = processes_agree<Deployment, Around>(
      chance, o.firings, [](const std::string& name) { return cca::dds::domain(domain, name); });
  return o;
}

}  // namespace semantics
