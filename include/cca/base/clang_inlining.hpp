// [[clang::always_inline]] on a function: clang alone would leave a call of it in the beat. g++ inlines a
// whole beat by `flatten` and ignores the attribute; without this pragma it would warn of it.
#pragma once

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored_attributes "clang::"
#endif
