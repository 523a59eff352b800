// A shorter or former path of robot/forces/contact_account.hpp: the accounts of contacts.
#pragma once

#include <cca/sim/robot/forces/contact_account.hpp>
