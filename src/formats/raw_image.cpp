#include "formats/raw_image.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <mutex>

#include "base/available_memory.h"
#include "base/parallel.h"

namespace macula::formats {

namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;
constexpr double kMost16 = 65535.0;
constexpr double kMostExact = 9007199254740992.0;  // 2^53: a double cannot hold the next whole number

struct Scalar {
    std::string_view name;
    std::size_t bytes;
};
// In the order of ScalarType.
constexpr std::array<Scalar, 10> kScalars{{{"int8", 1},
                                           {"uint8", 1},
                                           {"int16", 2},
                                           {"uint16", 2},
                                           {"int32", 4},
                                           {"uint32", 4},
                                           {"int64", 8},
                                           {"uint64", 8},
                                           {"float32", 4},
                                           {"float64", 8}}};

// The names of units in valueNote().
constexpr std::array<std::pair<Unit, std::string_view>, 3> kUnitNames{
    {{Unit::hounsfield, "HU"}, {Unit::becquerelsPerMillilitre, "Bq/mL"}, {Unit::suvBodyWeight, "SUVbw"}}};
constexpr std::string_view kNoteBegin = "Macula";
constexpr std::string_view kNoteUncalibrated = "uncalibrated";

Error cancelled() {
    return {ErrorCode::cancelled, Text("Stopped."), {}, {}};
}

// Calls body(first, count) for portions of [0, count), on all cores, and reports progress.
Result<void> inChunks(std::size_t count, Progress& progress,
                      const std::function<void(std::size_t, std::size_t)>& body) {
    parallelFor((count + kChunk - 1) / kChunk,
                [&](std::size_t chunk) {
                    const std::size_t first = chunk * kChunk;
                    body(first, std::min(kChunk, count - first));
                    progress.advance();
                },
                progress.token());
    if (progress.cancelled()) return cancelled();
    return {};
}

struct Summary {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    bool whole = true;  // every value is a finite whole number

    void add(double value) {
        if (!(std::isfinite(value) && value == std::trunc(value))) whole = false;
        low = std::min(low, value);  // a NaN changes neither
        high = std::max(high, value);
    }
    void add(const Summary& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
        whole = whole && other.whole;
    }
    bool wholeWithin(double least, double most) const { return whole && low >= least && high <= most; }
};

// The summary of valueAt(0) to valueAt(count - 1).
template <class ValueAt>
Result<Summary> summarise(std::size_t count, Progress& progress, const ValueAt& valueAt) {
    std::mutex mutex;
    Summary all;
    MACULA_TRY_VOID(inChunks(count, progress, [&](std::size_t first, std::size_t length) {
        Summary local;
        for (std::size_t n = first; n < first + length; ++n) local.add(valueAt(n));
        const std::lock_guard lock(mutex);
        all.add(local);
    }));
    return all;
}

template <class T>
T converted(double value) {
    if constexpr (std::is_same_v<T, float>) {  // a conversion beyond its range is undefined in C++
        constexpr double kMost = std::numeric_limits<float>::max();
        if (std::abs(value) > kMost)
            return std::copysign(std::numeric_limits<float>::infinity(), float(value > 0 ? 1 : -1));
    }
    return static_cast<T>(value);
}

template <class T>
T at(const std::byte* data, std::size_t n) {
    T value;
    std::memcpy(&value, data + n * sizeof(T), sizeof(T));
    return value;
}

// Calls `use` with a function that returns the n-th raw value as a double, which is exact for all types
// except for whole numbers beyond 2^53.
template <class Use>
auto withRaw(const RawImage& image, const Use& use) {
    const std::byte* data = image.data.data();
    switch (image.type) {
        case ScalarType::int8:
            return use([data](std::size_t n) { return double(at<std::int8_t>(data, n)); });
        case ScalarType::uint8:
            return use([data](std::size_t n) { return double(at<std::uint8_t>(data, n)); });
        case ScalarType::int16:
            return use([data](std::size_t n) { return double(at<std::int16_t>(data, n)); });
        case ScalarType::uint16:
            return use([data](std::size_t n) { return double(at<std::uint16_t>(data, n)); });
        case ScalarType::int32:
            return use([data](std::size_t n) { return double(at<std::int32_t>(data, n)); });
        case ScalarType::uint32:
            return use([data](std::size_t n) { return double(at<std::uint32_t>(data, n)); });
        case ScalarType::int64:
            return use([data](std::size_t n) { return double(at<std::int64_t>(data, n)); });
        case ScalarType::uint64:
            return use([data](std::size_t n) { return double(at<std::uint64_t>(data, n)); });
        case ScalarType::float32:
            return use([data](std::size_t n) { return double(at<float>(data, n)); });
        case ScalarType::float64:
            break;
    }
    return use([data](std::size_t n) { return at<double>(data, n); });
}

template <class ValueAt>
Result<RawImage> packed(RawImage image, std::size_t count, Progress& progress, const ValueAt& valueAt) {
    progress.beginStage(Text("Preparing the values"), 2 * ((count + kChunk - 1) / kChunk));
    MACULA_TRY(const Summary values, summarise(count, progress, valueAt));
    const auto fill = [&]<class T>(T) {
        image.data.resize(count * sizeof(T));
        std::byte* out = image.data.data();
        return inChunks(count, progress, [&, out](std::size_t first, std::size_t length) {
            for (std::size_t n = first; n < first + length; ++n) {
                const T value = converted<T>(valueAt(n));
                std::memcpy(out + n * sizeof(T), &value, sizeof(T));
            }
        });
    };
    if (values.wholeWithin(-32768.0, 32767.0)) {
        image.type = ScalarType::int16;
        MACULA_TRY_VOID(fill(std::int16_t{}));
    } else if (values.wholeWithin(0.0, kMost16)) {
        image.type = ScalarType::uint16;
        MACULA_TRY_VOID(fill(std::uint16_t{}));
    } else {
        image.type = ScalarType::float32;
        MACULA_TRY_VOID(fill(float{}));
    }
    return image;
}

template <class RawAt>
Result<std::shared_ptr<const Volume>> unpacked(RawImage& image, Progress& progress, const RawAt& raw) {
    const std::size_t count = image.data.size() / bytesOf(image.type);
    progress.beginStage(Text("Preparing the values"), 2 * ((count + kChunk - 1) / kChunk));
    MACULA_TRY(const Summary values, summarise(count, progress, raw));
    VolumeOptions options{.size = image.size,
                          .worldFromVoxel = image.worldFromVoxel,
                          .unit = image.unit,
                          .modality = image.modality};
    options.provenance.isCalibrated = image.isCalibrated;
    const double slope = image.slope;
    const double intercept = image.intercept;
    const bool hasManyBits = image.type == ScalarType::int64 || image.type == ScalarType::uint64;
    if (hasManyBits && std::max(std::abs(values.low), std::abs(values.high)) >= kMostExact)
        image.assumptions.emplace_back(Text("Whole numbers beyond 2^53 were rounded."));

    if (values.whole && values.high - values.low <= kMost16) {
        // A Volume needs a positive slope, so a negative one reverses the order of the stored values.
        const bool shifted = slope < 0.0 || values.low < 0.0 || values.high > kMost16;
        const double sign = slope < 0.0 ? -1.0 : 1.0;
        const double origin = !shifted ? 0.0 : slope < 0.0 ? values.high : values.low;
        options.unitsFromStored = {std::abs(slope), slope * origin + intercept};
        options.provenance.assumptions = std::move(image.assumptions);
        std::vector<std::uint16_t> voxels(count);
        MACULA_TRY_VOID(inChunks(count, progress, [&](std::size_t first, std::size_t length) {
            for (std::size_t n = first; n < first + length; ++n)
                voxels[n] = static_cast<std::uint16_t>(sign * (raw(n) - origin));
        }));
        image.data = {};
        MACULA_TRY(Volume volume, Volume::create(std::move(options), std::move(voxels)));
        return std::shared_ptr<const Volume>(std::make_shared<Volume>(std::move(volume)));
    }

    std::vector<float> voxels(count);
    std::atomic<bool> rounded{false};
    std::atomic<std::size_t> notFinite{0};
    MACULA_TRY_VOID(inChunks(count, progress, [&](std::size_t first, std::size_t length) {
        bool inexact = false;
        std::size_t none = 0;
        for (std::size_t n = first; n < first + length; ++n) {
            const double value = slope * raw(n) + intercept;
            voxels[n] = converted<float>(value);
            none += std::isfinite(voxels[n]) ? 0 : 1;
            inexact = inexact || (std::isfinite(voxels[n]) && double(voxels[n]) != value);
        }
        notFinite += none;
        if (inexact) rounded = true;
    }));
    if (rounded) image.assumptions.emplace_back(Text("Values were rounded to 24 significant bits."));
    if (notFinite > 0) {
        image.assumptions.push_back(Text(
            "{} voxels hold no finite number: they are treated as outside of the scan.", notFinite.load()));
    }
    options.provenance.assumptions = std::move(image.assumptions);
    image.data = {};
    MACULA_TRY(Volume volume, Volume::createFloat(std::move(options), std::move(voxels)));
    return std::shared_ptr<const Volume>(std::make_shared<Volume>(std::move(volume)));
}

}  // namespace

std::size_t bytesOf(ScalarType type) {
    return kScalars.at(static_cast<std::size_t>(type)).bytes;
}

std::string_view nameOf(ScalarType type) {
    return kScalars.at(static_cast<std::size_t>(type)).name;
}

std::string valueNote(const RawImageLayout& layout) {
    const auto known = std::ranges::find(kUnitNames, layout.unit, &decltype(kUnitNames)::value_type::first);
    const bool hasUnit = known != kUnitNames.end();
    if (!hasUnit && layout.isCalibrated) return {};
    // A modality is a code of capitals (PS3.5 6.2, CS); any other text is left out.
    const bool isCode = layout.modality.size() <= 16 &&
                        layout.modality.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos;
    std::string note = fmt::format("{}|{}|{}|{}", kNoteBegin, nameOf(layout.type),
                                   hasUnit ? known->second : std::string_view(),
                                   isCode && hasUnit ? layout.modality : std::string());
    if (!layout.isCalibrated) note += fmt::format("|{}", kNoteUncalibrated);
    return note;
}

void readValueNote(std::string_view note, RawImageLayout& layout) {
    std::vector<std::string> parts{""};
    for (const char c : note) {
        if (c == '|') {
            parts.emplace_back();
        } else if (c >= ' ' && c <= '~') {
            parts.back() += c;
        }
    }
    // Holds even if another program changed the values: none calibrates lengths.
    if (parts.size() == 5 && parts[0] == kNoteBegin && parts[4] == kNoteUncalibrated) {
        layout.isCalibrated = false;
        layout.assumptions.emplace_back(
            Text("The size of a voxel is not calibrated: lengths, areas and volumes are estimates."));
        parts.pop_back();
    }
    const bool isChanged = layout.slope != 1.0 || layout.intercept != 0.0;
    if (parts.size() != 4 || parts[0] != kNoteBegin || parts[1] != nameOf(layout.type) || isChanged) return;
    for (const auto& [unit, name] : kUnitNames) {
        if (name != parts[2]) continue;
        layout.unit = unit;
        layout.modality = parts[3];
    }
}

std::uint64_t RawImageLayout::bytes() const {
    return std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z) * bytesOf(type);
}

Error notWritten() {
    return {ErrorCode::outputNotWritable,
            Text("The file could not be written."),
            {},
            Text("Check free space and permissions.")};
}

Result<void> chooseVolume(RawImageLayout& layout, std::size_t volume) {
    if (volume < 1 || volume > layout.volumes) {
        return Error{ErrorCode::usage,
                     layout.volumes == 1
                         ? Text("The file is one volume; there is nothing to choose from.")
                         : Text("The file holds {} volumes, one for each point in time.", layout.volumes),
                     {},
                     layout.volumes == 1 ? Text("Leave --series and --volume out.")
                                         : Text("Choose one of them with --volume.")};
    }
    if (layout.volumes > 1 && (layout.axis.unit.empty() || layout.axis.isOfTimes())) {
        layout.assumptions.push_back(
            Text("The file holds {} volumes, one for each point in time; this is number {}.", layout.volumes,
                 volume));
    } else if (layout.volumes > 1) {
        layout.assumptions.push_back(
            Text("The file holds {} volumes along an axis in {}, which is no time; this is number {}.",
                 layout.volumes, layout.axis.unit, volume));
    }
    return {};
}

Result<void> checkLayout(const RawImageLayout& layout, std::uint64_t bytesInFile, bool compressed) {
    constexpr int kMostPerSide = 65536;       // as in Volume; three of them and 8 bytes fit 64 bits
    constexpr std::uint64_t kDeflate = 1032;  // at best, a match of 258 bytes takes 2 bits
    const glm::ivec3 size = layout.size;
    if (std::min({size.x, size.y, size.z}) < 2) {
        return Error{ErrorCode::inputNotUsable,
                     Text("The image of {} x {} x {} voxels is no volume.", size.x, size.y, size.z),
                     {},
                     Text("Choose a file with a volume.")};
    }
    if (std::max({size.x, size.y, size.z}) > kMostPerSide) {
        return Error{ErrorCode::inputNotUsable,
                     Text("A volume of {} x {} x {} voxels cannot be shown.", size.x, size.y, size.z),
                     {},
                     Text("Choose a smaller one.")};
    }
    const std::uint64_t needed = layout.bytes();
    if (needed > (compressed ? kDeflate * bytesInFile : bytesInFile)) {
        return Error{ErrorCode::inputNotUsable,
                     Text("The file is cut off: its header tells of {} x {} x {} voxels, and it is "
                          "too short for them.",
                          size.x, size.y, size.z),
                     {},
                     Text("Get the file again from where it came.")};
    }
    const std::uint64_t voxels = needed / bytesOf(layout.type);
    const std::uint64_t all = needed + voxels * sizeof(float);  // the volume is float32 at worst
    if (const auto available = availableMemory(); available && all > *available)
        return notEnoughMemory(all, *available);
    return {};
}

Result<RawImage> rawImageOf(const Volume& volume, Progress& progress) {
    RawImage image;
    image.size = volume.size();
    image.worldFromVoxel = volume.worldFromVoxel();
    image.unit = volume.unit();
    image.modality = volume.modality();
    image.isCalibrated = volume.provenance().isCalibrated;
    if (volume.format() == VoxelFormat::float32) {
        const auto voxels = volume.floatVoxels();
        return packed(std::move(image), voxels.size(), progress,
                      [voxels](std::size_t n) { return double(voxels[n]); });
    }
    const auto voxels = volume.voxels();
    const UnitsFromStored units = volume.unitsFromStored();
    return packed(std::move(image), voxels.size(), progress,
                  [voxels, units](std::size_t n) { return units(voxels[n]); });
}

Result<RawImage> rawImageOf(const LabelMap& map, Progress& progress) {
    RawImage image;
    image.size = map.size();
    image.worldFromVoxel = map.worldFromVoxel();
    const auto labels = map.labels();
    return packed(std::move(image), labels.size(), progress,
                  [labels](std::size_t n) { return double(labels[n]); });
}

Result<std::shared_ptr<const Volume>> volumeOf(RawImage image, Progress& progress) {
    if (!(std::isfinite(image.slope) && image.slope != 0.0 && std::isfinite(image.intercept))) {
        return Error{ErrorCode::inputNotUsable,
                     Text("The map from stored values to units is not usable."),
                     {},
                     Text("Export the file again.")};
    }
    MACULA_CHECK(image.data.size() == image.bytes());
    return withRaw(image, [&](const auto& raw) { return unpacked(image, progress, raw); });
}

}  // namespace macula::formats
