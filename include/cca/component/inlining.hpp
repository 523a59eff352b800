// How the loop is made one function. On g++ the glue is ordinary and `flatten` on the beat inlines it, since g++'s early
// pass does not look through always_inline functions; clang's `flatten` reaches only direct calls, so there the glue and
// the calls of components are always_inline.
#pragma once

#if defined(__clang__)
#define CCA_GLUE [[gnu::always_inline]] inline
#define CCA_INLINE_CALL [[clang::always_inline]]
#else
#define CCA_GLUE inline
#define CCA_INLINE_CALL
#endif
