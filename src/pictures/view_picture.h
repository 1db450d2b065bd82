// What a window shows, drawn whole and at any size, to a file.
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

namespace macula::app {

struct ViewPicture {
    std::shared_ptr<const Volume> volume;
    std::string seriesDigest;  // goes into the file: no name of anybody does
    Drawing drawing;           // complete
    Camera camera;
    glm::ivec2 sizePx{0};
    EffortWish effort;
    PictureEffects effects = {};
    std::filesystem::path output;  // .png, .exr or .dcm; a file that is there is replaced
    // Of .dcm: an image of the series that is shown (dicom::SecondaryCapture), and whether nothing is taken
    // from it.
    std::optional<dicom::SecondaryCapture::Source> source = {};
    bool isOfNobody = false;
    bool isDeidentified = false;
    // What is laid over the picture, unless it is of light (.exr); may be empty. Says nothing of who is
    // shown. Called by the thread that draws.
    std::function<std::vector<Stamp>(const Camera&)> stampsFor = {};
};

// Opens a device of its own, as `preferredDevice` of gpu::chooseDevice, so a window goes on beside it. Takes
// as long as that picture does. Sentences that a person should know, without patient data. usage for another
// extension or size; fails as drawPicture and writePicture; nothing is written then.
Result<std::vector<std::string>> writeViewPicture(const ViewPicture& picture,
                                                  const std::string& preferredDevice, Progress& progress);

// Measures the exposure that suits the picture (PictureDrawer::meterExposure), and ignores that of the view.
// Fails as above.
Result<double> meteredExposureOf(const ViewPicture& picture, const std::string& preferredDevice,
                                 Progress& progress);

// The same pictures to be looked at, beside each other: 4 bytes a pixel, display-encoded over the background
// of the drawing, row 0 on top. `output` and what is of files does not matter. Fails as above.
Result<std::vector<std::vector<std::uint8_t>>> drawViewPictures(const std::vector<ViewPicture>& pictures,
                                                                const std::string& preferredDevice,
                                                                Progress& progress);

}  // namespace macula::app
