#include "xr/eyes.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace macula::xr {

namespace {

// Distance of the camera's target, around which a person may turn.
constexpr double kTargetMm = 500.0;
constexpr double kRounding = 1e-6;     // of a pixel
constexpr double kMostTangent = 11.4;  // of a little less than half of 170 degrees

constexpr double kFarthestM = 1e4;
constexpr double kTurnError = 0.01;  // of a quaternion's length, which should be 1

// The field from one side to the other, in whole pixels from straight ahead.
struct Span {
    int first = 0;
    int last = 0;
    int pixels() const { return last - first; }
};
Span spanOf(double low, double high, double pitch) {
    return {static_cast<int>(std::floor(low / pitch + kRounding)),
            static_cast<int>(std::ceil(high / pitch - kRounding))};
}

// The smallest pixel pitch (a tangent) with which the field has at most `most` pixels.
double pitchOf(double low, double high, int most) {
    const double exact = (high - low) / most;
    return spanOf(low, high, exact).pixels() <= most ? exact : (high - low) / (most - 1);
}

Camera cameraAt(const Pose& pose, const glm::dmat4& worldFromStage, double halfHeightTangent) {
    const glm::dmat4 worldFromEye = worldFromStage * stageFromPose(pose);
    const glm::dvec3 ahead = glm::normalize(transformVector(worldFromEye, {0.0, 0.0, -1.0}));
    Camera camera;
    camera.positionMm = transformPoint(worldFromEye, glm::dvec3(0.0));
    camera.targetMm = camera.positionMm + kTargetMm * ahead;
    camera.up = glm::normalize(transformVector(worldFromEye, {0.0, 1.0, 0.0}));
    camera.verticalFovDeg = glm::degrees(2.0 * std::atan(halfHeightTangent));
    return camera;
}

bool isUsable(const Eye& eye) {
    for (const double number : {eye.left, eye.right, eye.up, eye.down})
        if (!std::isfinite(number)) return false;
    const double most =
        std::max({std::abs(eye.left), std::abs(eye.right), std::abs(eye.up), std::abs(eye.down)});
    return eye.left < eye.right && eye.down < eye.up && most < kMostTangent && isUsable(eye.pose);
}

Pose between(std::span<const Eye> eyes) {
    Pose pose = eyes.front().pose;
    if (eyes.size() < 2) return pose;
    pose.positionM = 0.5 * (eyes[0].pose.positionM + eyes[1].pose.positionM);
    pose.orientation = glm::slerp(eyes[0].pose.orientation, eyes[1].pose.orientation, 0.5);
    return pose;
}

}  // namespace

bool isUsable(const Pose& pose) {
    // Comparisons with a NaN are false.
    return glm::length(pose.positionM) < kFarthestM &&
           std::abs(glm::length(pose.orientation) - 1.0) < kTurnError;
}

glm::dmat4 stageFromPose(const Pose& pose) {
    glm::dmat4 matrix = glm::mat4_cast(glm::normalize(pose.orientation));
    matrix[3] = glm::dvec4(pose.positionM, 1.0);
    return matrix;
}

Result<EyePictures> picturesFor(std::span<const Eye> eyes, const glm::dmat4& worldFromStage,
                                const glm::ivec2& mostPx) {
    MACULA_CHECK(!eyes.empty() && mostPx.x >= 2 && mostPx.y >= 2);
    MACULA_CHECK(glm::determinant(glm::dmat3(worldFromStage)) > 0.0);
    double pitch = 0.0;  // the tangent of a pixel straight ahead
    for (const Eye& eye : eyes) {
        if (!isUsable(eye))
            return Error{ErrorCode::usage,
                         Text("The headset does not say where the eyes are, or what they see."), "",
                         Text("Put the headset on, and restart its software if that does not help.")};
        pitch =
            std::max({pitch, pitchOf(eye.left, eye.right, mostPx.x), pitchOf(-eye.up, -eye.down, mostPx.y)});
    }
    // With the pitch of one eye, another eye may exceed `mostPx` by one pixel.
    const auto fits = [&](const Eye& eye) {
        return spanOf(eye.left, eye.right, pitch).pixels() <= mostPx.x &&
               spanOf(-eye.up, -eye.down, pitch).pixels() <= mostPx.y;
    };
    while (!std::all_of(eyes.begin(), eyes.end(), fits)) pitch *= 1.0 + 0.5 / std::max(mostPx.x, mostPx.y);

    EyePictures pictures;
    glm::ivec2 half(1);  // half the size of the whole picture
    for (const Eye& eye : eyes) {
        const Span across = spanOf(eye.left, eye.right, pitch);
        const Span down = spanOf(-eye.up, -eye.down, pitch);
        half = glm::max(half, glm::ivec2(std::max(std::abs(across.first), std::abs(across.last)),
                                         std::max(std::abs(down.first), std::abs(down.last))));
        EyePicture picture;
        picture.firstPx = {across.first, down.first};
        picture.partPx = {across.pixels(), down.pixels()};
        picture.eye = {eye.pose, across.first * pitch, across.last * pitch, -down.first * pitch,
                       -down.last * pitch};
        pictures.eyes.push_back(picture);
    }
    pictures.sizePx = 2 * half;
    const double halfHeight = half.y * pitch;
    if (!(halfHeight < kMostTangent))
        return Error{ErrorCode::usage, Text("The headset asks for a picture of 170 degrees or more."), "",
                     Text("Restart the software of the headset.")};
    for (EyePicture& picture : pictures.eyes) {
        picture.firstPx += half;
        picture.camera = cameraAt(picture.eye.pose, worldFromStage, halfHeight);
    }
    pictures.centre = cameraAt(between(eyes), worldFromStage, halfHeight);
    return pictures;
}

glm::dvec2 gazeIn(const Camera& camera, const glm::ivec2& sizePx, const glm::dmat4& worldFromStage,
                  const Pose& gaze) {
    const auto axes = basis(camera);
    const glm::dvec3 look = transformVector(worldFromStage * stageFromPose(gaze), glm::dvec3(0.0, 0.0, -1.0));
    if (!axes) return glm::dvec2(0.0);
    const double ahead = glm::dot(look, axes->forward);
    if (!(ahead > 0.0)) return glm::dvec2(0.0);
    const double half = std::tan(0.5 * glm::radians(camera.verticalFovDeg));
    const glm::dvec2 at(glm::dot(look, axes->right) / ahead / (half * sizePx.x / sizePx.y),
                        glm::dot(look, axes->up) / ahead / half);
    return glm::clamp(at, -1.0, 1.0);
}

}  // namespace macula::xr
