// Domain types: what the coordinates of a space mean. docs/spaces.md lists them.
//
// A domain type is an empty struct with
//   quantity             what is measured along its axes (quantity.hpp), or void
//   actuated             true if its samples command joints; then its axes must state limits
//   width(axes)          how many numbers a sample over this many axes has
//   axis_count           only if it is over so many axes and no other number of them
//   zero(i, axes)        number i of the zero; an input holds the zero until its first sample arrives
//   methods<Self>        what samples inherit from it; Self is the sample
//   coordinates          only if they aren't the axes: the names of the numbers, and coordinate_units
//   frames               only if it has frames: two samples can be combined only if these are equal
#pragma once

#include <cca/space/cartesian.hpp>
#include <cca/space/cartesian_stiffness.hpp>
#include <cca/space/joint.hpp>
#include <cca/space/orientation.hpp>
#include <cca/space/phase.hpp>
#include <cca/space/pose.hpp>
#include <cca/space/methods/scalar.hpp>
#include <cca/space/twist_wrench.hpp>
