#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/quality/quality_controller.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

#include "base/check.h"
#include "base/log.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/quality/quality_control.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

namespace {

double secondsOfClock() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Noise falls with the square root of the number of samples.
double fractionOf(const live::FrameShown& frame) {
    const double byNoise = frame.noise > 0.0 ? std::pow(ConvergeNow::kNoiseTarget / frame.noise, 2.0) : 0.0;
    const double bySamples = double(frame.samplesPerPixel) / double(ConvergeNow::kSampleLimit);
    return std::clamp(std::max(byNoise, bySamples), 0.0, 1.0);
}

QString percentText(double share) {
    return ConvergeNow::tr("%L1 %").arg(100.0 * share, 0, 'f', 2);
}

live::QualityFront knownFront() {
    auto front = live::builtInQualityFront();
    MACULA_CHECK(front.ok());  // a test reads the same file
    return *std::move(front);
}

}  // namespace

ConvergeNow::ConvergeNow(const RestGoal& usual, QObject* parent, std::function<double()> nowS)
    : QObject(parent), usual_(usual), nowS_(nowS ? std::move(nowS) : secondsOfClock) {}

void ConvergeNow::start() {
    if (std::exchange(isRunning_, true)) return;
    startedS_ = nowS_();
    startedAt_ = -1.0;
    Q_EMIT began();
    Q_EMIT goalChanged({.sampleLimit = std::max(kSampleLimit, usual_.sampleLimit),
                        .noiseTarget = kNoiseTarget,
                        .convergesNow = true});
}

void ConvergeNow::cancel() {
    if (isRunning_) end({});
}

void ConvergeNow::onOtherPicture() {
    if (isRunning_) end(tr("Converging was stopped: another picture is shown."));
}

void ConvergeNow::end(const QString& told) {
    isRunning_ = false;
    Q_EMIT goalChanged(usual_);
    Q_EMIT ended(told);
}

void ConvergeNow::onFrame(const live::FrameShown& frame) {
    // Frames of the earlier goal still arrive for a while.
    if (!isRunning_ || frame.noiseTarget != kNoiseTarget) return;
    if (frame.picture != live::OnScreen::traced && frame.picture != live::OnScreen::fading) return;
    if (frame.stage == live::Stage::converged) {
        const bool isKnown = std::isfinite(frame.noise) && frame.noise > 0.0;
        return end(isKnown ? tr("The picture is final: %Ln samples, noise %1 of black to white.", nullptr,
                                int(frame.samplesPerPixel))
                                 .arg(percentText(frame.noise))
                           : tr("The picture is final: %Ln samples.", nullptr, int(frame.samplesPerPixel)));
    }
    const double fraction = fractionOf(frame);
    if (startedAt_ < 0.0 && std::isfinite(frame.noise)) {
        startedAt_ = fraction;
        startedS_ = nowS_();
    }
    Q_EMIT progressed(stageOf(frame.noise, fraction), fraction);
}

QString ConvergeNow::stageOf(double noise, double fraction) const {
    QString stage = tr("Converging");
    if (std::isfinite(noise)) stage += tr(", noise %1").arg(percentText(noise));
    if (startedAt_ < 0.0 || !(fraction > startedAt_)) return stage;
    const double leftS = (nowS_() - startedS_) * (1.0 - fraction) / (fraction - startedAt_);
    if (leftS < 90.0) return stage + tr(", %1 s left").arg(std::ceil(leftS), 0, 'f', 0);
    if (leftS < 6000.0) return stage + tr(", %1 min left").arg(std::ceil(leftS / 60.0), 0, 'f', 0);
    return stage + tr(", %1 h left").arg(std::ceil(leftS / 3600.0), 0, 'f', 0);
}

QualityController::QualityController(const WindowContext& context, std::uint32_t sampleLimit)
    : QObject(&context.window),
      context_(context),
      control_(new QualityControl(knownFront(), &context.window)),
      calibration_(this, {.ended = [this](const auto& measured) { onCalibrated(measured); }}),
      converge_(new ConvergeNow({.sampleLimit = sampleLimit}, this)),
      bar_(new WorkBar) {
    connect(control_, &QualityControl::changed, &context_.viewport, &Viewport::setLiveQuality);
    connect(&context_.viewport, &Viewport::resized, this, &QualityController::showCost);
    connect(&context_.session, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (context_.session.state().settings.bounces != before.settings.bounces) showCost();
    });
    connectConverging();
}

void QualityController::connectConverging() {
    connect(converge_, &ConvergeNow::goalChanged, &context_.viewport, &Viewport::setRestGoal);
    connect(converge_, &ConvergeNow::began, this, [this] {
        context_.notifications.hide();
        bar_->begin(tr("Converging"));
        stop_->setEnabled(true);
    });
    connect(converge_, &ConvergeNow::progressed, bar_, &WorkBar::setProgress);
    connect(bar_, &WorkBar::cancelClicked, converge_, &ConvergeNow::cancel);
    connect(converge_, &ConvergeNow::ended, this, [this](const QString& told) {
        bar_->hide();
        stop_->setEnabled(false);
        if (!told.isEmpty()) context_.notifications.showNote(told);
    });
    connect(&context_.viewport, &Viewport::otherPictureWanted, converge_, &ConvergeNow::onOtherPicture);
    connect(&context_.notifications, &Notifications::failed, converge_, &ConvergeNow::cancel);
}

void QualityController::onFrame(const live::FrameShown& frame) {
    converge_->onFrame(frame);
}

void QualityController::addActions(QMenu& view) {
    view.addSeparator();
    const auto add = [&](const QString& title, const char* name, const QKeySequence& key, auto does) {
        QAction* action = view.addAction(title);
        action->setObjectName(QLatin1String(name));
        action->setShortcut(key);
        connect(action, &QAction::triggered, this, does);
        return action;
    };
    add(tr("Frames in Motion: Faster"), "quality-faster", QKeySequence(Qt::CTRL | Qt::Key_BracketLeft),
        [this] { control_->step(-1); })
        ->setToolTip(tr("Less is traced while a hand moves"));
    add(tr("Frames in Motion: More Accurate"), "quality-better",
        QKeySequence(Qt::CTRL | Qt::Key_BracketRight), [this] { control_->step(1); })
        ->setToolTip(tr("More is traced while a hand moves"));
    add(tr("Converge &Now"), "converge-now", keyOf(KeyAction::convergeNow), [this] {
        convergeNow();
    })->setToolTip(tr("Trace the picture at rest until it is final, with half of the usual noise"));
    stop_ = add(tr("Stop Converging"), "stop-converging", QKeySequence(Qt::Key_Escape),
                [this] { converge_->cancel(); });
    stop_->setEnabled(false);
}

void QualityController::convergeNow() {
    if (context_.notifications.refuseUnless(context_.session.hasStudy(),
                                            tr("There is no picture to converge yet.")))
        converge_->start();
}

void QualityController::showCost() {
    const QSize pixels = context_.viewport.pictureSize();
    control_->setView({.sizePx = {pixels.width(), pixels.height()},
                       .verticalFovDeg = context_.viewport.camera().verticalFovDeg});
    control_->setBounces(context_.session.state().settings.bounces);
}

// Runs in the background, on its own device.
void QualityController::calibrate(const std::optional<std::filesystem::path>& folder) {
    calibration_.start([device = context_.device, folder](Progress& progress) -> Result<live::Calibration> {
        try {
            return live::calibrationOf(device, folder, false, progress);
        } catch (const std::exception&) {
            return Error{ErrorCode::outOfMemory, Text("There is not enough memory to measure."), {}, {}};
        }
    });
}

// Without a measurement, the control shows only errors, and no times.
void QualityController::onCalibrated(const Result<live::Calibration>& measured) {
    if (!measured)
        return log::warning("This machine could not be measured: {}", measured.error().message.english());
    control_->setSlowness(measured->traceMs / control_->front().calibrationMs);
}

}  // namespace macula::viewer
