// Tickets: when a submission is done.
#pragma once

#include <cstdint>

namespace macula::gpu {

// The value of a submission on the device's timeline: 1, 2, 3, ... Ticket 0 is done from the start.
using Ticket = std::uint64_t;

}  // namespace macula::gpu
