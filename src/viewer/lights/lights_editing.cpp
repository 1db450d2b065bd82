#include "viewer/lights/lights_editing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace macula::viewer {

namespace {

constexpr int kWheelPauseMs = 600;  // turns of the wheel until then are one undo step

Error noLight() {
    return {ErrorCode::usage,
            Text::verbatim(LightsEditing::tr("There is no light that could be changed.").toStdString()),
            {},
            Text::verbatim(LightsEditing::tr("Add a light first.").toStdString())};
}

Error noLights() {
    return {ErrorCode::usage,
            Text::verbatim(LightsEditing::tr("Only Cinematic and Clear have lights.").toStdString()),
            {},
            Text::verbatim(LightsEditing::tr("Open a study, and choose one of these looks.").toStdString())};
}

constexpr double kHitPx = 12.0;  // logical
constexpr int kDotsOfCircle = 60;
constexpr double kSidesDeg = 90.0;
constexpr double kStrongerPerNotch = 1.1;

}  // namespace

LightsEditing::LightsEditing(StudyEditor& session, QObject* parent) : QObject(parent), session_(session) {
    wheelEnds_.setSingleShot(true);
    wheelEnds_.setInterval(kWheelPauseMs);
    // When the timer ends, the user may be dragging something else, whose step must go on.
    connect(&wheelEnds_, &QTimer::timeout, this, [this] {
        if (session_.undoText() == tr("Light")) session_.endDrag();
    });
    connect(&session_, &StudyEditor::studyShown, this, [this] {
        chosen_ = 0;
        Q_EMIT changed();
    });
    connect(&session_, &StudyEditor::changed, this, &LightsEditing::changed);
}

bool LightsEditing::isUsable() const {
    return session_.hasStudy() && trace::isPathTraced(session_.state().settings.look);
}

std::shared_ptr<const trace::LightRig> LightsEditing::rig() const {
    const scene::StudyState& state = session_.state();
    return state.lights ? state.lights : scene::defaultLights(session_.catalogue(), state.settings.look);
}

std::size_t LightsEditing::chosen() const {
    const std::size_t count = rig()->lights.size();
    return count == 0 ? 0 : std::min(chosen_, count - 1);
}

void LightsEditing::choose(std::size_t light) {
    if (std::exchange(chosen_, light) != light) Q_EMIT changed();
}

const trace::SoftLight* LightsEditing::light() const {
    const auto& lights = rig()->lights;  // the catalogue or the state keeps them alive
    return lights.empty() ? nullptr : &lights[chosen()];
}

void LightsEditing::setPanelOpen(bool open) {
    if (std::exchange(isPanelOpen_, open) != open) Q_EMIT changed();
}

std::optional<scene::LightStand> LightsEditing::stand(const Camera& camera) const {
    const Result<CameraBasis> eye = basis(camera);
    if (!eye) return std::nullopt;
    return scene::LightStand{rig()->frame, *eye, session_.state().settings.lightRotationDeg};
}

Result<void> LightsEditing::propose(Result<trace::LightRig> rig, bool isDrag) {
    if (!isUsable()) return noLights();
    if (!rig) return rig.error();
    const auto proposed = std::make_shared<const trace::LightRig>(*std::move(rig));
    const auto edit = [&](scene::StudyState& next) { next.lights = proposed; };
    isDrag ? session_.drag(tr("Light"), edit) : session_.change(tr("Light"), edit);
    return {};
}

Result<void> LightsEditing::drag(const trace::SoftLight& light) {
    wheelEnds_.stop();  // it would end this drag
    if (const trace::SoftLight* now = this->light(); now != nullptr && *now == light) return {};
    return propose(scene::withLight(*rig(), chosen(), light), true);
}

void LightsEditing::strengthen(double factor) {
    const trace::SoftLight* now = light();
    if (now == nullptr || !isUsable()) return;
    trace::SoftLight next = *now;
    next.radiance *= factor;
    if (drag(next)) wheelEnds_.start();
}

Result<void> LightsEditing::add() {
    if (!isUsable()) return noLights();
    const auto stands = stand(camera_);
    trace::SoftLight light{.radiance = 10.0};
    if (stands) {
        const CameraBasis& eye = stands->eye;
        light = scene::shiningFrom(light, eye.up - eye.right - 1.5 * eye.forward, *stands);
    }
    chosen_ = rig()->lights.size();
    return propose(scene::withLightAdded(*rig(), light), false);
}

Result<void> LightsEditing::remove() {
    if (light() == nullptr) return noLight();
    return propose(scene::withoutLight(*rig(), chosen()), false);
}

Result<void> LightsEditing::keepTo(trace::LightFrame frame) {
    const auto stands = stand(camera_);
    if (!stands || !isUsable()) return noLights();
    if (stands->frame == frame) return {};
    return propose(scene::keptTo(*rig(), frame, *stands), false);
}

Result<void> LightsEditing::setSky(double radiance) {
    return propose(scene::withSky(*rig(), radiance), true);
}

void LightsEditing::dragBack(const std::shared_ptr<const trace::LightRig>& lights) {
    session_.drag(tr("Light"), [&](scene::StudyState& next) { next.lights = lights; });
}

void LightsEditing::use(std::shared_ptr<const trace::LightRig> rig) {
    if (!session_.hasStudy()) return;
    session_.change(tr("Lights"), [&](scene::StudyState& next) { next.lights = std::move(rig); });
}

std::vector<glm::dvec2> LightsTool::places(const PictureGeometry& picture) const {
    std::vector<glm::dvec2> places;
    const auto stand = editing_.stand(picture.camera);
    if (!stand || !editing_.hasHandles()) return places;
    for (const trace::SoftLight& light : editing_.rig()->lights)
        places.push_back(scene::placeOnDome(scene::directionTo(light, *stand), stand->eye, picture.aspect));
    return places;
}

std::optional<std::size_t> LightsTool::lightAt(const PicturePlace& place) const {
    const std::vector<glm::dvec2> all = places(place.picture);
    std::optional<std::size_t> nearest;
    double least = kHitPx;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double away = glm::length(0.5 * (all[i] - place.at) * place.picture.sizePx);
        if (!(away <= least)) continue;
        least = away;
        nearest = i;
    }
    return nearest;
}

bool LightsTool::press(const PicturePlace& place) {
    if (place.withShift) return false;
    const auto light = lightAt(place);
    if (!light) return false;
    session_.endDrag();  // ends the undo step of an earlier drag
    editing_.choose(*light);
    grabbed_ = place.at - places(place.picture)[*light];
    pressedAt_ = place.at;
    return true;
}

void LightsTool::move(const PicturePlace& place) {
    const trace::SoftLight* light = editing_.light();
    const auto stand = editing_.stand(place.picture.camera);
    if (!grabbed_ || light == nullptr || !stand) return;
    const glm::dvec3 direction =
        scene::directionOnDome(place.at - *grabbed_, stand->eye, place.picture.aspect);
    // A refused move leaves the light where it is.
    [[maybe_unused]] const Result<void> moved = editing_.drag(scene::shiningFrom(*light, direction, *stand));
}

// A click that only chooses a light must not move it.
void LightsTool::release(const PicturePlace& place) {
    if (place.at != pressedAt_) move(place);
    giveUp();
}

// Keeps the drag so far: a person can undo it.
void LightsTool::giveUp() {
    grabbed_.reset();
    session_.endDrag();
}

std::optional<Qt::CursorShape> LightsTool::point(const PicturePlace& place) {
    return lightAt(place) ? std::optional(Qt::SizeAllCursor) : std::nullopt;
}

bool LightsTool::turnWheel(double notches, const PictureGeometry& /*picture*/) {
    if (!editing_.hasHandles() || editing_.light() == nullptr) return false;
    editing_.strengthen(std::pow(kStrongerPerNotch, notches));
    return true;
}

std::vector<ToolMark> LightsTool::marks(const PictureGeometry& picture) const {
    std::vector<ToolMark> marks;
    if (!editing_.hasHandles()) return marks;
    for (int i = 0; i < kDotsOfCircle; ++i)
        marks.push_back({.kind = MarkKind::dot,
                         .place = scene::circleOnDome(kSidesDeg, 2.0 * std::numbers::pi * i / kDotsOfCircle,
                                                      picture.aspect)});
    const std::vector<glm::dvec2> all = places(picture);
    for (std::size_t i = 0; i < all.size(); ++i)
        marks.push_back(
            {.kind = i == editing_.chosen() ? MarkKind::heldHandle : MarkKind::freeHandle, .place = all[i]});
    return marks;
}

}  // namespace macula::viewer
