// Tests a connection step by step, for a person who sets it up.
#pragma once

#include <vector>

#include "net/archive/archive.h"
#include "net/dimse/connector.h"

namespace macula::net {

std::vector<TestStep> testConnection(const Connector& connector, Progress& progress);

}  // namespace macula::net
