#include "dicom/loader.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <tuple>

#include "base/parallel.h"
#include "dicom/memory.h"
#include "dicom/pixels.h"

namespace macula::dicom {

namespace {

// Rows and columns have 16 bits, so this fits.
std::uint64_t bytesOf(const Series& series) {
    return std::uint64_t{sizeof(std::uint16_t)} * static_cast<std::uint64_t>(series.columns) *
           static_cast<std::uint64_t>(series.rows) * series.instances.size();
}

// HU only where the CT Image Module makes it so (PS3.3 C.11.1.1.2: RescaleType absent means HU in an original
// CT image).
Unit unitOf(const Series& series) {
    const auto notHu = [](const Instance& i) { return !i.rescaleType.empty() && i.rescaleType != "HU"; };
    const bool other = std::any_of(series.instances.begin(), series.instances.end(), notHu);
    return series.modality == "CT" && !other ? Unit::hounsfield : Unit::raw;
}

}  // namespace

Result<std::shared_ptr<const Volume>> loadVolume(const Series& series, Progress& progress) try {
    if (const Message* reason = series.whyNoVolume()) {
        return Error{ErrorCode::inputNotUsable, reason->sentence, {}, reason->action};
    }
    if (!series.canBeVolume()) {
        return Error{ErrorCode::inputNotUsable, "This series is no volume.", {}, "Choose another series."};
    }
    constexpr int kMostRows = 65535;  // a header may use another VR than US, and then say anything
    if (std::min(series.columns, series.rows) < 1 || std::max(series.columns, series.rows) > kMostRows) {
        return Error{ErrorCode::inputNotUsable,
                     "The images of this series have no usable size.",
                     {},
                     "Choose another series."};
    }
    const std::size_t count = series.instances.size();
    const std::size_t sliceVoxels =
        static_cast<std::size_t>(series.columns) * static_cast<std::size_t>(series.rows);
    const std::uint64_t bytesNeeded = bytesOf(series);
    if (const auto available = availableMemory(); available && bytesNeeded > *available) {
        return notEnoughMemory(bytesNeeded, *available);
    }

    std::vector<SliceIntensity> intensities;
    for (const Instance& instance : series.instances) intensities.push_back(sliceIntensity(instance));
    if (!std::ranges::all_of(intensities, isNarrow, &SliceIntensity::format)) {
        return Error{ErrorCode::inputNotUsable,
                     "The pixels of this series are wider than 16 bits.",
                     {},
                     "Choose another series."};
    }
    const std::optional<std::string> paddingAssumed = completePadding(intensities);
    const std::optional<IntensityPlan> early = planFromFormats(intensities);

    progress.beginStage(fmt::format("Decoding {} slices", count), count);
    std::vector<std::uint16_t> voxels(sliceVoxels * count);
    const auto slice = [&](std::size_t k) { return std::span(voxels).subspan(k * sliceVoxels, sliceVoxels); };
    std::vector<StoredRange> ranges(count);
    std::atomic<bool> failed{false};
    std::mutex mutex;
    std::optional<Error> failure;
    std::size_t failedSlice = count;
    parallelFor(
        count,
        [&](std::size_t k) {
            if (failed) return;
            const Result<void> decoded = decodeCells(series.instances[k], slice(k));
            if (!decoded) {
                const std::lock_guard lock(mutex);
                failed = true;
                if (k < failedSlice) {
                    failedSlice = k;
                    failure = decoded.error();
                }
                return;
            }
            unpackCells(intensities[k].format, intensities[k].padding, slice(k));
            if (!early) ranges[k] = unpackedRange(intensities[k], slice(k));
            progress.advance();
        },
        progress.token());
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "Loading was cancelled.", {}, {}};
    if (failure) {
        failure->message = fmt::format("Slice {} of {}: {}", failedSlice + 1, count, failure->message);
        return *failure;
    }
    const IntensityPlan plan = early ? *early : planFromRanges(intensities, ranges);
    std::vector<float> values(plan.format == VoxelFormat::float32 ? voxels.size() : 0);
    parallelFor(
        count,
        [&](std::size_t k) {
            if (plan.format == VoxelFormat::stored16) return applyMap(plan.slices[k], slice(k));
            applyIntensity(intensities[k], slice(k), std::span(values).subspan(k * sliceVoxels, sliceVoxels));
        },
        progress.token());
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "Loading was cancelled.", {}, {}};

    VolumeOptions options{.size = {series.columns, series.rows, static_cast<int>(count)},
                          .worldFromVoxel = *series.worldFromVoxel,
                          .unitsFromStored = plan.unitsFromStored,
                          .unit = unitOf(series),
                          .modality = series.modality,
                          .padding = plan.padding,
                          .provenance = {.studyInstanceUid = series.studyInstanceUid,
                                         .seriesInstanceUid = series.seriesInstanceUid,
                                         .description = series.description,
                                         .assumptions = series.assumptions}};
    auto& assumptions = options.provenance.assumptions;
    if (paddingAssumed) assumptions.push_back(*paddingAssumed);
    MACULA_TRY(Volume volume, plan.format == VoxelFormat::stored16
                                  ? Volume::create(std::move(options), std::move(voxels))
                                  : Volume::createFloat(std::move(options), std::move(values)));
    return std::shared_ptr<const Volume>(std::make_shared<Volume>(std::move(volume)));
} catch (const std::bad_alloc&) {
    return notEnoughMemory(bytesOf(series), availableMemory());
} catch (const std::exception&) {
    return Error{ErrorCode::inputNotUsable, "This series cannot be loaded.", {}, "Choose another series."};
}

const Series* bestSeries(const Scan& scan, std::string* why) {
    constexpr std::size_t kFewSlices =
        20;  // an original of fewer is a scout or a sample rather than the study
    const auto rank = [](const Series& s) {
        return std::tuple(!isLocalizer(s), isOriginalPrimary(s) && s.instances.size() >= kFewSlices,
                          std::size_t(s.columns) * std::size_t(s.rows) * s.instances.size());
    };
    const Series* best = nullptr;
    const Series* blocked = nullptr;
    std::size_t count = 0;
    for (const Study& study : scan.studies) {
        for (const Series& series : study.series) {
            ++count;
            if (!series.canBeVolume()) {
                if (blocked == nullptr || series.instances.size() > blocked->instances.size())
                    blocked = &series;
            } else if (best == nullptr || rank(series) > rank(*best)) {
                best = &series;
            }
        }
    }
    if (why == nullptr) return best;
    const std::string ofPatients =
        scan.patients > 1 ? fmt::format(" of {} patients in this folder", scan.patients) : std::string();
    if (best != nullptr) {
        *why = count == 1 ? std::string("The only series.")
                          : fmt::format("The {}series with the most voxels ({} x {} x {}), of {} series{}.",
                                        isOriginalPrimary(*best) ? "original " : "", best->columns,
                                        best->rows, best->instances.size(), count, ofPatients);
    } else if (blocked != nullptr) {
        const Message* reason = blocked->whyNoVolume();
        *why = fmt::format("None of the {} series{} can be shown in 3D. The largest: {}", count, ofPatients,
                           reason != nullptr ? reason->sentence : "it is no volume.");
    } else {
        *why = "There is no image series.";
    }
    return best;
}

}  // namespace macula::dicom
