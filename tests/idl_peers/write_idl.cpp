// Writes the IDL of all spaces of the test: idlc makes the types of space_peer from it.
#include <iostream>

#include <cca/dds/idl.hpp>

#include "spaces.hpp"

int main() {
  std::cout << cca::idl<talk::leg_angles, talk::leg_torques, talk::any, talk::pads, talk::trunk_pose,
                        talk::paws, talk::mood, talk::picture>();
}
