// Draws the view of a window to a file, whole and at any size.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "dicom/write/secondary_capture.h"
#include "live/frame/frame_input.h"
#include "pictures/picture_effects.h"
#include "pictures/picture_effort.h"
#include "pictures/stamp.h"

namespace macula::pictures {

struct ViewPicture {
    std::shared_ptr<const Volume> volume;
    std::string seriesDigest;  // PNG and EXR have it as publicSeries
    scene::Drawing drawing;    // complete
    Camera camera;
    glm::ivec2 sizePx{0};
    EffortRequest effort;
    PictureEffects effects = {};
    std::filesystem::path output;  // .png, .exr or .dcm; replaces an existing file
    // For .dcm, as in dicom::SecondaryCapture: an image of the shown series, whether the picture shows no
    // patient, and whether to deidentify it.
    std::optional<dicom::SecondaryCapture::Source> source = {};
    bool isOfNobody = false;
    bool isDeidentified = false;
    // Stamps over the picture, except in .exr (linear light); may be empty. They must not name the patient.
    // Called on the thread of writeViewPicture.
    std::function<std::vector<Stamp>(const Camera&)> stampsFor = {};
};

// Opens a device of its own, `preferredDevice` as in gpu::chooseDevice, so that the window keeps running.
// Blocks while it draws. Returns notes to the user, without patient data. usage for another extension or
// size; fails as drawPicture, writePicture and dicom::writeSecondaryCapture, and then writes nothing.
Result<std::vector<Text>> writeViewPicture(const ViewPicture& picture, const std::string& preferredDevice,
                                           Progress& progress);

// Measures the exposure for the picture (PictureDrawer::meterExposure), and ignores that of the view. Fails
// as above.
Result<double> meteredExposureOf(const ViewPicture& picture, const std::string& preferredDevice,
                                 Progress& progress);

// Draws pictures for display: 4 bytes a pixel, display-encoded over the background of the drawing, row 0 on
// top. Ignores `output` and the fields for files. Fails as above.
Result<std::vector<std::vector<std::uint8_t>>> drawViewPictures(const std::vector<ViewPicture>& pictures,
                                                                const std::string& preferredDevice,
                                                                Progress& progress);

}  // namespace macula::pictures
