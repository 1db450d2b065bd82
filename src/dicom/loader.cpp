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
std::uint64_t bytesOf(const Stack& stack) {
    return std::uint64_t{sizeof(std::uint16_t)} * static_cast<std::uint64_t>(stack.columns) *
           static_cast<std::uint64_t>(stack.rows) * stack.frames.size();
}

// HU only where the CT Image Module makes it so (PS3.3 C.11.1.1.2: RescaleType absent means HU in an original
// CT image).
Unit unitOf(const Series& series, const Stack& stack) {
    const auto notHu = [](const Frame& f) { return !f.rescaleType.empty() && f.rescaleType != "HU"; };
    const bool other = std::any_of(stack.frames.begin(), stack.frames.end(), notHu);
    return series.modality == "CT" && !other ? Unit::hounsfield : Unit::raw;
}

}  // namespace

Result<std::shared_ptr<const Volume>> loadVolume(const Series& series, const Stack& stack,
                                                 Progress& progress) try {
    if (const Message* reason = stack.whyNoVolume()) {
        return Error{ErrorCode::inputNotUsable, reason->sentence, {}, reason->action};
    }
    if (!stack.isEven()) {
        return Error{ErrorCode::inputNotUsable, "This series is no volume.", {}, "Choose another series."};
    }
    constexpr int kMostRows = 65535;  // a header may use another VR than US, and then say anything
    if (std::min(stack.columns, stack.rows) < 1 || std::max(stack.columns, stack.rows) > kMostRows) {
        return Error{ErrorCode::inputNotUsable,
                     "The images of this series have no usable size.",
                     {},
                     "Choose another series."};
    }
    const std::size_t count = stack.frames.size();
    const std::size_t sliceVoxels =
        static_cast<std::size_t>(stack.columns) * static_cast<std::size_t>(stack.rows);
    const std::uint64_t bytesNeeded = bytesOf(stack);
    if (const auto available = availableMemory(); available && bytesNeeded > *available) {
        return notEnoughMemory(bytesNeeded, *available);
    }

    std::vector<SliceIntensity> intensities;
    for (const Frame& frame : stack.frames) intensities.push_back(sliceIntensity(frame));
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
            const Instance& instance = *stack.frames[k].instance;
            auto reader = PixelReader::open(instance.file, {.transferSyntaxUid = instance.transferSyntaxUid,
                                                            .columns = stack.columns,
                                                            .rows = stack.rows,
                                                            .frames = instance.frames,
                                                            .format = intensities[k].format});
            const Result<void> decoded =
                reader ? reader->read(stack.frames[k].number, slice(k)) : reader.error();
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

    VolumeOptions options{.size = {stack.columns, stack.rows, static_cast<int>(count)},
                          .worldFromVoxel = *stack.worldFromVoxel,
                          .unitsFromStored = plan.unitsFromStored,
                          .unit = unitOf(series, stack),
                          .modality = series.modality,
                          .padding = plan.padding,
                          .provenance = {.studyInstanceUid = series.studyInstanceUid,
                                         .seriesInstanceUid = series.seriesInstanceUid,
                                         .description = series.description,
                                         .assumptions = series.assumptions}};
    auto& assumptions = options.provenance.assumptions;
    assumptions.insert(assumptions.end(), stack.assumptions.begin(), stack.assumptions.end());
    if (paddingAssumed) assumptions.push_back(*paddingAssumed);
    MACULA_TRY(Volume volume, plan.format == VoxelFormat::stored16
                                  ? Volume::create(std::move(options), std::move(voxels))
                                  : Volume::createFloat(std::move(options), std::move(values)));
    return std::shared_ptr<const Volume>(std::make_shared<Volume>(std::move(volume)));
} catch (const std::bad_alloc&) {
    return notEnoughMemory(bytesOf(stack), availableMemory());
} catch (const std::exception&) {
    return Error{ErrorCode::inputNotUsable, "This series cannot be loaded.", {}, "Choose another series."};
}

}  // namespace macula::dicom
