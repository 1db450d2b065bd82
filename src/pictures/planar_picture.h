// A picture of one image as it is shown on its own: an X-ray, a frame of ultrasound, a photograph.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"

namespace macula::pictures {

struct PlanarPictureRequest {
    std::filesystem::path path;  // of a folder or an image
    std::string series;          // its place in the list of `macula info`, or its UID; empty: the usual one
    std::size_t image = 1;       // of the series, from 1, counting the frames of its files
    std::optional<std::pair<double, double>> window;  // centre and width; nothing: that of the file
    std::filesystem::path presentation;               // a Grayscale Softcopy Presentation State; empty: none
    bool hasOverlays = true;
    std::filesystem::path output;  // .png
    dicom::ScanOptions how;
};

struct PlanarPictureWritten {
    int columns = 0;
    int rows = 0;
    std::size_t images = 0;   // of the series
    std::vector<Text> notes;  // on what the picture does not show, or shows differently
};

// One pixel of the file is one of the picture, without anything but pixels in it. Fails with usage for an
// image that the series lacks and for a window that shows nothing, with inputNotUsable, and with
// outputNotWritable.
Result<PlanarPictureWritten> writePlanarPicture(const PlanarPictureRequest& request, Progress& progress);

}  // namespace macula::pictures
