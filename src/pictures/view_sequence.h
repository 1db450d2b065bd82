// Draws the view of a window along a camera path into a folder of pictures, such as a turntable.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/text.h"
#include "pictures/stamp.h"
#include "pictures/view_picture.h"
#include "scene/camera/camera_path.h"

namespace macula::pictures {

struct ViewSequence {
    // Volume, drawing, size and effort of each picture. Ignores its camera and output: pictures are PNG.
    ViewPicture picture;
    scene::CameraPath path;
    int frames = 1;         // 1 to kMostFrames, evenly spaced over the time of the path
    bool isClosed = false;  // the path ends where it begins; that view is drawn once
    // Stamps over the picture of that camera; may be empty. Called on the thread of writeViewSequence.
    std::function<std::vector<Stamp>(const Camera&)> stampsFor = {};
    std::filesystem::path folder;  // created if it is missing
};
inline constexpr int kMostFrames = 36000;

// The camera of picture `index`, from 0.
Camera cameraOf(const ViewSequence& sequence, int index);

// "frame-0001.png" for index 0; as many digits as the last one needs, at least four.
std::string frameName(int index, int frames);

struct WrittenSequence {
    std::vector<std::filesystem::path> files;
    std::vector<Text> sentences;  // notes to the user, without patient data
};

// Opens a device of its own, as writeViewPicture. Removes its pictures when it is stopped or fails. usage if
// the folder holds pictures of that name, for a path without stops or a count out of range, or as
// writeViewPicture; outputNotWritable; fails as drawPicture.
Result<WrittenSequence> writeViewSequence(const ViewSequence& sequence, const std::string& preferredDevice,
                                          Progress& progress);

}  // namespace macula::pictures
