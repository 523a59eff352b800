// A former path of robot/model/contact_account.hpp: the accounts of contacts.
#pragma once

#include <cca/sim/robot/model/contact_account.hpp>
