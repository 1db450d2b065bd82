#include "pictures/view_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "live/device/open_device.h"
#include "pictures/drawn_picture.h"
#include "pictures/picture_file.h"
#include "pictures/render_record.h"
#include "pictures/view_request.h"

namespace macula::pictures {

namespace {

// Names only built-in presets, because a user's own may be named after somebody. Remarks say what is hidden,
// and through which window values are seen. Units may have characters that DICOM's default set lacks.
std::string derivationOf(const ViewPicture& picture, const RenderRecord& record) {
    const trace::Look look = record.settings.look;
    std::string text = fmt::format("Volume rendering ({})", trace::nameOf(look));
    if (!trace::isProjection(look)) text += ", preset " + record.preset;
    if (!picture.drawing.remarks.empty()) text += ", " + picture.drawing.remarks.english();
    if (record.effects.lensMm > 0.0)
        text += fmt::format(", blurred by a lens of {:g} mm but at {:.0f} mm", record.effects.lensMm,
                            record.effects.focusMm.value_or(0.0));
    if (record.effects.fogMm > 0.0) text += fmt::format(", faded by fog of {:g} mm", record.effects.fogMm);
    if (picture.stampsFor) text += ", with marks of orientation and scale";
    text +=
        fmt::format(", {:.0f} samples per pixel{}. Not for primary diagnosis.",
                    record.statistics.meanSamplesPerPixel, record.statistics.denoised ? ", denoised" : "");
    std::ranges::replace_if(
        text, [](char c) { return c < ' ' || c > '~' || c == '\\'; }, '?');
    return text;
}

double heightMm(const Volume& volume) {
    const Box box = volume.worldBox();
    return box.high.z - box.low.z;
}

Result<void> writeCapture(const ViewPicture& picture, const DrawnPicture& drawn, const RenderRecord& record) {
    return dicom::writeSecondaryCapture(picture.output,
                                        {.widthPx = picture.sizePx.x,
                                         .heightPx = picture.sizePx.y,
                                         .rgba = drawn.rgba,
                                         .source = picture.source,
                                         .isOfNobody = picture.isOfNobody,
                                         .seriesDescription = "Macula 3D, not for primary diagnosis",
                                         .derivation = derivationOf(picture, record),
                                         .softwareVersion = MACULA_VERSION,
                                         .isDeidentified = picture.isDeidentified,
                                         .heightMm = heightMm(*picture.volume)});
}

}  // namespace

Result<std::vector<Text>> writeViewPicture(const ViewPicture& picture, const std::string& preferredDevice,
                                           Progress& progress) {
    if (!isDicom(picture.output)) MACULA_TRY_VOID(checkPictureName(picture.output));
    MACULA_TRY(const PictureRequest request, requestOf(picture, isExr(picture.output)));
    std::vector<Text> sentences;
    MACULA_TRY(gpu::LastingDevice device, live::openDevice(preferredDevice, [&](const Text& sentence) {
                   sentences.push_back(sentence);
               }));
    DrawnPicture drawn;
    MACULA_TRY_VOID(device.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(drawn, drawPicture(on, request, progress));
        return {};
    }));
    if (picture.stampsFor && request.isLinear) {
        sentences.emplace_back(Text("A picture of light has no cube, scale and letters over it."));
    } else if (picture.stampsFor) {
        for (const Stamp& stamp : picture.stampsFor(picture.camera))
            putOver(drawn.rgba, request.sizePx, stamp);
    }
    const RenderRecord record = recordOf(picture, request, drawn);
    MACULA_TRY_VOID(isDicom(picture.output)
                        ? writeCapture(picture, drawn, record)
                        : writePicture(picture.output, drawn, request.sizePx, metadata(record)));
    for (Text& note : sentencesOf(drawn, request)) sentences.push_back(std::move(note));
    return sentences;
}

Result<double> meteredExposureOf(const ViewPicture& picture, const std::string& preferredDevice,
                                 Progress& progress) {
    if (progress.cancelled()) return stopped();
    MACULA_TRY(const PictureRequest request, requestOf(picture, true));
    MACULA_TRY(gpu::LastingDevice device, live::openDevice(preferredDevice, [](const Text&) {}));
    double exposure = 1.0;
    MACULA_TRY_VOID(device.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(PictureDrawer drawer, PictureDrawer::create(on, request, progress));
        MACULA_TRY(exposure, drawer.meterExposure(picture.camera, progress));
        return {};
    }));
    return exposure;
}

Result<std::vector<std::vector<std::uint8_t>>> drawViewPictures(const std::vector<ViewPicture>& pictures,
                                                                const std::string& preferredDevice,
                                                                Progress& progress) {
    if (progress.cancelled()) return stopped();  // opening a device takes long
    MACULA_TRY(gpu::LastingDevice device, live::openDevice(preferredDevice, [](const Text&) {}));
    std::vector<std::vector<std::uint8_t>> drawn;
    for (const ViewPicture& picture : pictures) {
        if (progress.cancelled()) return stopped();
        MACULA_TRY(const PictureRequest request, requestOf(picture, false));
        MACULA_TRY_VOID(device.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
            MACULA_TRY(DrawnPicture made, drawPicture(on, request, progress));
            drawn.push_back(std::move(made.rgba));
            return {};
        }));
    }
    return drawn;
}

}  // namespace macula::pictures
