// The path of a camera over time. The JSON file is a list of
//   { "atS": 0, "camera": {as camera_file.h} }
// in order of time. The first stop is at 0.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/result.h"

namespace macula::scene {

struct CameraPath {
    struct Stop {
        double atS = 0.0;
        Camera camera;
    };
    std::vector<Stop> stops;  // at least one; each later than the one before

    double seconds() const { return stops.back().atS; }
};

// At most kMostStops. An inputNotUsable error names the stop and says what is wrong with it.
inline constexpr std::size_t kMostStops = 10000;
Result<CameraPath> readCameraPath(const std::filesystem::path& path);

// A path that circles the target of `camera` towards the patient's left, one turn in `turnS`, for `seconds`.
CameraPath turntable(const Camera& camera, double turnS, double seconds);

// The text that readCameraPath reads.
std::string toJson(const CameraPath& path);

// The camera stands still before the first stop and after the last. Between upright stops with upright
// neighbours it moves as on a turntable, by the shorter way: smoothly through every stop, never beyond the
// values at both ends, never upside down. Between other stops the target moves straight, and the eye turns
// around it by the shorter way. Rays are parallel between two parallel stops, otherwise in perspective.
Camera cameraAt(const CameraPath& path, double atS);

}  // namespace macula::scene
