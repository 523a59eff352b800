// EXPECT: modes\.bad_mode: mode `legs` of moves is a set of modes, legs, but one set holds all modes: list its modes in moves instead of it
// A set of modes is no mode of another one.
#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};
struct rest : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};
struct fall : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};
struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

struct moves : cca::modes<
#if CCA_REJECT
                   cca::mode<"legs", legs>,
#else
                   cca::mode<"walk", walk>,
                   cca::mode<"rest", rest>,
#endif
                   cca::mode<"fall", fall>> {
};

struct split : cca::deployment<moves, cca::environment<"one", cca::other_nodes>> {};

cca::deployed<split> d;
