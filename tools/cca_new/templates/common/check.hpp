// A test without a framework: it says what holds and what does not. With doctest or another one, write its
// CHECK instead.
#pragma once

#include <cstdio>

inline int failures = 0;

inline void check(bool holds, const char* what) {
  std::printf("%s  %s\n", holds ? "ok    " : "FAILED", what);
  failures += !holds;
}
