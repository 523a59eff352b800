// An Oncilla's hips and knees, each with a drive: a to h.
#pragma once

#include "oncilla.hpp"

struct a : joint<sim::left_front_hip, 1, 0> {};
struct b : joint<sim::right_front_hip, 2, 2> {};
struct c : joint<sim::left_hind_hip, 3, 1> {};
struct d : joint<sim::right_hind_hip, 4, 3> {};
struct e : joint<sim::left_front_knee, 5, 0> {};
struct f : joint<sim::right_front_knee, 6, 2> {};
struct g : joint<sim::left_hind_knee, 7, 1> {};
struct h : joint<sim::right_hind_knee, 8, 3> {};
