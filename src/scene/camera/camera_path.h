// Where a camera goes, by time; as a JSON file a list of
//   { "atS": 0, "camera": {as camera_file.h} }
// in order of time. The first is at 0.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/result.h"

namespace macula::app {

struct CameraPath {
    struct Stop {
        double atS = 0.0;
        Camera camera;
    };
    std::vector<Stop> stops;  // at least one; each later than the one before

    double seconds() const { return stops.back().atS; }
};

// At most kMostStops. inputNotUsable: says which stop is wrong, and how.
inline constexpr std::size_t kMostStops = 10000;
Result<CameraPath> readCameraPath(const std::filesystem::path& path);

// Walks around the target of `camera` towards the patient's left: one turn in `turnS`, for `seconds`.
CameraPath turntable(const Camera& camera, double turnS, double seconds);

// The text that readCameraPath reads.
std::string toJson(const CameraPath& path);

// Before the first stop and after the last it stands still. Between two upright ones (as all of a window are)
// it goes around as on a turntable, by the shorter way: smoothly through every stop, never beyond what both
// neighbours say, never upside down. Between others the target goes straight, and the eye around it by the
// shorter way. Rays are parallel between two stops where they are at both, else those of an eye.
Camera cameraAt(const CameraPath& path, double atS);

}  // namespace macula::app
