#include "app/camera/camera_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/camera/camera_file.h"
#include "app/camera/orbit_camera.h"
#include "base/atomic_file.h"
#include "pipeline/volume/json_reader.h"

namespace macula::app {

namespace {

constexpr double kLongestS = 3600.0;
constexpr double kStopEveryDeg = 5.0;  // of a turntable: the way between two stops is a part of a circle

// From unit vector `a` to `b` by the shorter way, at constant speed.
glm::dvec3 turned(const glm::dvec3& a, const glm::dvec3& b, double t) {
    const glm::dvec3 axis = glm::cross(a, b);
    const double sine = glm::length(axis);
    const double angle = std::atan2(sine, glm::dot(a, b));
    if (sine < 1e-9) return a;  // the same, or opposite: no way is the shorter one
    const glm::dvec3 across = glm::cross(axis / sine, a);
    return std::cos(t * angle) * a + std::sin(t * angle) * across;
}

}  // namespace

Result<CameraPath> readCameraPath(const std::filesystem::path& path) {
    MACULA_TRY(const std::string text, readText(path));
    const JsonDocument document(text, path.string());
    MACULA_TRY_VOID(document.status());
    CameraPath read;
    for (const JsonNode& node : document.root().items(1, kMostStops)) {
        node.allowOnly({"atS", "camera"});
        const JsonNode at = node["atS"];
        CameraPath::Stop stop{.atS = at.number({0.0, kLongestS}), .camera = cameraFrom(node["camera"])};
        if (read.stops.empty() && stop.atS != 0.0) at.fail("0 for the first camera");
        if (!read.stops.empty() && !(stop.atS > read.stops.back().atS))
            at.fail("a later time than that of the camera before");
        read.stops.push_back(stop);
    }
    MACULA_TRY_VOID(document.status());
    for (std::size_t i = 0; i < read.stops.size(); ++i) {
        const auto valid = basis(read.stops[i].camera);
        if (valid) continue;
        return Error{ErrorCode::inputNotUsable,
                     fmt::format("Camera {} of the path is none: {}", i + 1, valid.error().message),
                     path.string(), valid.error().hint};
    }
    return read;
}

CameraPath turntable(const Camera& camera, double turnS, double seconds) {
    const OrbitCamera from = orbitCameraOf(camera);
    const double degrees = 360.0 * seconds / turnS;
    const int steps = std::max(1, int(std::ceil(degrees / kStopEveryDeg)));
    CameraPath path;
    for (int i = 0; i <= steps; ++i) {
        const double t = double(i) / steps;
        path.stops.push_back({.atS = t * seconds, .camera = toCamera(orbited(from, t * degrees, 0.0))});
        if (!(seconds > 0.0)) break;
    }
    return path;
}

Camera cameraAt(const CameraPath& path, double atS) {
    const auto& stops = path.stops;
    const auto after =
        std::find_if(stops.begin(), stops.end(), [&](const CameraPath::Stop& s) { return s.atS > atS; });
    if (after == stops.begin()) return stops.front().camera;
    if (after == stops.end()) return stops.back().camera;
    const Camera& a = std::prev(after)->camera;
    const Camera& b = after->camera;
    const double t = (atS - std::prev(after)->atS) / (after->atS - std::prev(after)->atS);
    const glm::dvec3 aside = a.positionMm - a.targetMm;
    const glm::dvec3 bside = b.positionMm - b.targetMm;
    const double distanceMm = glm::mix(glm::length(aside), glm::length(bside), t);
    Camera now;
    now.targetMm = glm::mix(a.targetMm, b.targetMm, t);
    now.positionMm = now.targetMm + distanceMm * turned(glm::normalize(aside), glm::normalize(bside), t);
    now.up = turned(glm::normalize(a.up), glm::normalize(b.up), t);
    now.verticalFovDeg = glm::mix(a.verticalFovDeg, b.verticalFovDeg, t);
    // From an eye to parallel rays there is nothing between.
    now.parallelHeightMm = isParallel(a) && isParallel(b)
                               ? glm::mix(a.parallelHeightMm, b.parallelHeightMm, t)
                               : a.parallelHeightMm;
    // Halfway the up direction may come to lie along the view; the one of before is as good.
    if (!basis(now)) now.up = a.up;
    return basis(now) ? now : a;
}

}  // namespace macula::app
