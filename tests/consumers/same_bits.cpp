// A user's program with the same bits everywhere.
#include "core.cpp"

#ifndef CCA_SAME_BITS
#error "the option CCA_SAME_BITS has not come here"
#endif
static_assert(sizeof(cca::same_bits_problem()) > 0);  // cca.hpp includes what checks it
