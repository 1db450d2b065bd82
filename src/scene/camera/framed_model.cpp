#include "scene/camera/framed_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/camera.h"
#include "scene/camera/view_directions.h"

namespace macula::scene {

namespace {

constexpr double kFovDeg = 30.0;  // as macula render
constexpr double kStray = 0.01;
constexpr double kDeviations = 2.0;  // standard deviations: beyond these a splat hardly shows
constexpr double kUsualWidth = 0.98;
constexpr double kLeastNear = 1e-3;  // RasterView takes no less

// The value below which the fraction `share` of the values lie. Needs at least one value.
float quantile(std::vector<float> values, double share) {
    const auto place = static_cast<std::ptrdiff_t>(std::lround(share * double(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

// The box of the centres in the world, without the fraction `stray` of them at either side along each axis.
Box boxOfCentres(const splat::Splats& splats, double stray) {
    if (stray <= 0.0) return splat::boundingBox(splats);
    Box box;
    std::vector<float> along(splats.size());
    for (int axis = 0; axis < 3; ++axis) {
        std::transform(splats.position.begin(), splats.position.end(), along.begin(),
                       [&](const glm::vec3& p) { return p[axis]; });
        box.low[axis] = splats.originMm[axis] + double(quantile(along, stray));
        box.high[axis] = splats.originMm[axis] + double(quantile(along, 1.0 - stray));
    }
    return box;
}

// The box around all visible splats of the model.
Box boxOf(const splat::Splats& splats, double stray) {
    if (splats.size() == 0) return {.low = splats.originMm - 1.0, .high = splats.originMm + 1.0};
    Box box = boxOfCentres(splats, stray);
    std::vector<float> widths(splats.size());
    std::transform(splats.logScale.begin(), splats.logScale.end(), widths.begin(), [](const glm::vec3& s) {
        return std::min(std::max({s.x, s.y, s.z}), splat::kMaxLogScale);
    });
    // A high percentile of the widths, not the largest: with one huge stray splat the others would be too
    // small to see.
    const double beyond = kDeviations * std::exp(double(quantile(std::move(widths), kUsualWidth)));
    return {.low = box.low - beyond, .high = box.high + beyond};
}

Result<SplatCamera> cameraFrom(const Box& box, ViewDirection from, std::string name, const glm::ivec2& sizePx,
                               double usualNear) {
    const Camera camera = frameBox(box, from, kFovDeg, double(sizePx.x) / sizePx.y);
    const double distance = glm::distance(camera.positionMm, camera.targetMm);
    MACULA_TRY(const splat::RasterView view,
               splat::rasterView(camera, sizePx, glm::dvec3(0.0),
                                 std::clamp(0.01 * distance, kLeastNear, usualNear)));
    return SplatCamera{std::move(name), view};
}

}  // namespace

double usualNearOf(const splat::Splats& splats) {
    constexpr double kForeignNear = 0.2;
    return splats.axes == splat::Axes::unknown ? kForeignNear : splat::RasterView{}.nearMm;
}

Result<std::vector<SplatCamera>> framedCameras(const splat::Splats& splats,
                                               std::span<const ViewDirection> from,
                                               const glm::ivec2& sizePx) {
    const bool isPatient = splats.axes == splat::Axes::patientLps;
    if (!isPatient && !from.empty())
        return Error{
            ErrorCode::usage,
            Text("This model was made elsewhere and does not say where the patient's left or front is."),
            {},
            Text("Give --camera or --cameras, or none of these to look along its own +z.")};
    std::vector<SplatCamera> cameras;
    const double near = usualNearOf(splats);
    if (!isPatient) {
        // The view from inferior is the one along +z with -y up, whatever the axes mean.
        MACULA_TRY(SplatCamera camera,
                   cameraFrom(boxOf(splats, kStray), ViewDirection::inferior, "along-z", sizePx, near));
        cameras.push_back(std::move(camera));
        return cameras;
    }
    const Box box = boxOf(splats, 0.0);
    const std::vector<ViewDirection> front{ViewDirection::anterior};
    for (const ViewDirection direction : from.empty() ? std::span<const ViewDirection>(front) : from) {
        MACULA_TRY(SplatCamera camera, cameraFrom(box, direction, nameOf(direction), sizePx, near));
        cameras.push_back(std::move(camera));
    }
    return cameras;
}

}  // namespace macula::scene
