// What the compilers must be told so that a beat becomes one function. All of it stands here; CONTRIBUTING.md
// says where it may be used.
//
// CCA_INLINE         a function of the library that a beat consists of. On g++ it is an ordinary inline
//                    function, and `flatten` on the beat inlines it: g++'s early passes do not look through
//                    always_inline functions. clang's `flatten` reaches direct calls only, so there it is
//                    always_inline.
// CCA_INLINE_CALL    before a statement: the calls in it are inlined. For the functions of components, which
//                    are the users' own. clang only, for the same reason.
// CCA_ASSUME(...)    a condition that holds. clang only: g++ counts it as code and inlines less.
// CCA_STAY_ROLLED    before a loop that rarely runs. clang would unroll it, which costs the rest of the beat
//                    registers; g++ leaves it alone.
//
// call_simplified<f>(...) calls a function that many calls of a beat share. clang gets it as a pointer that
// it resolves while it inlines: by then it has simplified the function, once for all its calls. With a direct
// call a graph of 1,000 nodes takes clang twice the time (docs/performance.md).
#pragma once

#include <cca/base/compiler.hpp>

#if defined(__clang__)
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

namespace cca::detail {

#if defined(__clang__)
template <class Function, class... Arguments>
inline void call_through(Function* function, const Arguments&... arguments) {
  function(arguments...);
}
template <auto* Function, class... Arguments>
CCA_INLINE void call_simplified(const Arguments&... arguments) {
  call_through(Function, arguments...);
}
#else
template <auto* Function, class... Arguments>
CCA_INLINE void call_simplified(const Arguments&... arguments) {
  Function(arguments...);
}
#endif

}  // namespace cca::detail
