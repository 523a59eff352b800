// Rules about skeletons: the message of each mistake, and that the mended one is sound. Each skeleton here
// has a name of its own, so no message holds a long type; tests/rejects/many_nodes/templates.cpp has the
// others.
#include <tuple>

#include <cca/skeleton/farm_on_threads.hpp>

#include "rules_parts.hpp"

namespace {

using namespace parts;

// ---- choosing and mixing: two sources or more ----

template <cca::fixed_string... Sources>
struct chosen : cca::arbiter<"y", signal, cca::by_priority<Sources...>> {};
struct one_chosen : chosen<"a"> {};
struct two_chosen : chosen<"a", "b"> {};
template <class Arbiter, class... Items>
struct arbitrated
    : khz<cca::node<"a", source<>>, cca::node<"m", Arbiter>, cca::wire<"a.y", "m.a">, Items...> {};
static_assert(
    tells<arbitrated<one_chosen>, arbitrated<two_chosen, cca::node<"b", source<>>, cca::wire<"b.y", "m.b">>>(
        {"skeleton.arity", "m",
         "`m` (one_chosen) has 1 source, but between fewer than two there is nothing to choose or to mix: "
         "name two or more, or leave it out and wire its reader directly"}));

struct panel {
  auto process(cca::beat) -> cca::out<"choice", cca::choice> { return 0; }
};
struct one_switched : cca::switch_between<"y", signal, "a"> {};
struct two_switched : cca::switch_between<"y", signal, "a", "b"> {};
template <class Switch, class... Items>
struct switched : khz<cca::node<"a", source<>>,
                      cca::node<"p", panel>,
                      cca::node<"m", Switch>,
                      cca::wire<"p.choice", "m.choice">,
                      cca::wire<"a.y", "m.a">,
                      Items...> {};
static_assert(
    tells<switched<one_switched>, switched<two_switched, cca::node<"b", source<>>, cca::wire<"b.y", "m.b">>>(
        {"skeleton.arity", "m",
         "`m` (one_switched) has 1 source, but between fewer than two there is nothing to choose or to mix: "
         "name two or more, or leave it out and wire its reader directly"}));

template <class... Axes>
struct weights : cca::space<cca::amplitude, cca::axes<Axes...>> {};
struct two_weights : weights<cca::x, cca::y> {};
struct three_weights : weights<cca::x, cca::y, cca::z> {};
struct blended_by_two : cca::blend<"y", signal, two_weights, "a", "b", "c"> {};
struct blended_by_three : cca::blend<"y", signal, three_weights, "a", "b", "c"> {};
template <class Blend, class Weights>
struct blended : khz<cca::node<"a", source<>>,
                     cca::node<"w", source<Weights>>,
                     cca::node<"m", Blend>,
                     cca::wire<"w.y", "m.weight">,
                     cca::wire<"a.y", "m.a">,
                     cca::wire<"a.y", "m.b">,
                     cca::wire<"a.y", "m.c">> {};
static_assert(tells<blended<blended_by_two, two_weights>, blended<blended_by_three, three_weights>>(
    {"skeleton.arity", "m",
     "`m` (blended_by_two) blends 3 sources by 2 weights, but it takes one for each source, or of two "
     "sources one: give it a space of weights with 3 axes"}));

// ---- taking apart and putting together: a number for each axis ----

struct world : cca::frame<"world"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct attitude : cca::space<cca::orientation<world>, xyz> {};
struct place : cca::space<cca::cartesian_position<world>, xyz> {};

struct split_attitude : cca::splitter<"whole", attitude> {};
struct split_place : cca::splitter<"whole", place> {};
template <class Splitter, class Space>
struct apart : khz<cca::node<"a", source<Space>>, cca::node<"s", Splitter>, cca::wire<"a.y", "s.whole">> {};
static_assert(tells<apart<split_attitude, attitude>, apart<split_place, place>>(
    {"skeleton.arity", "s",
     "`s` (split_attitude) is to take attitude apart, which has 4 numbers over 3 axes, so none of them "
     "belongs to one axis: use a space with one number per axis, for example the roll, pitch and yaw of "
     "an orientation"}));

struct whole_attitude : cca::collector<"whole", attitude> {};
struct whole_place : cca::collector<"whole", place> {};
template <class Collector>
struct together : khz<cca::node<"x", source<cca::sub_space<place, cca::x>>>,
                      cca::node<"y", source<cca::sub_space<place, cca::y>>>,
                      cca::node<"z", source<cca::sub_space<place, cca::z>>>,
                      cca::node<"c", Collector, cca::moderate>,
                      cca::wire<"x.y", "c.x">,
                      cca::wire<"y.y", "c.y">,
                      cca::wire<"z.y", "c.z">> {};
static_assert(tells<together<whole_attitude>, together<whole_place>>(
    {"skeleton.arity", "c",
     "`c` (whole_attitude) is to put attitude together, which has 4 numbers over 3 axes, so it is not "
     "made of one for each: collect what it is computed from, and compute it in a component"}));

// ---- sharing out: a whole number of parts ----

struct heel : cca::dimension<"heel"> {};
struct three : cca::space<cca::joint_angles, cca::axes<hip, knee, toe>> {};
struct four : cca::space<cca::joint_angles, cca::axes<hip, knee, toe, heel>> {};
struct shared_by_three : cca::farm<step<angles>, three, three> {};
struct shared_by_four : cca::farm<step<angles>, four, four> {};
template <class Farm, class Space>
struct shared : khz<cca::node<"a", source<Space>>, cca::node<"f", Farm>, cca::wire<"a.y", "f.input">> {};
static_assert(tells<shared<shared_by_three, three>, shared<shared_by_four, four>>(
    {"skeleton.arity", "f",
     "`f` (shared_by_three) cannot be shared out: what comes in, three (joint_angles over 3 axes) is no "
     "whole number of angles (joint_angles over 2), what goes out, three (joint_angles over 3 axes) is no "
     "whole number of angles (joint_angles over 2); give it spaces with as many parts of what a worker "
     "takes as of what it gives, like cca::array_of<angles, 4>"}));

struct twice : cca::pipeline<step<angles>, step<angles>> {};
struct graph_on_threads : cca::farm_on_threads<twice, four, four> {};
struct step_on_threads : cca::farm_on_threads<step<angles>, four, four> {};
static_assert(tells<shared<graph_on_threads, four>, shared<step_on_threads, four>>(
    {"skeleton.arity", "f",
     "`f` (graph_on_threads) is to have twice on threads, but that is a graph, whose nodes run in the "
     "loop: put what it does into one component"}));

struct may_fault {
  auto process(cca::in<"x", angles>) -> std::tuple<cca::out<"y", angles>, cca::fault> { return {}; }
};
struct fault_on_threads : cca::farm_on_threads<may_fault, four, four> {};
static_assert(tells<shared<fault_on_threads, four>, shared<step_on_threads, four>>(
    {"skeleton.arity", "f",
     "`f` (fault_on_threads) is to have may_fault on threads, but that may return a fault, which would "
     "reach the loop too late: publish a status instead"}));
struct shared_by_merge : cca::farm<merge<angles>, four, four> {};
static_assert(tells<shared<shared_by_merge, four>, shared<shared_by_four, four>>(
    {"skeleton.arity", "f",
     "`f` (shared_by_merge) is a farm whose worker merge<angles> has 2 inputs that must be wired and 1 "
     "output (of a status none counts), but it takes what has one of each: make the other inputs "
     "cca::optional_in, or wire it by hand"}));

// ---- one after the other: what has one input and one output ----

struct either {
  auto process(cca::in<"a", signal> a, cca::optional_in<"b", signal>) -> cca::out<"y", signal> {
    return a.vector();
  }
};
struct by_merge : cca::pipeline<step<>, merge<>> {};
struct by_either : cca::pipeline<step<>, either> {};
static_assert(tells<shared<by_merge, signal>, shared<by_either, signal>>(
    {"skeleton.arity", "f",
     "`f` (by_merge) is a pipeline whose stage 1 merge<> has 2 inputs that must be wired and 1 output (of "
     "a status none counts), but it takes what has one of each: make the other inputs cca::optional_in, "
     "or wire it by hand"}));

struct one_stage : cca::pipeline<step<>> {};
static_assert(tells<shared<one_stage, signal>, shared<by_either, signal>>(
    {"skeleton.arity", "f",
     "`f` (one_stage) has 1 stage, but a pipeline has two or more: name more, or use the one stage as a "
     "node itself"}));

// ---- from one rate to another ----

template <int Rate, class Axes = cca::axes<cca::x>>
struct at : cca::space<cca::number, Axes, cca::rate<Rate>> {};
struct at_1000 : at<1000> {};
struct at_300 : at<300> {};
struct at_250 : at<250> {};
struct two_at_1000 : at<1000, cca::axes<cca::x, cca::y>> {};

struct held_over_others : cca::hold<at_250, two_at_1000> {};
struct held : cca::hold<at_250, at_1000> {};
struct uneven_smooth : cca::interpolate<at_300, at_1000> {};
struct smooth : cca::interpolate<at_250, at_1000> {};
template <class Rise>
struct rising : khz<cca::node<"a", source<>, cca::timed<4>>,
                    cca::node<"h", Rise, cca::timed<1>>,
                    cca::wire<"a.y", "h.input", cca::latest>> {};
static_assert(tells<rising<held_over_others>, rising<held>>(
    {"skeleton.arity", "h",
     "`h` (held_over_others) leads from at_250 (250 Hz) to two_at_1000 (1000 Hz), which differ in more "
     "than their rate: name two spaces of one domain type over the same axes"}));
static_assert(tells<rising<uneven_smooth>, rising<smooth>>(
    {"skeleton.arity", "h",
     "`h` (uneven_smooth) leads from at_300 (300 Hz) to at_1000 (1000 Hz), but the first must have a rate "
     "that is a whole part of that of the second, at most half of it: state rates like 100 and 1000 Hz"}));

struct uneven_slow : cca::decimate<at_1000, at_300> {};
struct slow : cca::decimate<at_1000, at_250> {};
static_assert(tells<shared<uneven_slow, signal>, shared<slow, signal>>(
    {"skeleton.arity", "f",
     "`f` (uneven_slow) leads from at_1000 (1000 Hz) to at_300 (300 Hz), but the first must have a rate "
     "that is a whole multiple of that of the second, at least twice it: state rates like 1000 and 100 Hz"}));

}  // namespace
