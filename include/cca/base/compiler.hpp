// Refuses, in a sentence, a language or a compiler in which cca can't be compiled. Without it the compiler
// would print thousands of lines, or crash.
//
// #error alone does not stop a compiler; a missing file does.
// Errors: compiler.too_old.
#pragma once

#if __cplusplus < 202002L
#error "compiler.too_old: cca is written in C++20: compile with -std=c++20 or later"
#include <cca/base/the_error_above_says_what_cca_needs>
#endif

#if defined(__apple_build_version__)
#elif defined(__clang__) && __clang_major__ < 17
#error "compiler.too_old: cca needs clang 17 or later, since clang 16 crashes on it; clang 19 is tested"
#include <cca/base/the_error_above_says_what_cca_needs>
#elif !defined(__clang__) && defined(__GNUC__) && __GNUC__ < 12
#error "compiler.too_old: cca needs g++ 12 or later; g++ 12 is tested"
#include <cca/base/the_error_above_says_what_cca_needs>
#endif
