// A former path of record/file/settings.hpp: how a recording is written.
#pragma once

#include <cca/record/file/settings.hpp>
