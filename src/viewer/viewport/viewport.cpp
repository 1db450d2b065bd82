#include "viewer/viewport/viewport.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "base/log.h"
#include "live/frame/window_screen.h"
#include "viewer/jobs/post.h"
#include "viewer/keys/keys.h"

namespace macula::viewer {

Result<gpu::Instance> createInstanceForWindows() {
    const QString platform = QGuiApplication::platformName();
    gpu::InstanceOptions options;
    options.extensions.push_back(VK_KHR_SURFACE_EXTENSION_NAME);
    if (platform == QLatin1String("xcb")) {
        options.extensions.push_back("VK_KHR_xcb_surface");
    } else if (platform.startsWith(QLatin1String("wayland"))) {
        options.extensions.push_back("VK_KHR_wayland_surface");
    } else {
        return Error{ErrorCode::deviceNotUsable, Text("This kind of display cannot show Vulkan pictures."),
                     platform.toStdString(), Text("Use an X11 or a Wayland display, or `macula render`.")};
    }
    return gpu::Instance::create(options);
}

Viewport::Viewport(gpu::Instance instance, std::string preferredDevice,
                   std::shared_ptr<live::SceneKeeper> keeper, QWidget* parent)
    : QWidget(parent),
      window_(new VulkanWindow(&vulkan_)),
      camera_([this] { return aspect(); }),
      hand_({*window_, camera_, tools_}, {.hasStudy = [this] { return input_.volume != nullptr; },
                                          .isProjection = [this] { return showsProjection(); },
                                          .isOnScreen = [this] { return isCameraOnScreen(); },
                                          .geometry = [this] { return geometry(); }}),
      keys_(camera_, [this] { hand_.nudge(); }) {
    vulkan_.setVkInstance(instance.handle());
    vulkan_.setFlags(QVulkanInstance::NoDebugOutputRedirect);  // pipeline/gpu listens already
    if (!vulkan_.create()) log::error("Qt did not adopt the Vulkan instance: {}", int(vulkan_.errorCode()));

    container_ = std::make_unique<WindowContainer>(*window_, *this);
    connectWindow();
    connectHand();

    // Events reach this thread through its queue; Qt drops those that arrive after this widget is destroyed.
    renderThread_ = std::make_unique<live::RenderThread>(
        std::move(instance), std::move(preferredDevice), std::move(keeper), [this](live::RenderEvent event) {
            post(this, [this, event = std::move(event)] { onRendered(event); });
        });
}

Viewport::~Viewport() {
    container_.reset();  // with its window, which first takes its surface from the render thread
    renderThread_.reset();
}

void Viewport::connectWindow() {
    connect(window_, &VulkanWindow::surfaceReady, this, [this] {
        input_.place = std::make_shared<const live::WindowPlace>(window_->surface());
        publish();
    });
    connect(window_, &VulkanWindow::surfaceGoing, this, [this] {
        input_.place = nullptr;
        renderThread_->releaseScreen();
    });
    connect(window_, &VulkanWindow::surfaceFailed, this, [this] {
        Q_EMIT rendered(live::RenderFailure{.error = {ErrorCode::deviceNotUsable,
                                                      Text("The window cannot show Vulkan pictures."),
                                                      {},
                                                      Text("Install a Vulkan driver for this display.")}});
    });
    connect(window_, &VulkanWindow::exposed, this, [this] {
        ++input_.exposures;
        publish();
    });
    connect(window_, &VulkanWindow::hidden, this, &Viewport::publish);
    connect(window_, &VulkanWindow::resized, this, [this] {
        camera_.refit();  // an untouched view keeps fitting the window
        publish();
        Q_EMIT resized();
        Q_EMIT otherPictureWanted();
    });
    connect(window_, &VulkanWindow::doubleClicked, this, [this](QPointF place) {
        if (!sideAt(place)) Q_EMIT doubleClicked(place);  // a click on the cube means nothing behind it
    });
    connect(window_, &VulkanWindow::clicked, this, [this](QPointF place) {
        if (const auto side = sideAt(place)) camera_.set(scene::turnedTo(camera(), *side));
    });
    connect(window_, &VulkanWindow::keyPressed, this, [this](QKeyEvent* event) {
        if (!container_->moveFocus(*event) && !handleKey(*event)) Q_EMIT keyNotHandled(event);
    });
    connect(window_, &VulkanWindow::dropped, this, &Viewport::dropped);
}

void Viewport::connectHand() {
    connect(&camera_, &PictureCamera::changed, this, &Viewport::publishChange);
    connect(&camera_, &PictureCamera::parallelChanged, this, &Viewport::parallelChanged);
    connect(&camera_, &PictureCamera::moved, this, [this] {
        if (!hand_.isMoving()) Q_EMIT cameraRested();
    });
    connect(&hand_, &PictureHand::rested, this, [this] {
        publish();
        Q_EMIT cameraRested();
    });
    connect(&hand_, &PictureHand::windowDragged, this, &Viewport::windowDragged);
    connect(&hand_, &PictureHand::transferDragged, this, &Viewport::transferDragged);
}

void Viewport::setStudy(std::shared_ptr<const Volume> volume, std::vector<std::string> names,
                        scene::Drawing drawing, std::optional<ViewDirection> from) {
    window_->endDrag();  // a held handle or curve belongs to the earlier study
    ++input_.study;
    shown_.reset();
    names_ = std::move(names);
    open_ = std::move(volume);
    input_.volume = open_;
    input_.drawing = std::move(drawing);
    takePhase({});
    camera_.setVolume(input_.volume);
    camera_.setProjection(showsProjection());
    input_.background = scene::backgroundInWindow(input_.drawing);
    setLetters({});
    if (input_.volume) {
        camera_.showFirst(from);
    } else {
        publishChange();
    }
}

void Viewport::setDrawing(scene::Drawing drawing) {
    if (drawing == input_.drawing) return;
    input_.drawing = std::move(drawing);
    camera_.setProjection(showsProjection());
    input_.background = scene::backgroundInWindow(input_.drawing);
    publishChange();
}

void Viewport::takePhase(const PhaseIn3d& phase) {
    phase_ = phase;
    input_.phase = phase.number;
    input_.volume = phase.volume ? phase.volume : open_;
    input_.playsPhases = phase.isPlaying;
    input_.phases = phase.phases;
    input_.learnsPhases = phase.learns;
    overlay_.setNames(phase.names.empty() ? names_ : phase.names);
    overlay_.setNotes(phase.notes);
}

void Viewport::setPhase(const PhaseIn3d& phase, scene::Drawing drawing) {
    if (!open_ || (phase == phase_ && drawing == input_.drawing)) return;
    const bool isOther = phase.volume != phase_.volume || drawing != input_.drawing;
    takePhase(phase);
    input_.drawing = std::move(drawing);
    input_.background = scene::backgroundInWindow(input_.drawing);
    isOther ? publishChange() : void(publish());
}

void Viewport::showNames(bool shown) {
    if (!overlay_.showNames(shown)) return;
    publish();
    Q_EMIT namesToggled(shown);
}

void Viewport::showMarks(bool shown) {
    if (overlay_.showCube(shown)) publish();
}

void Viewport::setSampleLimit(std::uint32_t samplesPerPixel) {
    input_.sampleLimit = samplesPerPixel;
    publish();
}

void Viewport::setRestGoal(const RestGoal& goal) {
    input_.sampleLimit = goal.sampleLimit;
    input_.noiseTarget = goal.noiseTarget;
    input_.convergesNow = goal.convergesNow;
    publish();
}

void Viewport::setLiveQuality(const live::LiveQuality& quality) {
    input_.live = quality;
    publish();
}

std::uint64_t Viewport::askForModel(bool withTraining) {
    ++input_.modelRequests;
    input_.requestsTraining = withTraining;
    publish();
    return input_.modelRequests;
}

void Viewport::setGazeFollowsPointer(bool follows) {
    gazeFollowsPointer_ = follows;
    publish();
}

void Viewport::setPictureSizeHint(QSize pixels) {
    container_->setSizeHint(pixels);
}

void Viewport::setUsesModel(bool uses) {
    input_.usesModel = uses;
    publish();
}

std::optional<MarkedPicture> Viewport::pictureOnScreen() const {
    if (!shown_ || shown_->study != input_.study) return std::nullopt;
    return markedPicture(shown_->camera);
}

MarkedPicture Viewport::markedPicture(const Camera& camera) const {
    return {camera, window_->pixels(), window_->devicePixelRatio(), isCalibrated()};
}

void Viewport::publishChange() {
    container_->widget().show();
    lastChange_ = publish();
    Q_EMIT otherPictureWanted();
}

std::uint64_t Viewport::publish() {
    const QSize pixels = window_->pixels();
    input_.width = pixels.width();
    input_.height = pixels.height();
    input_.visible = window_->isExposed();
    input_.camera = toCamera(camera());
    input_.letters = edgeLetters(camera());
    input_.text = overlay_.text(input_.drawing, pixels, window_->devicePixelRatio());
    updateMarks();
    input_.gaze = gazeFollowsPointer_ ? hand_.pointedAt() : glm::dvec2(0.0);
    input_.interacting = hand_.isMoving() || phase_.isPlaying;
    return renderThread_->publish(input_);
}

void Viewport::updateMarks() {
    if (input_.volume) {
        input_.marks = overlay_.marks(markedPicture(input_.camera), tools_.marks(geometry()), input_.letters);
    } else {
        input_.marks = overlay_.marks(std::nullopt, {}, input_.letters);
    }
}

bool Viewport::isCalibrated() const {
    return !input_.volume || input_.volume->provenance().isCalibrated;
}

double Viewport::aspect() const {
    return window_->height() > 0 ? double(window_->width()) / window_->height() : 1.0;
}

// The letters follow the picture, not the camera: while the next picture is made, the one on screen still has
// its sides where they were.
void Viewport::onRendered(const live::RenderEvent& event) {
    if (const auto* frame = std::get_if<live::FrameShown>(&event)) {
        if (frame->study != input_.study) return;  // that picture is being removed
        setLetters(frame->letters);
        shown_ = *frame;
    } else if (std::holds_alternative<live::PictureRemoved>(event)) {
        shown_.reset();
    } else if (const auto* outline = std::get_if<live::OutlineFound>(&event)) {
        const bool isOfOpen = outline->phase == 0 || (!phase_.volume && outline->phase == phase_.number);
        if (outline->study == input_.study && isOfOpen) camera_.takeOutline(outline->pointsMm);
    } else if (const auto* failure = std::get_if<live::RenderFailure>(&event)) {
        setLetters({});
        shown_.reset();
        // A picture that stays on screen after an error would pass for the wanted one: hides it, unless a
        // newer input will remove it.
        if (failure->pictureRemains && failure->inputSequence >= lastChange_) container_->widget().hide();
    }
    Q_EMIT rendered(event);
}

void Viewport::setLetters(const scene::EdgeLetters& letters) {
    letters_ = letters;
    container_->describeSides(letters);
}

// The cube on screen belongs to the picture, not to the newest camera.
std::optional<ViewDirection> Viewport::sideAt(QPointF place) const {
    const auto picture = overlay_.showsCube() ? pictureOnScreen() : std::nullopt;
    return picture ? cubeSideAt(*picture, place) : std::nullopt;
}

bool Viewport::handleKey(const QKeyEvent& event) {
    if (keys_.roll(event)) return true;
    const Qt::KeyboardModifiers others = event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    if (others != Qt::NoModifier) return false;
    if (keys_.move(event)) return true;
    const std::optional<KeyAction> action = actionOf(event);
    if (action == KeyAction::names) return showNames(!namesShown()), true;
    if (action == KeyAction::marks) return Q_EMIT marksAsked(!overlay_.showsCube()), true;
    if (keys_.look(event)) return true;
    if (event.key() != Qt::Key_Escape || !tools_.isHolding()) return false;
    tools_.giveUp();
    return true;
}

void Viewport::setTools(std::vector<PictureTool*> tools) {
    tools_.set(std::move(tools));
    updateToolMarks();
}

void Viewport::updateToolMarks() {
    const auto before = input_.marks;
    updateMarks();
    if (input_.marks != before) publish();
}

PictureGeometry Viewport::geometry() const {
    return {.camera = toCamera(camera()),
            .aspect = aspect(),
            .sizePx = {std::max(window_->width(), 1), std::max(window_->height(), 1)}};
}

}  // namespace macula::viewer
