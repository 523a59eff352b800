// How the loop is made one function. On g++ the glue is ordinary and `flatten` on the beat inlines it, since g++'s early
// pass does not look through always_inline functions; clang's `flatten` reaches only direct calls, so there the glue and
// the calls of components are always_inline.
//
// One is a function that many are alike, put together before it is inlined for each of them.
//
// A piece is a function of its own that clang simplifies before it inlines it, which it does in any case since nobody else
// calls it. All in one go would take it time that grows with the square of the beat's length, and leave more behind.
#pragma once

#if defined(__clang__)
#define CCA_GLUE [[gnu::always_inline]] inline
#define CCA_INLINE_CALL [[clang::always_inline]]
#define CCA_ONE CCA_GLUE
#define CCA_PIECE [[clang::internal_linkage]]
namespace cca::detail { inline constexpr bool in_pieces = true; }
#else
#define CCA_GLUE inline
#define CCA_INLINE_CALL
#define CCA_ONE [[gnu::flatten]]
#define CCA_PIECE inline
namespace cca::detail { inline constexpr bool in_pieces = false; }
#endif
