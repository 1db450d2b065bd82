#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/quality/quality_controller.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <exception>

#include "base/check.h"
#include "base/log.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/quality/converge_now.h"
#include "viewer/quality/quality_control.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

namespace {

live::QualityFront knownFront() {
    auto front = live::builtInQualityFront();
    MACULA_CHECK(front.ok());  // a test reads the same file
    return *std::move(front);
}

}  // namespace

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
