// What depends on no type of a program can be compiled once, beside it, instead of in each of its files: the
// inside of the simulator (sim) and the reading of the command line (main).
//
// The CMake targets cca::sim and cca::main do so. They define CCA_COMPILED_SIM and CCA_COMPILED_MAIN, and
// link a small library of the program's own project, which is built with the project's flags: so it gives the
// same bits. Without CMake, with the CMake option CCA_COMPILED=OFF, and in a file that defines
// CCA_HEADER_ONLY, all is in the headers, as ever.
//
// In the headers of these parts, functions are declared in one header and defined in another, which begins
// each of them with CCA_SIM_INLINE or CCA_MAIN_INLINE. docs/compile_time.md
#pragma once

#if defined(CCA_COMPILED_SIM) && !defined(CCA_HEADER_ONLY)
#define CCA_HAS_COMPILED_SIM 1
#define CCA_SIM_INLINE
#else
#define CCA_HAS_COMPILED_SIM 0
#define CCA_SIM_INLINE inline
#endif

#if defined(CCA_COMPILED_MAIN) && !defined(CCA_HEADER_ONLY)
#define CCA_HAS_COMPILED_MAIN 1
#define CCA_MAIN_INLINE
#else
#define CCA_HAS_COMPILED_MAIN 0
#define CCA_MAIN_INLINE inline
#endif
