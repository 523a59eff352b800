// An engine that gives up within a step can't be destroyed (cca/sim/engine/engine.hpp), so its memory is
// lost. What is allocated while a lost_engine lives is not reported by the sanitizer.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define CCA_FINDS_LEAKS 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CCA_FINDS_LEAKS 1
#endif
#endif

#if defined(CCA_FINDS_LEAKS)
#include <sanitizer/lsan_interface.h>

using lost_engine = __lsan::ScopedDisabler;
#else
struct lost_engine {};
#endif
