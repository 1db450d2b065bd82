// Time and error: the quality of frames in motion, and the picture at rest that is traced until it is final.
#include <QAction>
#include <QMenu>
#include <exception>

#include "base/check.h"
#include "base/log.h"
#include "viewer/keys/keys.h"
#include "viewer/quality/converge_now.h"
#include "viewer/quality/quality_control.h"
#include "viewer/slices/own_window_list.h"
#include "viewer/slices/slice_view.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

void MainWindow::makeQuality() {
    const auto front = live::builtInQualityFront();
    MACULA_CHECK(front.ok());  // a test reads it
    quality_ = new QualityControl(*front, this);
    connect(quality_, &QualityControl::changed, viewport_, &Viewport::setLiveQuality);
    connect(viewport_, &Viewport::resized, this, &MainWindow::showCost);

    converge_ = new ConvergeNow({.sampleLimit = options_.sampleLimit}, this);
    converging_ = new WorkBar;
    connect(converge_, &ConvergeNow::goalChanged, viewport_, &Viewport::setRestGoal);
    connect(converge_, &ConvergeNow::began, this, [this] {
        messages_->hide();
        converging_->begin(tr("Converging"));
        stopConverging_->setEnabled(true);
    });
    connect(converge_, &ConvergeNow::progressed, converging_, &WorkBar::setProgress);
    connect(converging_, &WorkBar::cancelClicked, converge_, &ConvergeNow::cancel);
    connect(converge_, &ConvergeNow::ended, this, [this](const QString& told) {
        converging_->hide();
        stopConverging_->setEnabled(false);
        if (!told.isEmpty()) messages_->showNote(told);
    });
    connect(viewport_, &Viewport::otherPictureWanted, converge_, &ConvergeNow::onOtherPicture);
    connect(this, &MainWindow::frameShown, converge_, &ConvergeNow::onFrame);
    connect(this, &MainWindow::failed, converge_, &ConvergeNow::cancel);

    ownWindows_ = new OwnWindowList(options_.sessions, this);
    for (SliceView* pane : slices_) pane->setOwnWindows(ownWindows_);
    connect(ownWindows_, &OwnWindowList::failed, this,
            [this](const Error& error) { messages_->showError(error); });
    if (options_.calibrates) calibrate();
}

void MainWindow::addQualityActions(QMenu& view) {
    view.addSeparator();
    const auto add = [&](const QString& title, const char* name, const QKeySequence& key, auto does) {
        QAction* action = view.addAction(title);
        action->setObjectName(QLatin1String(name));
        action->setShortcut(key);
        connect(action, &QAction::triggered, this, does);
        return action;
    };
    add(tr("Frames in Motion: Faster"), "quality-faster", QKeySequence(Qt::CTRL | Qt::Key_BracketLeft),
        [this] { quality_->step(-1); })
        ->setToolTip(tr("Less is traced while a hand moves"));
    add(tr("Frames in Motion: More Accurate"), "quality-better",
        QKeySequence(Qt::CTRL | Qt::Key_BracketRight), [this] { quality_->step(1); })
        ->setToolTip(tr("More is traced while a hand moves"));
    add(tr("Converge &Now"), "converge-now", keyOf(KeyAction::convergeNow), [this] {
        convergeNow();
    })->setToolTip(tr("Trace the picture at rest until it is final, with half of the usual noise"));
    stopConverging_ = add(tr("Stop Converging"), "stop-converging", QKeySequence(Qt::Key_Escape),
                          [this] { converge_->cancel(); });
    stopConverging_->setEnabled(false);
}

void MainWindow::convergeNow() {
    if (hasPictureFor(tr("There is no picture to converge yet."))) converge_->start();
}

bool MainWindow::hasPictureFor(const QString& what) {
    if (study().volume) return true;
    messages_->showError({ErrorCode::usage, what.toStdString(), {}, tr("Open a study first.").toStdString()});
    return false;
}

void MainWindow::showCost() {
    const QSize pixels = viewport_->pictureSize();
    quality_->setView(
        {.sizePx = {pixels.width(), pixels.height()}, .verticalFovDeg = viewport_->camera().verticalFovDeg});
    quality_->setBounces(session_.state().settings.bounces);
}

// Beside the window, on a device of its own.
void MainWindow::calibrate() {
    calibration_.start([device = options_.device,
                        folder = options_.sessions](Progress& progress) -> Result<live::Calibration> {
        try {
            return live::calibrationOf(device, folder, false, progress);
        } catch (const std::exception&) {
            return Error{ErrorCode::outOfMemory, "There is not enough memory to measure.", {}, {}};
        }
    });
}

// Without it only errors are told, and no times.
void MainWindow::onCalibrated(const Result<live::Calibration>& measured) {
    if (!measured) return log::warning("This machine could not be measured: {}", measured.error().message);
    quality_->setSlowness(measured->traceMs / quality_->front().calibrationMs);
}

}  // namespace macula::viewer
