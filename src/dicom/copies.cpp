#include "dicom/copies.h"

#include <fmt/format.h>

#include <map>
#include <set>
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
std::vector<Twin> findTwins(const std::vector<std::vector<Frame>*>& all, Progress& progress) {
    std::vector<Twin> twins;
    for (const std::vector<Frame>* frames : all) {
        if (progress.cancelled()) return {};
        std::map<std::string_view, std::set<const Instance*>> byUid;
        for (const Frame& frame : *frames) {
            if (!frame.instance->sopInstanceUid.empty()) {
                byUid[frame.instance->sopInstanceUid].insert(frame.instance.get());
            }
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

std::vector<std::size_t> dropCopies(const std::vector<std::vector<Frame>*>& all, Progress& progress) {
    std::vector<std::size_t> dropped(all.size(), 0);
    std::vector<Twin> twins = findTwins(all, progress);
    if (twins.empty()) return dropped;
    progress.beginStage(fmt::format("Comparing {} files", twins.size()), twins.size());
    parallelFor(
        twins.size(),
        [&](std::size_t i) {
            constexpr std::size_t kLargest = std::size_t{1}
                                             << 28;  // larger ones are kept, and told of as duplicates
            try {
                if (const auto bytes = readText(twins[i].instance->file, kLargest))
                    twins[i].digest = sha256Hex(*bytes);
            } catch (const std::bad_alloc&) {
                twins[i].digest.clear();  // not compared, so kept
            }
            progress.advance();
        },
        progress.token());
    if (progress.cancelled()) return dropped;

    std::map<const Instance*, std::string> digests;
    for (Twin& twin : twins) digests.emplace(twin.instance, std::move(twin.digest));
    for (std::size_t s = 0; s < all.size(); ++s) {
        std::map<std::pair<std::string, std::string>, const Instance*> kept;  // by UID and digest
        std::set<const Instance*> gone;
        std::vector<Frame> unique;
        unique.reserve(all[s]->size());
        for (Frame& frame : *all[s]) {
            const auto digest = digests.find(frame.instance.get());
            if (digest != digests.end() && !digest->second.empty()) {
                const auto [first, isNew] = kept.emplace(
                    std::pair(frame.instance->sopInstanceUid, digest->second), frame.instance.get());
                if (first->second != frame.instance.get()) {
                    gone.insert(frame.instance.get());
                    continue;
                }
            }
            unique.push_back(std::move(frame));
        }
        dropped[s] = gone.size();
        *all[s] = std::move(unique);
    }
    return dropped;
}

}  // namespace macula::dicom
