// How the loop is made one function. On g++ the glue is ordinary and `flatten` on the beat inlines it, since
// g++'s early pass does not look through always_inline functions; clang's `flatten` reaches only direct
// calls, so there the glue and the calls of components are always_inline.
//
// One is a function that many are alike, put together before it is inlined for each of them: on g++ by
// `flatten`; clang does so with what it calls through a pointer that it comes to know while it inlines.
//
// What is assumed only clang is told: g++ would take it for code, and inline less. Nor need g++ be told that
// a loop stays one; clang would unroll a seldom one, at the cost of registers in the rest of the beat.
#pragma once

#if defined(__clang__)
#define CCA_GLUE [[gnu::always_inline]] inline
#define CCA_INLINE_CALL [[clang::always_inline]]
#define CCA_ONE CCA_GLUE
#define CCA_ASSUME(condition) __builtin_assume(condition)
#define CCA_STAY_ROLLED _Pragma("clang loop unroll(disable) vectorize(disable)")
namespace cca::detail {
inline constexpr bool inlines_through = true;
}
#else
#define CCA_GLUE inline
#define CCA_INLINE_CALL
#define CCA_ONE [[gnu::flatten]]
#define CCA_ASSUME(condition)
#define CCA_STAY_ROLLED
namespace cca::detail {
inline constexpr bool inlines_through = false;
}
#endif
