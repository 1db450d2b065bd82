#include "viewer/driven/stations_script.h"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QImage>
#include <QJsonDocument>
#include <QPixmap>
#include <QScreen>
#include <QTabWidget>
#include <QThreadPool>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <utility>

#include "base/exit_codes.h"
#include "study/open/found_volumes.h"
#include "viewer/clip/scissor_tool.h"
#include "viewer/driven/session_steps.h"
#include "viewer/program/startup.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/slices/slice_view.h"

namespace macula::viewer {

namespace {

constexpr int kPaintedMs = 700;    // panels and dialogs, after they were asked for
constexpr int kGalleryMs = 9'000;  // its small pictures
constexpr int kSecondMs = 120'000;

std::atomic<int> failedPictures{0};

}  // namespace

StationsScript::StationsScript(MainWindow& window, StationsScriptOptions options, QObject* parent)
    : QObject(parent), window_(window), options_(std::move(options)), hand_(window) {
    connect(&window_, &MainWindow::frameShown, this, [this](const live::FrameShown& frame) {
        hasPicture_ = true;
        isConverged_ = frame.stage == live::Stage::converged;
    });
    connect(&window_.viewport(), &Viewport::otherPictureWanted, this, [this] { isConverged_ = false; });
    connect(&window_, &MainWindow::failed, this, [this](const Error& error) { finish(tellError(error)); });
}

bool StationsScript::isAtRest() const {
    return hasPicture_ && isConverged_;
}

// A picture that has not converged by then is taken as it is.
DrivenStep StationsScript::station(const char* name, std::function<void()> begin) const {
    DrivenStep step;
    step.name = QString::fromLatin1(name);
    step.begin = std::move(begin);
    step.isDone = [this] { return isAtRest() && !hand_.isBusy(); };
    step.patienceMs = int(options_.waitSeconds * 1000.0);
    step.restMs = kPaintedMs;
    return step;
}

// Without a picture of its own.
DrivenStep StationsScript::between(std::function<void()> begin, std::function<bool()> isDone) const {
    DrivenStep step;
    step.begin = std::move(begin);
    step.isDone = isDone ? std::move(isDone) : [this] { return !hand_.isBusy(); };
    step.restMs = kPaintedMs;
    return step;
}

std::vector<DrivenStep> StationsScript::steps() {
    std::vector<DrivenStep> all;
    DrivenStep opens = between({}, [this] { return hasPicture_ && window_.hasStudy(); });
    opens.name = QStringLiteral("-opening");
    opens.patienceMs = int(options_.beginSeconds * 1000.0);
    all.push_back(std::move(opens));
    all.push_back(station("open", {}));
    addPanels(all);
    addTools(all);
    addDialogs(all);
    addSecondVolume(all);
    return all;
}

void StationsScript::addPanels(std::vector<DrivenStep>& all) {
    const auto panel = [this, &all](const char* name, const char* dock) {
        all.push_back(station(name, [this, dock] { showPanel(hand_, dock, true); }));
        all.push_back(between([this, dock] { showPanel(hand_, dock, false); }));
    };
    panel("studies", "studies-panel");
    all.push_back(station("presets", [this] { showPanel(hand_, "presets-panel", true); }));
    all.back().restMs = kGalleryMs;
    all.push_back(between([this] { showPanel(hand_, "presets-panel", false); }));
    panel("transfer", "transfer-panel");
    panel("segments", "segments-panel");
}

void StationsScript::addTools(std::vector<DrivenStep>& all) {
    const auto axial = [this]() -> SliceView& { return window_.slices(slices::Orientation::axial); };
    const auto measure = [this, axial](const char* tool, QPointF from, QPointF to) {
        hand_.trigger(tool);
        const QPointF middle = DrivenHand::middleOf(axial());
        const double side = std::min(axial().width(), axial().height());
        hand_.drag(axial(), middle + side * from, middle + side * to);
    };
    all.push_back(between([=] { measure("slice-tool-distance", {-0.25, -0.1}, {0.05, -0.15}); }));
    all.push_back(station("measure", [=] { measure("slice-tool-ellipse", {0.05, 0.05}, {0.25, 0.2}); }));
    all.push_back(between([this] { hand_.trigger("slice-tool-crosshair"); }));
    all.push_back(station("clip", [this] {
        showPanel(hand_, "clip-panel", true);
        hand_.trigger("clip-anterior-half");
    }));
    all.push_back(between(
        [this] {
            showPanel(hand_, "clip-panel", false);
            hand_.press(Qt::Key_U, Qt::ControlModifier);
        },
        [this] { return window_.viewport().isCameraOnScreen(); }));
    all.push_back(between([this] {
        hand_.press(Qt::Key_X);
        hand_.dragAround(window_.viewport().window(), 0.2);
    }));
    all.push_back(between({}, [this] { return !window_.cutting(); }));
    all.push_back(station("scissors", {}));
    all.push_back(between(
        [this] {
            if (window_.scissors().isOut()) hand_.press(Qt::Key_X);
            hand_.trigger("undo");
        },
        [this] { return !window_.cutting(); }));
    all.push_back(station("volume", [this] { hand_.press(Qt::Key_F6); }));
    all.push_back(between([this] { hand_.press(Qt::Key_F5); }));
}

void StationsScript::addDialogs(std::vector<DrivenStep>& all) {
    const auto dialog = [this, &all](const char* name, std::function<void()> opens) {
        all.push_back(station(name, std::move(opens)));
        all.push_back(between([this] { closeDialogs(); }));
    };
    dialog("save", [this] { hand_.trigger("save-picture"); });
    dialog("settings", [this] { hand_.trigger("settings"); });
    dialog("settings-keys", [this] {
        hand_.trigger("settings");
        if (auto* pages = hand_.find<QTabWidget>("settings-pages"))
            pages->setCurrentIndex(pages->count() - 1);
    });
    dialog("keys", [this] { hand_.press(Qt::Key_F1); });
    all.push_back(station("movie", [this] { hand_.trigger("save-movie"); }));
    all.push_back(between([this] { showPanel(hand_, "movie-panel", false); }));
}

void StationsScript::addSecondVolume(std::vector<DrivenStep>& all) {
    DrivenStep opens = between([this] { hasSecond_ = openSecond(); },
                               [this] {
                                   return !hasSecond_ || (window_.secondVolume().second() != nullptr &&
                                                          !window_.secondVolume().isWorking());
                               });
    opens.patienceMs = kSecondMs;
    all.push_back(std::move(opens));
    all.push_back(station("beside", {}));
    all.push_back(station("fusion", [this] {
        if (hasSecond_) window_.secondVolume().setView(scene::SecondVolumePlace::over);
    }));
}

// Another volume of the patient in the folder: of another modality, where there is one.
bool StationsScript::openSecond() {
    const study::OpenedStudy& study = window_.session().study();
    if (!study.found) return false;
    const std::vector<study::FoundVolume>& volumes = study.found->volumes();
    const study::FoundVolume& shown = volumes.at(study.volumeIndex);
    std::optional<std::size_t> second;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        if (i == study.volumeIndex || volumes[i].study->patient != shown.study->patient) continue;
        const bool isOther = volumes[i].stack->modality != shown.stack->modality;
        if (!second || isOther) second = i;
        if (isOther) break;
    }
    if (second) window_.secondVolume().open(study.found, *second);
    return second.has_value();
}

void StationsScript::closeDialogs() {
    for (auto* dialog : window_.findChildren<QDialog*>()) {
        if (dialog->isVisible()) dialog->reject();
    }
}

void StationsScript::start() {
    if (!QDir().mkpath(options_.folder)) {
        tellError(QStringLiteral("The folder for the pictures cannot be made."));
        QTimer::singleShot(0, this, [this] { finish(exitCodeOf(ErrorCode::outputNotWritable)); });
        return;
    }
    std::vector<DrivenStep> all = steps();
    if (!options_.until.isEmpty()) {
        const auto last = std::ranges::find(all, options_.until, &DrivenStep::name);
        if (last == all.end()) {
            tellError(QStringLiteral("There is no station '%1'.").arg(options_.until));
            QTimer::singleShot(0, this, [this] { finish(kExitUsage); });
            return;
        }
        all.erase(last + 1, all.end());
    }
    window_.setGeometry(window_.screen()->geometry());
    steps_ = std::make_unique<DrivenSteps>(std::move(all));
    connect(steps_.get(), &DrivenSteps::ended, this, &StationsScript::onEnded);
    connect(steps_.get(), &DrivenSteps::finished, this, &StationsScript::end);
    steps_->start();
}

void StationsScript::onEnded(const MeasuredStep& step) {
    if (step.name == QLatin1String("-opening") && !step.isDone) {
        tellError(QStringLiteral("No picture came in time."));
        return finish(exitCodeOf(ErrorCode::deviceNotUsable));
    }
    const bool isOfSecond = step.name == QLatin1String("beside") || step.name == QLatin1String("fusion");
    if (step.name.isEmpty() || step.name.startsWith(QLatin1Char('-')) || (isOfSecond && !hasSecond_)) return;
    takePicture(step.name);
}

// From the screen: what a person sees, dialogs and the native window included.
void StationsScript::takePicture(const QString& name) {
    const QString file = QDir(options_.folder).filePath(name + QStringLiteral(".png"));
    const QImage picture = window_.screen()->grabWindow(0).toImage();
    names_.append(name);
    QThreadPool::globalInstance()->start([picture, file] {
        if (picture.isNull() || !picture.save(file)) ++failedPictures;
    });
}

void StationsScript::end() {
    QThreadPool::globalInstance()->waitForDone();
    std::fputs(QJsonDocument(names_).toJson(QJsonDocument::Indented).constData(), stdout);
    std::fflush(stdout);
    for (const QString& name : hand_.missing()) tellError(QStringLiteral("Not there: %1.").arg(name));
    if (failedPictures > 0) return finish(exitCodeOf(ErrorCode::outputNotWritable));
    finish(hand_.missing().isEmpty() ? kExitDone : kExitFault);
}

void StationsScript::finish(int exitCode) {
    if (std::exchange(isDone_, true)) return;
    if (steps_) steps_->stop();
    Q_EMIT finished(exitCode);
}

}  // namespace macula::viewer
