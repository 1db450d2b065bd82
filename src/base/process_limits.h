// How much of the machine this process may use: its CPU affinity, and the limits of its control groups
// (cgroups v1 and v2), as a container or a batch job sets them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace macula {

// The number of processors that this process may use, at least 1: those of its affinity, or the CPU quota of
// a cgroup, rounded up, if that is less. `root` is the folder in which to find /proc and /sys.
std::size_t usableProcessors(const std::filesystem::path& root = "/");

// Bytes that the process can still get without swapping: MemAvailable of /proc/meminfo, or what the tightest
// limit of its cgroups leaves, if that is less; file cache counts as free. Nothing when neither is known.
std::optional<std::uint64_t> availableMemoryBytes(const std::filesystem::path& root = "/");

}  // namespace macula
