// A former path of dds/domain/network.hpp: which network DDS uses.
#pragma once

#include <cca/dds/domain/network.hpp>
