#include "viewer/lights/lights_editing.h"

#include <algorithm>
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

}  // namespace macula::viewer
