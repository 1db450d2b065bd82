// What a window shows, drawn whole from many places, to a folder of pictures: a turntable, or a way.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pictures/stamp.h"
#include "pictures/view_picture.h"
#include "scene/camera/camera_path.h"

namespace macula::app {

struct ViewSequence {
    // Volume, drawing, size and effort of each picture. Its camera and output are not used: pictures are PNG.
    ViewPicture picture;
    CameraPath path;
    int frames = 1;         // 1 to kMostFrames, evenly over the time of the path
    bool isClosed = false;  // it ends where it begins: that is not drawn twice
    // What stands over the picture from there; empty: nothing does. Called on another thread.
    std::function<std::vector<Stamp>(const Camera&)> stampsFor = {};
    std::filesystem::path folder;  // is made where it is not there
};
inline constexpr int kMostFrames = 36000;

// The camera of picture `index`, from 0.
Camera cameraOf(const ViewSequence& sequence, int index);

// "frame-0001.png" for index 0; as many digits as the last one needs, at least four.
std::string frameName(int index, int frames);

struct WrittenSequence {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> sentences;  // that a person should know, without patient data
};

// Opens a device of its own, as writeViewPicture. When it is stopped or fails, none of its pictures are left.
// usage where the folder has pictures of that name already, for too many frames, or as writeViewPicture;
// outputNotWritable; fails as drawPicture.
Result<WrittenSequence> writeViewSequence(const ViewSequence& sequence, const std::string& preferredDevice,
                                          Progress& progress);

}  // namespace macula::app
