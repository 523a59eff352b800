// An architecture spread over environments: `deployment`, `deployed`.
#pragma once

#include <cca/cca.hpp>
#include <cca/graph/deployment.hpp>
#include <cca/runtime/environments/deployed.hpp>
