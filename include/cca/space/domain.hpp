// Domain types: what the coordinates of a space mean. docs/spaces.md lists them.
//
// A domain type is an empty struct with
//   quantity             what is measured along its axes (quantity.hpp), or void
//   actuated             whether its samples command joints: then its axes must state limits
//   width(axes)          how many numbers a sample over so many axes has
//   zero(i, axes)        number i of the zero, which an input holds until a first sample has come
//   methods<Self>        what samples inherit from it; Self is the sample
//   frames               where it has any: those that must agree for two samples to be combined
#pragma once

#include <cca/space/cartesian.hpp>
#include <cca/space/joint.hpp>
#include <cca/space/orientation.hpp>
#include <cca/space/phase.hpp>
#include <cca/space/pose.hpp>
#include <cca/space/scalar.hpp>
#include <cca/space/twist_wrench.hpp>
