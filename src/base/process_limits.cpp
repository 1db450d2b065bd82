#include "base/process_limits.h"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <thread>

namespace macula {

namespace fs = std::filesystem;

namespace {

using Bytes = std::optional<std::uint64_t>;

// The first number of a file; nothing when it begins with a word ("max") or a minus.
Bytes numberIn(const fs::path& file) {
    std::ifstream stream(file);
    std::string word;
    if (!(stream >> word) || word.find_first_not_of("0123456789") != std::string::npos) return {};
    try {
        return std::stoull(word);
    } catch (const std::out_of_range&) {
        return {};
    }
}

// The number after `name`, in a file with a name and a number on each line.
Bytes namedNumberIn(const fs::path& file, std::string_view name) {
    std::ifstream stream(file);
    std::string word;
    std::uint64_t number = 0;
    std::string rest;
    while (stream >> word >> number && std::getline(stream, rest)) {
        if (word == name) return number;
    }
    return {};
}

// Calls `use` with the folder of each cgroup of this process that has `controller`, and with its parents.
void forEachGroup(const fs::path& root, const std::string& controller,
                  const std::function<void(const fs::path& folder, bool isVersion2)>& use) {
    std::ifstream groups(root / "proc/self/cgroup");
    std::string line;  // "4:memory:/path", or "0::/path" for version 2
    while (std::getline(groups, line)) {
        const std::size_t first = line.find(':');
        const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
        const bool isVersion2 = controllers == ",,";
        if (!isVersion2 && controllers.find("," + controller + ",") == std::string::npos) continue;
        const fs::path base = root / "sys/fs/cgroup" / (isVersion2 ? "" : controller);
        fs::path below = fs::path(line.substr(second + 1)).relative_path();
        for (;; below = below.parent_path()) {
            use(below.empty() ? base : base / below, isVersion2);
            if (below.empty()) break;
        }
    }
}

Bytes leftInGroup(const fs::path& folder, bool isVersion2) {
    const Bytes limit = numberIn(folder / (isVersion2 ? "memory.max" : "memory.limit_in_bytes"));
    const Bytes used = numberIn(folder / (isVersion2 ? "memory.current" : "memory.usage_in_bytes"));
    if (!limit || !used) return {};
    // The file cache counts as free: the kernel drops it when memory is needed.
    const std::uint64_t cache =
        namedNumberIn(folder / "memory.stat", isVersion2 ? "inactive_file" : "total_inactive_file")
            .value_or(0);
    const std::uint64_t held = *used - std::min(*used, cache);
    return *limit - std::min(*limit, held);
}

// The CPU quota in processors; nothing without a limit.
std::optional<double> shareOfGroup(const fs::path& folder, bool isVersion2) {
    if (isVersion2) {
        std::ifstream stream(folder / "cpu.max");  // "200000 100000", or "max 100000"
        double quota = 0.0;
        double period = 0.0;
        if (stream >> quota >> period && quota > 0.0 && period > 0.0) return quota / period;
        return {};
    }
    const Bytes quota = numberIn(folder / "cpu.cfs_quota_us");  // -1: none
    const Bytes period = numberIn(folder / "cpu.cfs_period_us");
    if (!quota || !period || *quota == 0 || *period == 0) return {};
    return static_cast<double>(*quota) / static_cast<double>(*period);
}

std::size_t processorsOfAffinity() {
    constexpr int kMostProcessors = 16384;
    for (int processors = CPU_SETSIZE; processors <= kMostProcessors; processors *= 2) {
        cpu_set_t* const set = CPU_ALLOC(processors);
        if (set == nullptr) break;
        const std::size_t bytes = CPU_ALLOC_SIZE(processors);
        const bool known = sched_getaffinity(0, bytes, set) == 0;
        const int count = known ? CPU_COUNT_S(bytes, set) : 0;
        CPU_FREE(set);
        if (count > 0) return static_cast<std::size_t>(count);
    }
    return std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace

std::size_t usableProcessors(const fs::path& root) {
    std::size_t count = processorsOfAffinity();
    forEachGroup(root, "cpu", [&](const fs::path& folder, bool isVersion2) {
        if (const auto share = shareOfGroup(folder, isVersion2))
            count = std::min(count, static_cast<std::size_t>(std::max(1.0, std::ceil(*share))));
    });
    return count;
}

Bytes availableMemoryBytes(const fs::path& root) {
    Bytes least;
    if (const Bytes kibibytes = namedNumberIn(root / "proc/meminfo", "MemAvailable:"))
        least = *kibibytes * 1024;
    forEachGroup(root, "memory", [&](const fs::path& folder, bool isVersion2) {
        if (const Bytes left = leftInGroup(folder, isVersion2))
            least = least ? std::min(*least, *left) : *left;
    });
    return least;
}

}  // namespace macula
