// Tutorial, step 4: the graph as a picture, in Mermaid. docs/tutorial/4_two_rates.md
#include <cstdio>

#include "swinging_leg.hpp"

int main() { std::fputs(cca::describe<swinging_leg>::mermaid().c_str(), stdout); }
