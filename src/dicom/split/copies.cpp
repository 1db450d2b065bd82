#include "dicom/split/copies.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <new>
#include <set>
#include <tuple>
#include <utility>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/parallel.h"
#include "base/sha256.h"
#include "dicom/read/random_file.h"
#include "dicom/stack/split_rules.h"

namespace macula::dicom {

namespace {

struct Twin {
    const Instance* instance = nullptr;
    std::string digest;  // empty when the file cannot be read
};

// The files that share UID and size with another of their series.
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

namespace {

// The digest of the pixel data as they are stored; empty when they cannot be read.
std::string pixelDigest(const Frame& frame) {
    constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 28;
    const HeaderFile read = readHeader(frame.instance->file);
    constexpr std::string_view kDeflated =
        "1.2.840.10008.1.2.1.99";  // its offsets refer to the inflated data
    if (!read.pixels || frame.instance->transferSyntaxUid == kDeflated) return {};
    const RandomFile file(frame.instance->file);
    if (!file.isOpen() || file.size() < read.pixels->offset) return {};
    const std::uint64_t present =
        read.pixels->encapsulated ? file.size() - read.pixels->offset : read.pixels->bytesPresent;
    if (present > kMostBytes) return {};
    std::vector<std::byte> bytes(present);
    if (!file.read(read.pixels->offset, bytes)) return {};
    return sha256Hex(bytes);
}

bool mayRepeat(const Frame& a, const Frame& b) {
    const SplitRules& rules = splitRules();
    for (std::size_t i = 0; i < rules.attributes.size(); ++i) {
        const std::string& name = rules.attributes[i].name;
        if (name == "InstanceNumber" || name == "FrameOfReferenceUID") continue;
        if (a.attributes[i] != b.attributes[i]) return false;
    }
    return a.slope == b.slope && a.intercept == b.intercept && a.instance->format == b.instance->format &&
           a.instance->transferSyntaxUid == b.instance->transferSyntaxUid;
}

auto orderOf(const Frame& frame) {
    return std::tuple(frame.instance->instanceNumber.value_or(0),
                      std::string_view(frame.instance->sopInstanceUid));
}

// The frames at each place that several share; none when one of them has no place, or its file has several
// frames.
std::vector<std::vector<std::size_t>> sharedPlaces(const std::vector<Frame>& frames) {
    constexpr double kDirections = 1e-4;
    std::map<std::array<double, 9>, std::vector<std::size_t>> places;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (!frames[f].plane || frames[f].instance->frames != 1) return {};
        const ImagePlane& plane = *frames[f].plane;
        const glm::dvec3 at = glm::round(plane.positionMm / kSamePositionMm);
        const glm::dvec3 row = glm::round(plane.rowDirection / kDirections);
        const glm::dvec3 column = glm::round(plane.columnDirection / kDirections);
        places[{at.x, at.y, at.z, row.x, row.y, row.z, column.x, column.y, column.z}].push_back(f);
    }
    std::vector<std::vector<std::size_t>> shared;
    for (auto& [place, group] : places) {
        if (group.size() < 2) continue;
        std::sort(group.begin(), group.end(),
                  [&](std::size_t a, std::size_t b) { return orderOf(frames[a]) < orderOf(frames[b]); });
        shared.push_back(std::move(group));
    }
    return shared;
}

// The frames that repeat another one, to be left out.
std::set<std::size_t> findRepeats(const std::vector<Frame>& frames, const CancelToken& cancel) {
    const auto shared = sharedPlaces(frames);
    for (const auto& group : shared) {
        for (const std::size_t f : group) {
            if (!mayRepeat(frames[group.front()], frames[f])) return {};
        }
    }
    std::set<std::size_t> repeats;
    for (const auto& group : shared) {
        if (cancel.cancelled()) return {};
        const std::string digest = pixelDigest(frames[group.front()]);
        if (digest.empty()) return {};
        for (std::size_t n = 1; n < group.size(); ++n) {
            if (pixelDigest(frames[group[n]]) != digest) return {};
            repeats.insert(group[n]);
        }
    }
    return repeats;
}

}  // namespace

std::vector<std::size_t> dropRepeats(const std::vector<std::vector<Frame>*>& all, const CancelToken& cancel) {
    std::vector<std::size_t> dropped(all.size(), 0);
    std::vector<std::set<std::size_t>> repeats(all.size());
    parallelFor(
        all.size(), [&](std::size_t s) { repeats[s] = findRepeats(*all[s], cancel); }, cancel);
    for (std::size_t s = 0; s < all.size(); ++s) {
        if (repeats[s].empty()) continue;
        std::vector<Frame> unique;
        for (std::size_t f = 0; f < all[s]->size(); ++f) {
            if (!repeats[s].contains(f)) unique.push_back(std::move((*all[s])[f]));
        }
        dropped[s] = repeats[s].size();
        *all[s] = std::move(unique);
    }
    return dropped;
}

std::vector<std::size_t> dropCopies(const std::vector<std::vector<Frame>*>& all, Progress& progress) {
    std::vector<std::size_t> dropped(all.size(), 0);
    std::vector<Twin> twins = findTwins(all, progress);
    if (twins.empty()) return dropped;
    progress.beginStage(Text("Comparing {} files", twins.size()), twins.size());
    parallelFor(
        twins.size(),
        [&](std::size_t i) {
            constexpr std::size_t kLargest = std::size_t{1}
                                             << 28;  // larger ones are kept, and reported as duplicates
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
