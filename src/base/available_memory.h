// How much memory there is.
#pragma once

#include <cstdint>
#include <optional>

#include "base/result.h"

namespace macula {

// The bytes that this process can still get without swapping: see base/process_limits.h.
std::optional<std::uint64_t> availableMemory();

// Names both amounts, so that a person can distinguish a series that is too large from a damaged header.
Error notEnoughMemory(std::uint64_t bytesNeeded, std::optional<std::uint64_t> bytesAvailable);

}  // namespace macula
