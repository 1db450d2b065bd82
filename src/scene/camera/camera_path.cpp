#include "scene/camera/camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/atomic_file.h"
#include "pipeline/volume/json_reader.h"
#include "pipeline/volume/json_writer.h"
#include "scene/camera/camera_file.h"
#include "scene/camera/orbit_camera.h"

namespace macula::scene {

namespace {

constexpr double kLongestS = 3600.0;
constexpr double kStopEveryDeg = 5.0;  // stops of a turntable, between which the eye follows an arc

// From unit vector `a` to `b` by the shorter way, at constant speed.
glm::dvec3 turned(const glm::dvec3& a, const glm::dvec3& b, double t) {
    const glm::dvec3 axis = glm::cross(a, b);
    const double sine = glm::length(axis);
    const double angle = std::atan2(sine, glm::dot(a, b));
    if (sine < 1e-9) return a;  // the same, or opposite: then neither way is shorter
    const glm::dvec3 across = glm::cross(axis / sine, a);
    return std::cos(t * angle) * a + std::sin(t * angle) * across;
}

constexpr double kUpright = 1e-6;  // distance of up directions below which two pictures look the same

// A camera as numbers that can each be interpolated separately.
struct OnTurntable {
    // target x, y, z, distance, azimuth, elevation, field of view, logarithm of the height at the target
    std::array<double, 8> values{};
    static constexpr std::size_t kAzimuth = 4;
    static constexpr std::size_t kLogHeight = 7;
};

// Nothing for a camera that is rolled.
std::optional<OnTurntable> onTurntable(const Camera& camera) {
    const OrbitCamera orbit = orbitCameraOf(camera);
    const auto seen = basis(camera);
    const auto upright = basis(toCamera(orbit));
    if (!seen || !upright || glm::distance(seen->up, upright->up) > kUpright) return std::nullopt;
    return OnTurntable{{orbit.targetMm.x, orbit.targetMm.y, orbit.targetMm.z, orbit.distanceMm,
                        orbit.azimuthDeg, orbit.elevationDeg, orbit.verticalFovDeg,
                        std::log(heightAtTargetMm(camera))}};
}

Camera toCamera(const OnTurntable& at) {
    const auto& v = at.values;
    return toCamera(OrbitCamera{.targetMm = {v[0], v[1], v[2]},
                                .distanceMm = v[3],
                                .azimuthDeg = v[4],
                                .elevationDeg = v[5],
                                .verticalFovDeg = v[6]});
}

// Between two stops rays are parallel if they are at both; the picture then grows by equal factors in equal
// times. Nothing lies between perspective and parallel rays, so the way from one to the other is in
// perspective.
bool isParallelBetween(const Camera& a, const Camera& b) {
    return isParallel(a) && isParallel(b);
}

// The slope at a stop between two pieces of the path: a weighted harmonic mean of both slopes, 0 at a turning
// point. A cubic with such slopes never leaves the values at its ends (Fritsch and Butland).
double slopeAt(double before, double beforeS, double after, double afterS) {
    if (!(before * after > 0.0)) return 0.0;
    const double a = 2.0 * afterS + beforeS;
    const double b = afterS + 2.0 * beforeS;
    return (a + b) / (a / before + b / after);
}

// The camera at the fraction `t` of the way from stop `from` to the next. Nothing if a camera nearby is
// rolled.
std::optional<Camera> smoothly(const std::vector<CameraPath::Stop>& stops, std::size_t from, double t) {
    const std::size_t first = from == 0 ? 0 : from - 1;
    const std::size_t last = std::min(from + 2, stops.size() - 1);
    std::vector<OnTurntable> around;
    for (std::size_t i = first; i <= last; ++i) {
        const auto at = onTurntable(stops[i].camera);
        if (!at) return std::nullopt;
        around.push_back(*at);
        if (i == first) continue;
        double& azimuth = around.back().values[OnTurntable::kAzimuth];
        const double before = around[around.size() - 2].values[OnTurntable::kAzimuth];
        azimuth = before + std::remainder(azimuth - before, 360.0);
    }
    const std::size_t a = from - first;
    const double spanS = stops[from + 1].atS - stops[from].atS;
    OnTurntable now;
    for (std::size_t v = 0; v < now.values.size(); ++v) {
        const auto slope = [&](std::size_t i) {  // slope and duration of the piece that begins at stop i
            const double seconds = stops[first + i + 1].atS - stops[first + i].atS;
            return std::pair((around[i + 1].values[v] - around[i].values[v]) / seconds, seconds);
        };
        const auto [middle, middleS] = slope(a);
        double atBegin = middle;
        double atEnd = middle;
        if (a > 0) atBegin = slopeAt(slope(a - 1).first, slope(a - 1).second, middle, middleS);
        if (a + 2 < around.size()) atEnd = slopeAt(middle, middleS, slope(a + 1).first, slope(a + 1).second);
        const double t2 = t * t;
        const double t3 = t2 * t;
        now.values[v] = (2 * t3 - 3 * t2 + 1) * around[a].values[v] + (t3 - 2 * t2 + t) * spanS * atBegin +
                        (3 * t2 - 2 * t3) * around[a + 1].values[v] + (t3 - t2) * spanS * atEnd;
    }
    Camera camera = toCamera(now);
    if (isParallelBetween(stops[from].camera, stops[from + 1].camera))
        camera.parallelHeightMm = std::exp(now.values[OnTurntable::kLogHeight]);
    return camera;
}

}  // namespace

std::string toJson(const CameraPath& path) {
    nlohmann::ordered_json stops = nlohmann::ordered_json::array();
    for (const CameraPath::Stop& stop : path.stops)
        stops.push_back({{"atS", stop.atS}, {"camera", toJson(stop.camera)}});
    return prettyJson(stops);
}

Result<CameraPath> readCameraPath(const std::filesystem::path& path) {
    MACULA_TRY(const std::string text, readText(path));
    const JsonDocument document(text, path.string());
    MACULA_TRY_VOID(document.status());
    CameraPath read;
    for (const JsonNode& node : document.root().items(1, kMostStops)) {
        node.allowOnly({"atS", "camera"});
        const JsonNode at = node["atS"];
        CameraPath::Stop stop{.atS = at.number({0.0, kLongestS}), .camera = cameraFrom(node["camera"])};
        if (read.stops.empty() && stop.atS != 0.0) at.fail(Text("0 for the first camera"));
        if (!read.stops.empty() && !(stop.atS > read.stops.back().atS))
            at.fail(Text("a later time than that of the camera before"));
        read.stops.push_back(stop);
    }
    MACULA_TRY_VOID(document.status());
    for (std::size_t i = 0; i < read.stops.size(); ++i) {
        const auto valid = basis(read.stops[i].camera);
        if (valid) continue;
        return Error{ErrorCode::inputNotUsable,
                     Text("Camera {} of the path is none: {}", i + 1, valid.error().message), path.string(),
                     valid.error().hint};
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
    Camera a = std::prev(after)->camera;
    Camera b = after->camera;
    const double t = (atS - std::prev(after)->atS) / (after->atS - std::prev(after)->atS);
    if (t <= 0.0) return a;
    if (const auto smooth = smoothly(stops, std::size_t(std::prev(after) - stops.begin()), t)) return *smooth;
    const bool isParallelNow = isParallelBetween(a, b);
    if (!isParallelNow) {  // parallel cameras become eyes that see as much
        a = inPerspective(a);
        b = inPerspective(b);
    }
    const glm::dvec3 aside = a.positionMm - a.targetMm;
    const glm::dvec3 bside = b.positionMm - b.targetMm;
    const double distanceMm = glm::mix(glm::length(aside), glm::length(bside), t);
    Camera now;
    now.targetMm = glm::mix(a.targetMm, b.targetMm, t);
    now.positionMm = now.targetMm + distanceMm * turned(glm::normalize(aside), glm::normalize(bside), t);
    now.up = turned(glm::normalize(a.up), glm::normalize(b.up), t);
    now.verticalFovDeg = glm::mix(a.verticalFovDeg, b.verticalFovDeg, t);
    if (isParallelNow)
        now.parallelHeightMm = a.parallelHeightMm * std::pow(b.parallelHeightMm / a.parallelHeightMm, t);
    // On the way the up direction may come to lie along the view; that of the stop before will do then.
    if (!basis(now)) now.up = a.up;
    return basis(now) ? now : a;
}

}  // namespace macula::scene
