// The configuration of the physics engine for WebAssembly: one thread, no trimesh. ODE's own `configure`
// would write it.
#pragma once
#define HAVE_ALLOCA_H 1
#define HAVE_GETTIMEOFDAY 1
#define HAVE_ISNAN 1
#define HAVE_STDINT_H 1
#define HAVE_STDLIB_H 1
#define HAVE_SYS_TIME_H 1
#define HAVE_UNISTD_H 1

#define dOU_ENABLED 1
#define _OU_NAMESPACE odeou
#define _OU_FEATURE_SET _OU_FEATURE_SET_BASICS
#define _OU_TARGET_OS _OU_TARGET_OS_GENUNIX
#define dTHREADING_INTF_DISABLED 1

#include <alloca.h>
#include <stdint.h>

#include "typedefs.h"
