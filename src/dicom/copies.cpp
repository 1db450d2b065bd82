#include "dicom/copies.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "base/atomic_file.h"
#include "base/parallel.h"
#include "base/sha256.h"

namespace macula::dicom {

namespace {

struct Twin {
    const Instance* instance = nullptr;
    std::string digest;  // empty when the file cannot be read
};

// Those that share UID and size with another of their series.
std::vector<Twin> findTwins(const std::vector<Series*>& all, Progress& progress) {
    std::vector<Twin> twins;
    for (const Series* series : all) {
        if (progress.cancelled()) return {};
        std::map<std::string_view, std::vector<const Instance*>> byUid;
        for (const Instance& instance : series->instances) {
            if (!instance.sopInstanceUid.empty()) byUid[instance.sopInstanceUid].push_back(&instance);
        }
        for (const auto& [uid, sharing] : byUid) {
            if (sharing.size() < 2) continue;
            std::map<std::uintmax_t, std::vector<const Instance*>> bySize;
            for (const Instance* instance : sharing) {
                std::error_code error;
                const std::uintmax_t size = std::filesystem::file_size(instance->file, error);
                if (!error) bySize[size].push_back(instance);
            }
            for (const auto& [size, equal] : bySize) {
                if (equal.size() < 2) continue;
                for (const Instance* instance : equal) twins.push_back({instance, {}});
            }
        }
    }
    return twins;
}

}  // namespace

void dropCopies(const std::vector<Series*>& all, Progress& progress) {
    std::vector<Twin> twins = findTwins(all, progress);
    if (twins.empty()) return;
    progress.beginStage(fmt::format("Comparing {} files", twins.size()), twins.size());
    parallelFor(
        twins.size(),
        [&](std::size_t i) {
            constexpr std::size_t kLargest = std::size_t{1} << 31;
            try {
                if (const auto bytes = readText(twins[i].instance->file, kLargest))
                    twins[i].digest = sha256Hex(*bytes);
            } catch (const std::bad_alloc&) {
                twins[i].digest.clear();  // not compared, so kept
            }
            progress.advance();
        },
        progress.token());
    if (progress.cancelled()) return;

    std::map<const Instance*, std::string> digests;
    for (Twin& twin : twins) digests.emplace(twin.instance, std::move(twin.digest));
    for (Series* series : all) {
        std::set<std::pair<std::string, std::string>> kept;  // UID, digest
        std::vector<Instance> unique;
        unique.reserve(series->instances.size());
        for (Instance& instance : series->instances) {
            const auto digest = digests.find(&instance);
            const bool known = digest != digests.end() && !digest->second.empty();
            if (known && !kept.insert({instance.sopInstanceUid, digest->second}).second) continue;
            unique.push_back(std::move(instance));
        }
        if (const std::size_t dropped = series->instances.size() - unique.size(); dropped > 0) {
            series->messages.push_back(
                {Severity::info, std::string(key::kDuplicateFiles),
                 fmt::format("{} {} of a file that is there already, and left out.", dropped,
                             dropped == 1 ? "file is a copy" : "files are copies"),
                 "Nothing to do."});
        }
        series->instances = std::move(unique);
    }
}

}  // namespace macula::dicom
