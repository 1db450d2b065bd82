#include "viewer/viewport/viewport.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include "base/log.h"
#include "live/frame/window_screen.h"
#include "scene/camera/usual_view.h"
#include "viewer/jobs/post.h"
#include "viewer/overlay/painted_text.h"
#include "viewer/overlay/side_letters.h"
#include "viewer/status/status_texts.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr double kVerticalFovDeg = 30.0;
constexpr std::chrono::milliseconds kNudgeLasts{250};
constexpr QSize kSmallestPicture{160, 120};

}  // namespace

Result<gpu::Instance> createInstanceForWindows() {
    const QString platform = QGuiApplication::platformName();
    gpu::InstanceOptions options;
    options.extensions.push_back(VK_KHR_SURFACE_EXTENSION_NAME);
    if (platform == QLatin1String("xcb")) {
        options.extensions.push_back("VK_KHR_xcb_surface");
    } else if (platform.startsWith(QLatin1String("wayland"))) {
        options.extensions.push_back("VK_KHR_wayland_surface");
    } else {
        return Error{ErrorCode::deviceNotUsable, "This kind of display cannot show Vulkan pictures.",
                     platform.toStdString(), "Use an X11 or a Wayland display, or `macula render`."};
    }
    return gpu::Instance::create(options);
}

Viewport::Viewport(gpu::Instance instance, std::string preferredDevice,
                   std::shared_ptr<live::SceneKeeper> keeper, QWidget* parent)
    : QWidget(parent), window_(new VulkanWindow(&vulkan_)) {
    vulkan_.setVkInstance(instance.handle());
    vulkan_.setFlags(QVulkanInstance::NoDebugOutputRedirect);  // pipeline/gpu listens already
    if (!vulkan_.create()) log::error("Qt did not adopt the Vulkan instance: {}", int(vulkan_.errorCode()));

    layOut();
    connectWindow();
    nudgeEnds_.setSingleShot(true);
    nudgeEnds_.setInterval(kNudgeLasts);
    connect(&nudgeEnds_, &QTimer::timeout, this, [this] {
        publish();
        emit cameraRested();
    });

    // The events cross to this thread through its queue; those that come after this widget is gone are
    // dropped by Qt.
    renderThread_ = std::make_unique<live::RenderThread>(
        std::move(instance), std::move(preferredDevice), std::move(keeper), [this](live::RenderEvent event) {
            post(this, [this, event = std::move(event)] { onRendered(event); });
        });
}

Viewport::~Viewport() {
    delete container_;  // with the window, which takes its surface back from the render thread first
    renderThread_.reset();
}

void Viewport::layOut() {
    container_ = QWidget::createWindowContainer(window_, this);
    container_->setFocusPolicy(Qt::StrongFocus);
    container_->setObjectName(QStringLiteral("volume"));
    container_->setAccessibleName(tr("The volume in 3D"));
    container_->setToolTip(
        tr("Left drag or arrows walk around the patient, the wheel goes closer; sizes are in mm"));
    container_->setMinimumSize(kSmallestPicture);
    QSizePolicy policy = container_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    container_->setSizePolicy(policy);
    setFocusProxy(container_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(container_);
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
        emit rendered(live::RenderFailure{.error = {ErrorCode::deviceNotUsable,
                                                    "The window cannot show Vulkan pictures.",
                                                    {},
                                                    "Install a Vulkan driver for this display."}});
    });
    connect(window_, &VulkanWindow::exposed, this, [this] {
        ++input_.exposures;
        publish();
    });
    connect(window_, &VulkanWindow::hidden, this, &Viewport::publish);
    connect(window_, &VulkanWindow::resized, this, [this] {
        // A view nobody has touched goes on fitting the window.
        if (untouched_ && input_.volume) {
            camera_ = scene::fitted(scene::turnedTo(camera_, framedFrom_), outlineMm(), aspect());
        }
        publish();
        emit resized();
        emit otherPictureWanted();
    });
    connect(window_, &VulkanWindow::pointed, this, &Viewport::onPointed);
    connect(window_, &VulkanWindow::doubleClicked, this, [this](QPointF place) {
        if (!sideAt(place)) emit doubleClicked(place);  // nothing is meant behind the cube
    });
    connect(window_, &VulkanWindow::dragBegan, this, [this] { dragging_ = true; });
    connect(window_, &VulkanWindow::dragged, this, &Viewport::applyDrag);
    connect(window_, &VulkanWindow::dragEnded, this, [this] {
        endHold();
        dragging_ = false;
        publish();
        emit cameraRested();
    });
    window_->setGrab([this](QPointF place, bool withShift) { return grab(place, withShift); });
    connect(window_, &VulkanWindow::toolMoved, this, [this](QPointF place, bool withShift) {
        if (holder_ != nullptr) holder_->move(placeAt(place, withShift));
    });
    connect(window_, &VulkanWindow::toolReleased, this, [this](QPointF place, bool withShift) {
        if (holder_ != nullptr) std::exchange(holder_, nullptr)->release(placeAt(place, withShift));
    });
    connect(window_, &VulkanWindow::wheelTurned, this, &Viewport::onWheel);
    connect(window_, &VulkanWindow::flyTurned, this, &Viewport::fly);
    connect(window_, &VulkanWindow::clicked, this, &Viewport::turnToSide);
    connect(window_, &VulkanWindow::keyPressed, this, [this](QKeyEvent* event) {
        if (!moveFocus(*event) && !handleKey(*event)) emit keyNotHandled(event);
    });
    connect(window_, &VulkanWindow::dropped, this, &Viewport::dropped);
}

void Viewport::setStudy(std::shared_ptr<const Volume> volume, std::vector<std::string> names,
                        scene::Drawing drawing, std::optional<ViewDirection> from) {
    window_->endDrag();  // what a hand holds, handle or transfer function, is of the study before
    ++input_.study;
    outline_.reset();
    shown_.reset();
    names_ = std::move(names);
    input_.volume = std::move(volume);
    input_.drawing = std::move(drawing);
    input_.background = scene::backgroundInWindow(input_.drawing);
    setLetters({});
    if (input_.volume) {
        firstFrom_ = scene::firstDirection(from, *input_.volume);
        showFrom(firstFrom_);
    } else {
        publishChange();
    }
}

void Viewport::setDrawing(scene::Drawing drawing) {
    if (drawing == input_.drawing) return;
    input_.drawing = std::move(drawing);
    input_.background = scene::backgroundInWindow(input_.drawing);
    publishChange();
}

void Viewport::showNames(bool shown) {
    if (shown == namesShown_) return;
    namesShown_ = shown;
    publish();
    emit namesToggled(shown);
}

void Viewport::showMarks(bool shown) {
    if (shown == marksShown_) return;
    marksShown_ = shown;
    publish();
}

void Viewport::setParallel(bool isParallel) {
    if (isParallel == camera_.isParallel) return;
    const bool untouched = untouched_;
    scene::OrbitCamera camera = camera_;
    camera.isParallel = isParallel;
    setCamera(camera);
    untouched_ = untouched;
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

void Viewport::setUsesModel(bool uses) {
    input_.usesModel = uses;
    publish();
}

void Viewport::setPictureSizeHint(QSize pixels) {
    container_->setMinimumSize(pixels / devicePixelRatioF());
    // Until the window is shown, Qt invalidates only the layout that holds the widget, and none above it.
    for (QWidget* above = this; above != nullptr; above = above->parentWidget()) {
        if (above->layout() != nullptr) above->layout()->invalidate();
        if (auto* splitter = qobject_cast<QSplitter*>(above)) splitter->refresh();
        above->updateGeometry();
    }
    // Once the window has taken it over, the user may make it smaller again.
    QTimer::singleShot(0, container_,
                       [container = container_] { container->setMinimumSize(kSmallestPicture); });
}

void Viewport::showFrom(ViewDirection from) {
    if (!input_.volume) return;
    framedFrom_ = from;
    scene::OrbitCamera camera = scene::turnedTo(camera_, framedFrom_);
    camera.verticalFovDeg = kVerticalFovDeg;
    setCamera(scene::fitted(camera, outlineMm(), aspect()));
    untouched_ = true;
}

void Viewport::showFrom(const Camera& camera) {
    if (!input_.volume) return;
    setCamera(scene::orbitCameraOf(camera));
}

void Viewport::centreOn(const glm::dvec3& mm) {
    if (!input_.volume) return;
    scene::OrbitCamera camera = camera_;
    camera.targetMm = mm;
    setCamera(camera);
}

void Viewport::fit() {
    if (!input_.volume) return;
    setCamera(scene::fitted(camera_, outlineMm(), aspect()));
}

std::optional<MarkedPicture> Viewport::pictureOnScreen() const {
    if (!shown_ || shown_->study != input_.study) return std::nullopt;
    return MarkedPicture{shown_->camera, window_->pixels(), window_->devicePixelRatio(), isCalibrated()};
}

void Viewport::setCamera(const scene::OrbitCamera& camera) {
    const bool wasParallel = std::exchange(camera_, camera).isParallel;
    untouched_ = false;
    publishChange();
    if (camera_.isParallel != wasParallel) emit parallelChanged(camera_.isParallel);
    if (!dragging_ && !nudgeEnds_.isActive()) emit cameraRested();
}

void Viewport::publishChange() {
    container_->show();
    lastChange_ = publish();
    emit otherPictureWanted();
}

std::uint64_t Viewport::publish() {
    const QSize pixels = window_->pixels();
    input_.width = pixels.width();
    input_.height = pixels.height();
    input_.visible = window_->isExposed();
    input_.camera = toCamera(camera_);
    input_.letters = edgeLetters(camera_);
    updateText();
    updateMarks();
    input_.gaze = gazeFollowsPointer_ ? pointedAt_ : glm::dvec2(0.0);
    input_.interacting = dragging_ || nudgeEnds_.isActive();
    return renderThread_->publish(input_);
}

void Viewport::updateText() {
    const LinesOver lines = linesOver(namesShown_ ? names_ : std::vector<std::string>(), input_.drawing);
    const QSize pixels = window_->pixels();
    const double ratio = window_->devicePixelRatio();
    const double fontScale = fontScaleOverPictures();
    if (lines == textLines_ && pixels == textPx_ && ratio == textPixelRatio_ && fontScale == textFontScale_)
        return;
    textLines_ = lines;
    textPx_ = pixels;
    textPixelRatio_ = ratio;
    textFontScale_ = fontScale;
    input_.text = paintText(lines, pixels, ratio);
}

// A few tenths of a millisecond: for each step of a drag.
void Viewport::updateMarks() {
    std::optional<Marked> wanted;
    if (input_.volume) {
        wanted =
            Marked{.picture = {input_.camera, window_->pixels(), window_->devicePixelRatio(), isCalibrated()},
                   .hasCube = marksShown_,
                   .fontScale = fontScaleOverPictures()};
        for (const PictureTool* tool : tools_)
            std::ranges::copy(tool->marks(geometry()), std::back_inserter(wanted->ofTools));
    }
    if (wanted == marked_) return;
    Marked stands = wanted.value_or(Marked{});  // what tools move lies above it
    stands.ofTools = marked_ ? marked_->ofTools : std::vector<ToolMark>();
    const bool isSame = wanted && marked_ && stands == *marked_;
    marked_ = std::move(wanted);
    if (!isSame) standing_ = marked_ ? paintStanding(*marked_) : nullptr;
    input_.marks = marked_ ? withToolMarks(standing_, marked_->ofTools, marked_->picture.pixels,
                                           marked_->picture.pixelRatio)
                           : nullptr;
}

std::shared_ptr<const live::PictureText> Viewport::paintStanding(const Marked& marked) const {
    return withSideLetters(marked.hasCube ? paintCubeAndScale(marked.picture) : nullptr, input_.letters,
                           marked.picture.pixels, marked.picture.pixelRatio);
}

bool Viewport::isCalibrated() const {
    return !input_.volume || input_.volume->provenance().isCalibrated;
}

double Viewport::sceneDiagonalMm() const {
    return input_.volume ? input_.volume->worldBox().diagonal() : 1000.0;
}

// Until it is found, and in projections, all of the volume.
std::vector<glm::dvec3> Viewport::outlineMm() const {
    if (outline_ && !outline_->empty() && !trace::isProjection(input_.drawing.settings.look))
        return *outline_;
    const auto corners = cornersOf(input_.volume->worldBox());
    return {corners.begin(), corners.end()};
}

// The first one moves a camera that nobody has touched. Later ones, of other presets, do not: what is
// compared stays where it is.
void Viewport::onOutline(const live::OutlineFound& found) {
    if (found.study != input_.study || !input_.volume) return;
    const bool isFirst = !outline_;
    outline_ = found.pointsMm;
    if (isFirst && untouched_) showFrom(framedFrom_);
}

double Viewport::aspect() const {
    return window_->height() > 0 ? double(window_->width()) / window_->height() : 1.0;
}

// The letters follow the picture, not the camera: while the next picture is made, the one on screen still has
// its sides where they were.
void Viewport::onRendered(const live::RenderEvent& event) {
    if (const auto* frame = std::get_if<live::FrameShown>(&event)) {
        if (frame->study != input_.study) return;  // that picture is being taken off the screen
        setLetters(frame->letters);
        shown_ = *frame;
    } else if (std::holds_alternative<live::PictureRemoved>(event)) {
        shown_.reset();
    } else if (const auto* outline = std::get_if<live::OutlineFound>(&event)) {
        onOutline(*outline);
    } else if (const auto* failure = std::get_if<live::RenderFailure>(&event)) {
        setLetters({});
        shown_.reset();
        // A picture that stays after an error would be taken for that of what is wanted now; unless something
        // else is wanted by now, which takes it off first.
        if (failure->pictureRemains && failure->inputSequence >= lastChange_) container_->hide();
    }
    emit rendered(event);
}

void Viewport::setLetters(const scene::EdgeLetters& letters) {
    letters_ = letters;
    const auto side = [](const std::string& text) { return QString::fromStdString(text); };
    container_->setAccessibleDescription(
        letters.left.empty()
            ? QString()
            : tr("Sides of the patient at the left, right, top and bottom: %1, %2, %3, %4")
                  .arg(side(letters.left), side(letters.right), side(letters.top), side(letters.bottom)));
}

}  // namespace macula::viewer
