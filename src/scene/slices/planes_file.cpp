#include "scene/slices/planes_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <system_error>
#include <utility>

#include "base/draft.h"
#include "base/exceptions.h"
#include "dicom/messages/messages.h"
#include "dicom/write/plane_image.h"
#include "dicom/write/uid.h"
#include "study/open/slice_images.h"

namespace macula::scene {

namespace {

namespace fs = std::filesystem;

constexpr double kLevels = 65534.0;  // 0 is padding

// How values become pixels: pixel = (value - intercept) / slope, from 1 on.
UnitsFromStored mapFor(const Volume& volume) {
    const ValueRange range = volume.valueRange().value_or(ValueRange{0.0, 1.0});
    const double width = std::max(range.high - range.low, std::numeric_limits<double>::min());
    double slope =
        volume.format() == VoxelFormat::stored16 ? volume.unitsFromStored().slope : width / kLevels;
    // A volume may use all 65536 numbers; its steps are then doubled.
    while (width / slope > kLevels - 1.0) slope *= 2.0;
    return {slope, range.low - slope};
}

std::vector<std::uint16_t> pixelsOf(const slices::SampledSlice& slice, const UnitsFromStored& map,
                                    bool& hasValues) {
    std::vector<std::uint16_t> pixels;
    pixels.reserve(slice.values.size());
    for (const float value : slice.values) {
        if (std::isnan(value)) {
            pixels.push_back(0);
            continue;
        }
        hasValues = true;
        const double stored = std::round((double(value) - map.intercept) / map.slope);
        pixels.push_back(std::uint16_t(std::clamp(stored, 1.0, kLevels + 1.0)));
    }
    return pixels;
}

// The images between whose slices a plane with its slab lies; null frames are interpolated slices.
class Sources {
  public:
    explicit Sources(const PlaneBatchRequest& request)
        : voxelFromWorld_(glm::inverse(request.volume->worldFromVoxel())) {
        if (!request.found) return;
        const study::FoundVolume& of = request.found->volumes().at(request.volumeIndex);
        for (const study::SliceImage& slice : study::imagesOfSlices(*request.volume, *of.stack)) {
            images_.emplace_back();
            if (slice.frame == nullptr || !slice.frame->instance) continue;
            const dicom::Instance& instance = *slice.frame->instance;
            images_.back() = dicom::ReferencedImage{instance.sopClassUid, instance.sopInstanceUid};
            if (instance.multiFrame) images_.back()->frames = {slice.frame->number + 1};
        }
    }

    std::vector<dicom::ReferencedImage> of(const slices::SliceFrame& frame, double slabMm) const {
        double low = std::numeric_limits<double>::max();
        double high = std::numeric_limits<double>::lowest();
        for (const double depth : {-0.5 * slabMm, 0.5 * slabMm})
            for (const glm::dvec2& corner : {glm::dvec2(0.0), glm::dvec2(frame.sizePx.x, 0.0),
                                             glm::dvec2(0.0, frame.sizePx.y), glm::dvec2(frame.sizePx)}) {
                const glm::dvec3 mm = frame.worldFromPicture(corner) + depth * frame.plane.normal();
                const double k = transformPoint(voxelFromWorld_, mm).z;
                low = std::min(low, k);
                high = std::max(high, k);
            }
        constexpr double kOnASlice = 1e-3;
        std::vector<dicom::ReferencedImage> sources;
        for (std::size_t k = 0; k < images_.size(); ++k) {
            if (double(k) < std::floor(low + kOnASlice) || double(k) > std::ceil(high - kOnASlice)) continue;
            if (!images_[k]) continue;
            if (sources.empty() || sources.back().sopInstanceUid != images_[k]->sopInstanceUid)
                sources.push_back(*images_[k]);
            else
                sources.back().frames.insert(sources.back().frames.end(), images_[k]->frames.begin(),
                                             images_[k]->frames.end());
        }
        return sources;
    }

  private:
    glm::dmat4 voxelFromWorld_;
    std::vector<std::optional<dicom::ReferencedImage>> images_;
};

bool isFromLossyImages(const Volume& volume) {
    return std::ranges::any_of(volume.provenance().messages,
                               [](const Message& m) { return m.key == dicom::key::kLossySource; });
}

std::string derivationOf(const PlaneBatchRequest& request, std::size_t count) {
    const PlaneBatch& batch = request.batch;
    std::string words =
        batch.radial ? fmt::format("{} planes about a line, in half a turn", count)
                     : fmt::format("{} parallel planes, {:.4g} mm apart", count, std::abs(batch.stepMm));
    words += ", by linear interpolation";
    if (batch.slab.thicknessMm > 0.0)
        words += fmt::format("; slab of {:.4g} mm, {}", batch.slab.thicknessMm,
                             slices::nameOf(batch.slab.projection));
    if (!request.volume->provenance().isCalibrated)
        words += "; the size of a pixel was not calibrated, lengths are estimates";
    if (isFromLossyImages(*request.volume)) words += "; from images that were compressed with loss";
    return words;
}

// Along the body: of the picture's height and width, as they lie to the head.
double heightMmOf(const slices::SliceFrame& frame) {
    return frame.mmPerPixel * (double(frame.sizePx.x) * std::abs(frame.plane.right.z) +
                               double(frame.sizePx.y) * std::abs(frame.plane.down.z));
}

dicom::PlaneSeries seriesOf(const PlaneBatchRequest& request, const std::vector<slices::SliceFrame>& frames) {
    const Volume& volume = *request.volume;
    dicom::PlaneSeries series{
        .seriesInstanceUid = dicom::newUid(),
        .frameOfReferenceUid = dicom::newUid(),
        .seriesDescription = request.batch.radial ? "Macula radial planes" : "Macula planes",
        .derivation = derivationOf(request, frames.size()),
        .columns = frames.front().sizePx.x,
        .rows = frames.front().sizePx.y,
        .spacingMm = frames.front().mmPerPixel,
        .thicknessMm = std::max(request.batch.slab.thicknessMm, 0.0),
        .unitsFromStored = mapFor(volume),
        .isHounsfield = volume.unit() == Unit::hounsfield,
        .window = request.window,
        .isFromLossyImages = isFromLossyImages(volume),
        .bodyPart = volume.bodyPart(),
        .heightMm = heightMmOf(frames.front())};
    if (!volume.modality().empty()) series.modality = volume.modality();
    if (!request.batch.radial) series.stepMm = std::abs(request.batch.stepMm);
    if (request.found)
        series.frameOfReferenceUid =
            study::frameOfReferenceOf(*request.found->volumes().at(request.volumeIndex).stack);
    return series;
}

dicom::NewObject objectFor(const PlaneBatchRequest& request) {
    dicom::NewObject object{
        .image = {}, .isDeidentified = request.isDeidentified, .softwareVersion = MACULA_VERSION};
    if (!request.found) return object;
    const auto& frames = request.found->volumes().at(request.volumeIndex).stack->frames;
    if (frames.empty()) return object;
    const dicom::Instance& middle = *frames[frames.size() / 2].instance;
    object.image = dicom::SecondaryCapture::Source{middle.file, middle.sopInstanceUid};
    return object;
}

std::vector<Text> notesOn(const PlaneBatchRequest& request, const dicom::PlaneSeries& series) {
    std::vector<Text> notes{Text("Values are rounded to steps of {:.3g}.", series.unitsFromStored.slope)};
    const glm::dvec3 voxel = request.volume->spacingMm();
    if (series.spacingMm > 1.001 * std::min({voxel.x, voxel.y, voxel.z}))
        notes.push_back(Text("Pixels are larger than voxels: {:.3g} mm.", series.spacingMm));
    if (!request.volume->provenance().isCalibrated)
        notes.push_back(Text("Its size is an estimate: the size of a pixel is not calibrated."));
    return notes;
}

Result<WrittenPlanes> write(const fs::path& folder, const PlaneBatchRequest& request, Progress& progress) {
    if (!request.found && !request.isDeidentified)
        return Error{ErrorCode::usage,
                     Text("The files of this study do not say which patient and which study it is."),
                     {},
                     Text("Write the planes without patient and study.")};
    MACULA_TRY(const auto frames, framesOf(request.batch, mmPerPixelOf(request.batch, *request.volume)));
    const dicom::PlaneSeries series = seriesOf(request, frames);
    const dicom::NewObject object = objectFor(request);
    const Sources sources(request);
    std::error_code error;
    const fs::path target = fs::absolute(folder, error).lexically_normal();
    const fs::path place = target.has_filename() ? target : target.parent_path();
    MACULA_TRY(const Draft draft, Draft::beside(place, Draft::Kind::folder));
    progress.beginStage(Text("Writing {} planes", frames.size()), frames.size());
    WrittenPlanes written;
    bool hasValues = false;
    for (std::size_t n = 0; n < frames.size(); ++n) {
        const auto slice = slices::sampleSlice(*request.volume, frames[n], request.batch.slab,
                                               slices::Filter::linear, [&] { return progress.cancelled(); });
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, Text("Stopped; nothing was written."), {}, {}};
        const std::vector<std::uint16_t> pixels = pixelsOf(slice, series.unitsFromStored, hasValues);
        const dicom::PlaneImage image{.positionMm = frames[n].worldFromPicture({0.5, 0.5}),
                                      .rowDirection = frames[n].plane.right,
                                      .columnDirection = frames[n].plane.down,
                                      .pixels = pixels,
                                      .number = int(n) + 1,
                                      .sources = sources.of(frames[n], series.thicknessMm)};
        const std::string name = fmt::format("IM{:05}.dcm", n + 1);
        MACULA_TRY_VOID(dicom::writePlaneImage(draft.path() / name, series, image, object));
        written.files.push_back(place / name);
        progress.advance();
    }
    if (!hasValues)
        return Error{ErrorCode::usage,
                     Text("None of these planes meets the volume."),
                     {},
                     Text("Choose other distances.")};
    // rename() replaces an empty folder and refuses any other, so that nothing of the user's is ever lost.
    fs::rename(draft.path(), place, error);
    if (error)
        return Error{ErrorCode::outputNotWritable,
                     Text("The folder to write into is not empty, or cannot be replaced."), folder.string(),
                     Text("Choose a folder that is empty or does not exist.")};
    written.notes = notesOn(request, series);
    return written;
}

}  // namespace

Result<WrittenPlanes> writePlanes(const fs::path& folder, const PlaneBatchRequest& request,
                                  Progress& progress) try {
    return write(folder, request, progress);
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 Text("There is not enough memory for these planes."),
                 {},
                 Text("Choose fewer, or close other programs.")};
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("write the planes"));
}

}  // namespace macula::scene
