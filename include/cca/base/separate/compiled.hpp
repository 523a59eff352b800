// What depends on no type of a program can be compiled once, beside it, instead of in each of its files: the
// inside of the simulator (sim), the reading of the command line (main), of parameter files (config), the
// files of recordings (record), and the network side of a door (door).
//
// The CMake targets cca::sim, cca::main, cca::config, cca::record and cca::door do so. They define
// CCA_COMPILED_SIM, CCA_COMPILED_MAIN, CCA_COMPILED_CONFIG, CCA_COMPILED_RECORD and CCA_COMPILED_DOOR, and
// link a small library of the program's own project, which is built with the project's flags: so it gives the
// same bits. Without CMake, with the CMake option CCA_COMPILED=OFF, and in a file that defines
// CCA_HEADER_ONLY, all is in the headers, as ever.
//
// In the headers of these parts, functions are declared in one header and defined in another, which begins
// each of them with CCA_SIM_INLINE, CCA_MAIN_INLINE, CCA_CONFIG_INLINE, CCA_RECORD_INLINE or
// CCA_DOOR_INLINE.
// docs/compile_time.md
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

#if defined(CCA_COMPILED_CONFIG) && !defined(CCA_HEADER_ONLY)
#define CCA_HAS_COMPILED_CONFIG 1
#define CCA_CONFIG_INLINE
#else
#define CCA_HAS_COMPILED_CONFIG 0
#define CCA_CONFIG_INLINE inline
#endif

#if defined(CCA_COMPILED_RECORD) && !defined(CCA_HEADER_ONLY)
#define CCA_HAS_COMPILED_RECORD 1
#define CCA_RECORD_INLINE
#else
#define CCA_HAS_COMPILED_RECORD 0
#define CCA_RECORD_INLINE inline
#endif

#if defined(CCA_COMPILED_DOOR) && !defined(CCA_HEADER_ONLY)
#define CCA_HAS_COMPILED_DOOR 1
#define CCA_DOOR_INLINE
#else
#define CCA_HAS_COMPILED_DOOR 0
#define CCA_DOOR_INLINE inline
#endif
