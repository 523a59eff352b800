// An architecture spread over environments: `deployment`, `deployed`, and the transports of the core:
// threads, shared memory.
#pragma once

#include <cca/graph/items/deployment.hpp>
#include <cca/graph/describe_modes.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/runtime/environments/deployed.hpp>
#include <cca/runtime/transports/shared_memory.hpp>
