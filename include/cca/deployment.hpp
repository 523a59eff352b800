// An architecture spread over environments: `deployment`, `deployed`.
#pragma once

#include <cca/graph/deployment.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/runtime/environments/deployed.hpp>
