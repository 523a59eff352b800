// Traces: when each component fired and how long it took. docs/traces.md.
#pragma once

#include <cca/graph/marks/traceable.hpp>
#include <cca/trace/tracer.hpp>
