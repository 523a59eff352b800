// What the compilers must be told so that a beat becomes one function. All of it stands here; CONTRIBUTING.md
// says where it may be used.
//
// CCA_INLINE         a function of the library that a beat consists of. On g++ it is an ordinary inline
//                    function, and `flatten` on the beat inlines it: g++'s early passes do not look through
//                    always_inline functions. clang's `flatten` reaches direct calls only, so there it is
//                    always_inline.
// CCA_INLINE_CALL    before a statement: the calls in it are inlined. For the functions of components, which
//                    are the users' own. clang only, for the same reason.
// CCA_BEAT           a function that is a beat, or a part of one: everything that it calls is inlined. Not
// where
//                    CCA_EDIT is defined, for work on a program: there it takes g++ a fifth of the time. g++
//                    also unrolls a loop over the axes of a sample in it, as clang does at -O2 and g++ only at
//                    -O3. It then sees that a component fills its output, and drops the zeros with which the
//                    output began (docs/decisions/0017).
// CCA_REPLAYED_BEAT  a beat of which only the bits count, not the speed: nothing is inlined into it, so it
//                    compiles faster. A machine that fuses a product and a sum fuses others when other code
//                    is inlined, and its bits differ: there it is CCA_BEAT.
// CCA_ASSUME(...)    a condition that holds. clang only: g++ counts it as code and inlines less.
// CCA_STAY_ROLLED    before a loop that rarely runs. clang would unroll it, which costs the rest of the beat
//                    registers; g++ leaves it alone.
//
// call_simplified<f>(...) calls a function that many calls of a beat share. clang gets it as a pointer that
// it resolves while it inlines: by then it has simplified the function, once for all its calls. With a direct
// call a graph of 1,000 nodes takes clang twice the time (docs/performance.md).
// simplified_first<f>() is f, for a function that is inlined wherever it is called. clang inlines such calls
// before it simplifies anything; what the function itself calls then has two callers, the function and the
// beat, and a static function of two callers is not inlined where it is large. clang gets f from a function
// that it inlines later: by then f has been simplified, with what only it calls.
//
// copies_in_pieces   g++ with AVX, see copy_block.hpp. g++ copies what memcpy copies in pieces of 16 bytes. A
//                    loop that it has vectorised stores 32 bytes at a time, so it can't see that both are the
//                    same numbers, and keeps the copy: a graph of 22 nodes with samples of eight axes took
//                    302 instructions per beat instead of 221 (docs/decisions/0017). Pieces of 32 bytes
//                    match. Without AVX its vectors have 16 bytes, and memcpy matches. clang drops either
//                    copy.
// shows_in_place     g++ without AVX. There a loop over the axes stays a loop, and g++ keeps each copy that
//                    one reads: inputs of more than four numbers refer to results of the same beat instead
//                    (docs/decisions/0017).
//
// Eigen reads two macros, so eigen.hpp includes this header before it:
// EIGEN_DISABLE_UNALIGNED_ARRAY_ASSERT: since C++17 `new` aligns as the type asks, so Eigen's check of an
// array's alignment never fires. Without NDEBUG it makes the constructor of each vector too large for g++ 12
// to inline, and a beat would be full of calls.
// EIGEN_STRONG_INLINE: Eigen forces inlining only on MSVC. Without it clang simplifies the parts of an
// expression first and loads a factor and the pointer beside it as one packet; the expression and the port
// then stay in memory.
//
// Attributes that both compilers know are written where they are needed; docs/compilers.md says why each is:
// [[gnu::always_inline]]  a function that clang would call, of components and their equations
// [[gnu::noinline]]       what a beat seldom needs, so that it takes no registers from the rest
#pragma once

#include <cca/base/compiler.hpp>

#ifndef EIGEN_DISABLE_UNALIGNED_ARRAY_ASSERT
#define EIGEN_DISABLE_UNALIGNED_ARRAY_ASSERT
#endif

// With a sanitizer clang inlines what it likes: a beat that is one function with the sanitizer's code in it
// takes it minutes and gigabytes (docs/compilers.md).
#if defined(__clang__) && !CCA_SANITIZED && !defined(EIGEN_STRONG_INLINE)
#define EIGEN_STRONG_INLINE __attribute__((always_inline)) inline
#endif

#if defined(__clang__) && !CCA_SANITIZED
#define CCA_INLINE [[gnu::always_inline]] inline
#define CCA_INLINE_CALL [[clang::always_inline]]
#define CCA_ASSUME(condition) __builtin_assume(condition)
#define CCA_STAY_ROLLED _Pragma("clang loop unroll(disable) vectorize(disable)")
#else
#define CCA_INLINE inline
#define CCA_INLINE_CALL
#define CCA_ASSUME(condition)
#define CCA_STAY_ROLLED
#endif

#if defined(CCA_EDIT)
#define CCA_BEAT
#elif !defined(__clang__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__)
#define CCA_BEAT [[gnu::flatten, gnu::optimize("peel-loops")]]
#else
#define CCA_BEAT [[gnu::flatten]]
#endif
#if (defined(__x86_64__) && !defined(__FMA__) && !defined(__FMA4__)) || defined(__wasm__)
#define CCA_REPLAYED_BEAT
#else
#define CCA_REPLAYED_BEAT CCA_BEAT
#endif

namespace cca::detail {

#if defined(__AVX__) && !defined(__clang__)
inline constexpr bool copies_in_pieces = true;
#else
inline constexpr bool copies_in_pieces = false;
#endif
#if !defined(__AVX__) && !defined(__clang__)
inline constexpr bool shows_in_place = true;
#else
inline constexpr bool shows_in_place = false;
#endif

#if defined(__clang__)
template <auto Function>
inline auto simplified_first() {
  return Function;
}
template <class Function, class... Arguments>
inline void call_through(Function* function, const Arguments&... arguments) {
  function(arguments...);
}
template <auto* Function, class... Arguments>
CCA_INLINE void call_simplified(const Arguments&... arguments) {
  call_through(Function, arguments...);
}
#else
template <auto Function>
constexpr auto simplified_first() {
  return Function;
}
template <auto* Function, class... Arguments>
CCA_INLINE void call_simplified(const Arguments&... arguments) {
  Function(arguments...);
}
#endif

}  // namespace cca::detail
