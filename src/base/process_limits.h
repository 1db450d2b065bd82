// What this process may use of the machine: its CPU affinity, and the limits of its control groups (cgroups
// of both versions), which hold for all that runs in a container or a batch job.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace macula {

// Processors that the scheduler lets this process have, at least 1: those of its affinity, or the share of a
// cgroup, rounded up, if that is less. `root` is where /proc and /sys are looked for.
std::size_t usableProcessors(const std::filesystem::path& root = "/");

// Bytes that the process can still get without swapping: MemAvailable of /proc/meminfo, or what the nearest
// limit of its cgroups leaves, file cache counted as free, if that is less. Nothing when neither is known.
std::optional<std::uint64_t> availableMemoryBytes(const std::filesystem::path& root = "/");

}  // namespace macula
