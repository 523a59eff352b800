// Shared by the tests of this folder: a module that was taught a shape, in a controller.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/hopf.hpp>

#include "../../laws/temporary_file.hpp"
#include "../motor/rig.hpp"

namespace adaptive_test {

using motor_test::hip;
using motor_test::knee;
using motor_test::leg;
using motor_test::stride;

using temporary = laws::temporary_file;

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

}  // namespace adaptive_test
