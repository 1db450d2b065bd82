#include "pictures/planar_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "dicom/presentation/softcopy_state.h"
#include "image/image_file.h"
#include "study/open/loaded_study.h"
#include "study/planar/planar_presentation.h"

namespace macula::pictures {

namespace {

Error noImages(const PlanarPictureRequest& request) {
    return {ErrorCode::inputNotUsable, Text("There are no images to show on their own."),
            request.path.string(), Text("Name a series of the list of macula info with --series.")};
}

// Of a series that is named also images of a volume.
Result<const dicom::Stack*> stackOf(const PlanarPictureRequest& request, const study::FoundVolumes& found) {
    if (request.series.empty()) {
        const study::PlanarSeries usual = study::planarSeriesFor(found, request.path);
        if (usual.stack == nullptr) return noImages(request);
        return usual.stack;
    }
    const dicom::Series* series = study::seriesMeant(found.scan(), request.series);
    if (series == nullptr || series->stacks.empty()) return noImages(request);
    const auto planar = std::ranges::find_if(series->stacks, study::canBeShownAsImages);
    return planar == series->stacks.end() ? &series->stacks.front() : &*planar;
}

std::vector<std::uint8_t> rgbaOf(const study::PlanarPicture& picture) {
    std::vector<std::uint8_t> rgba;
    const std::size_t samples = picture.isColour ? 3 : 1;
    rgba.reserve(4 * picture.bytes.size() / samples);
    for (std::size_t i = 0; i < picture.bytes.size(); i += samples) {
        for (std::size_t c = 0; c < 3; ++c) rgba.push_back(picture.bytes[i + (samples == 3 ? c : 0)]);
        rgba.push_back(255);
    }
    return rgba;
}

// The picture as the file or the presentation state says.
Result<study::PlanarPicture> drawn(const PlanarPictureRequest& request, const dicom::Frame& frame,
                                   const dicom::PlanarHeader& header, const dicom::PlanarFrame& pixels,
                                   std::vector<Text>& notes) {
    study::PlanarDisplay display = study::usualDisplay(frame, header, pixels);
    std::optional<study::PresentedImage> presented;
    if (!request.presentation.empty()) {
        MACULA_TRY(const dicom::SoftcopyState said, dicom::readSoftcopyState(request.presentation));
        presented = study::presentedOn(said, frame, header, pixels, display);
        if (!presented)
            return Error{ErrorCode::inputNotUsable, Text("The presentation state is of other images."),
                         request.presentation.string(),
                         Text("Choose one of its images with --series and --image.")};
        display = presented->display;
        notes = presented->notes;
        if (!presented->annotations.empty())
            notes.emplace_back(Text("Its graphics and texts are not drawn here; the window shows them."));
        if (presented->area)
            notes.emplace_back(Text("All of the image is drawn, not its displayed area alone."));
    }
    if (request.window) {
        const auto [centre, width] = *request.window;
        if (!std::isfinite(centre) || !std::isfinite(width) || !(width > 0.0))
            return Error{ErrorCode::usage,
                         Text("The window shows no values."),
                         {},
                         Text("Give its centre and its width, which is above 0: --window 40,400.")};
        display = {
            .window = {.center = centre, .width = width, .explanation = {}, .function = "LINEAR_EXACT"},
            .table = {},
            .isInverted = display.isInverted};
        if (pixels.isColour()) notes.emplace_back(Text("The image is in colours, which no window changes."));
    }
    study::PlanarPicture picture = study::pictureOf(pixels, header, display);
    if (request.hasOverlays)
        for (const dicom::OverlayMask& overlay : presented ? presented->overlays : pixels.overlays)
            study::addOverlay(picture, overlay);
    const auto& shutter = presented && presented->shutter ? presented->shutter : header.shutter;
    if (shutter) {
        study::addShutter(picture, *shutter, header.pixelHeightOverWidth);
        notes.emplace_back(Text("A shutter hides part of the image."));
    }
    if (!presented) return picture;
    return study::turned(picture, presented->quarters, presented->isMirrored);
}

}  // namespace

Result<PlanarPictureWritten> writePlanarPicture(const PlanarPictureRequest& request, Progress& progress) {
    MACULA_TRY(dicom::Scan scan, dicom::scanFolder(request.path, progress, request.how));
    const study::FoundVolumes found(std::move(scan));
    MACULA_TRY(const dicom::Stack* stack, stackOf(request, found));
    if (request.image < 1 || request.image > stack->frames.size())
        return Error{ErrorCode::usage,
                     Text("The series has {} images.", stack->frames.size()),
                     {},
                     Text("Give one of them with --image, from 1.")};
    const std::size_t place = request.image - 1;
    const dicom::Frame& frame = stack->frames[place];
    MACULA_TRY(const dicom::PlanarHeader header, dicom::readPlanarHeader(frame.instance->file, frame.number));
    MACULA_TRY(const dicom::PlanarFrame pixels,
               dicom::loadPlanarFrame(*stack, place, header, progress.token()));
    PlanarPictureWritten written{.images = stack->frames.size(), .notes = {}};
    MACULA_TRY(const study::PlanarPicture picture, drawn(request, frame, header, pixels, written.notes));
    if (std::abs(header.pixelHeightOverWidth - 1.0) > 1e-3)
        written.notes.emplace_back(
            Text("Its pixels are {:.3g} times as high as wide; those of the picture are square.",
                 header.pixelHeightOverWidth));
    written.columns = picture.columns;
    written.rows = picture.rows;
    MACULA_TRY_VOID(image::writePng(request.output, picture.columns, picture.rows, rgbaOf(picture)));
    return written;
}

}  // namespace macula::pictures
