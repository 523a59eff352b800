// The core of the Compliant Control Architecture: spaces, components, graphs, controllers.
// Parameters from a file need <cca/config.hpp> as well.
#pragma once

#include <cca/base/compiler.hpp>

// These come first: if they refuse something, the compilers list every file that is already open.
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/reflect.hpp>
#include <cca/component/port.hpp>

#include <cca/runtime/component_host.hpp>

#include <cca/runtime/refusal.hpp>

#include <cca/runtime/strategy_inputs.hpp>

#include <cca/component/component.hpp>
#include <cca/component/parameters.hpp>
#include <cca/graph/describe.hpp>
#include <cca/graph/verdict/diagnosis.hpp>
#include <cca/graph/items/graph.hpp>
#include <cca/graph/items/test_input.hpp>
#include <cca/robot/limiter.hpp>
#include <cca/robot/watchdog.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/runtime/pace.hpp>
#include <cca/skeleton/arbiter.hpp>
#include <cca/skeleton/blend.hpp>
#include <cca/skeleton/collector.hpp>
#include <cca/skeleton/decimate.hpp>
#include <cca/skeleton/farm.hpp>
#include <cca/skeleton/hold.hpp>
#include <cca/graph/items/inner_wires.hpp>
#include <cca/skeleton/interpolate.hpp>
#include <cca/skeleton/pipeline.hpp>
#include <cca/skeleton/splitter.hpp>
#include <cca/skeleton/switch_between.hpp>
#include <cca/space/array.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/sample.hpp>
#include <cca/version.hpp>
