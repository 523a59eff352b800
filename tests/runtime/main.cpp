// The only file with doctest's main: compiled once, linked into each test program.
// Both macros: with the precompiled header, doctest.h is included before it can define the first by itself.
#define DOCTEST_CONFIG_IMPLEMENT
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
