#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/output/movies_controller.h"

#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>
#include <cmath>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/output/movie_panel.h"
#include "viewer/output/picture_overlays.h"
#include "viewer/output/video_encoder.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/status_texts.h"
#include "viewer/status/work_status.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

namespace {

const QString kVideo = QStringLiteral("movie.mp4");

// The time left, estimated from the time that the finished part took.
QString leftText(qint64 elapsedMs, double fraction) {
    if (!(fraction > 0.0)) return {};
    const double leftS = double(elapsedMs) / 1000.0 * (1.0 - fraction) / fraction;
    return leftS < 90.0 ? MovieExport::tr(", %1 s left").arg(std::ceil(leftS), 0, 'f', 0)
                        : MovieExport::tr(", %1 min left").arg(std::ceil(leftS / 60.0), 0, 'f', 0);
}

}  // namespace

MovieExport::MovieExport(std::string preferredDevice, QObject* parent)
    : QObject(parent),
      preferredDevice_(std::move(preferredDevice)),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          const qint64 elapsed = QDateTime::currentMSecsSinceEpoch() - stageBeganMs_;
                          Q_EMIT progressed(
                              inWindowsLanguage(update.stage) + leftText(elapsed, update.fraction),
                              update.fraction);
                      },
                  .ended = [this](const Result<pictures::WrittenSequence>& outcome) { onDrawn(outcome); }}),
      encoder_(this) {
    connect(&encoder_, &VideoEncoder::progressed, this,
            [this](double fraction) { Q_EMIT progressed(tr("Encoding the video"), fraction); });
    connect(&encoder_, &VideoEncoder::ended, this, [this](bool isWritten) {
        finish(isWritten ? tr("The video is %1.").arg(kVideo)
                         : tr("The encoder made no video of them: take another program for that."));
    });
}

void MovieExport::start(MovieRequest request) {
    cancel();
    folder_ = QString::fromStdString(request.sequence.folder.string());
    picturesPerS_ = request.picturesPerS;
    wantsVideo_ = request.wantsVideo;
    told_.clear();
    stageBeganMs_ = QDateTime::currentMSecsSinceEpoch();
    using Written = Result<pictures::WrittenSequence>;
    job_.start(
        [sequence = std::move(request.sequence), device = preferredDevice_](Progress& progress) -> Written {
            try {
                return pictures::writeViewSequence(sequence, device, progress);
            } catch (const std::bad_alloc&) {
                return Error{ErrorCode::outOfMemory,
                             Text("There is not enough memory for these pictures."),
                             {},
                             Text("Choose a smaller size, or close other programs.")};
            }
        });
    Q_EMIT began();
}

void MovieExport::cancel() {
    const bool wasEncoding = encoder_.running();
    encoder_.cancel();
    if (job_.cancel()) {
        Q_EMIT ended();
    } else if (wasEncoding) {
        finish(tr("The video was stopped."));
    }
}

void MovieExport::onDrawn(const Result<pictures::WrittenSequence>& outcome) {
    if (!outcome) {
        Q_EMIT ended();
        if (outcome.error().code != ErrorCode::cancelled) Q_EMIT failed(outcome.error());
        return;
    }
    told_ << tr("%Ln pictures are in %1.", nullptr, int(outcome->files.size())).arg(folder_);
    told_ += inWindowsLanguage(outcome->sentences);
    if (!wantsVideo_) return finish({});
    const QString program = VideoEncoder::find();
    if (program.isEmpty())
        return finish(tr("No video was made of them: there is no encoder. Install ffmpeg, and draw again."));
    if (QFileInfo::exists(QDir(folder_).filePath(kVideo)))
        return finish(tr("No video was made of them: %1 is there already.").arg(kVideo));
    encoder_.start(program, {.folder = folder_,
                             .frames = int(outcome->files.size()),
                             .picturesPerS = picturesPerS_,
                             .fileName = kVideo});
}

void MovieExport::finish(const QString& aboutVideo) {
    if (!aboutVideo.isEmpty()) told_ << aboutVideo;
    Q_EMIT ended();
    Q_EMIT written(told_.join(QLatin1Char(' ')));
}

MoviesController::MoviesController(const WindowContext& context)
    : QObject(&context.window),
      context_(context),
      panel_(new MoviePanel([this]() -> std::optional<Camera> {
          if (!context_.session.hasStudy()) return std::nullopt;
          return toCamera(context_.viewport.camera());
      })),
      export_(new MovieExport(context.device, this)),
      bar_(new WorkBar) {
    auto* scrolled = new QScrollArea;  // so that the panel does not force the window to grow
    scrolled->setFocusPolicy(Qt::NoFocus);
    scrolled->setWidgetResizable(true);
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setWidget(panel_);
    scrolled_ = scrolled;
    connect(panel_, &MoviePanel::drawAsked, this, &MoviesController::askWhereToDraw);
    connect(panel_, &MoviePanel::openAsked, this, &MoviesController::askForPath);
    connect(panel_, &MoviePanel::saveAsked, this, &MoviesController::askWhereToSavePath);

    showWork(*export_, *bar_, tr("Drawing the movie"), context_.notifications);
    connect(export_, &MovieExport::written, this, [this](const QString& told) {
        context_.notifications.showNote(told);
        Q_EMIT written();
    });
}

void MoviesController::setDock(QDockWidget& dock) {
    dock_ = &dock;
    connect(&dock, &QDockWidget::visibilityChanged, panel_, [this](bool isVisible) {
        if (isVisible) panel_->setHasEncoder(!VideoEncoder::find().isEmpty());
    });
}

void MoviesController::addActions(QMenu& file) {
    QAction* movie = file.addAction(tr("Save Mo&vie…"), this, [this] {
        dock_->show();
        dock_->raise();
        panel_->setFocus();
    });
    describe(*movie, "save-movie", tr("A turntable or a way of the camera as pictures, and as a video"));
}

QString MoviesController::unfinished() const {
    return export_->running() ? tr("A movie is still being drawn.") : QString();
}

void MoviesController::cancel() {
    export_->cancel();
}

// Views of one patient make no sense for the next.
void MoviesController::onStudyShown() {
    panel_->setViews({});
}

void MoviesController::askWhereToDraw() {
    if (!context_.notifications.refuseUnless(context_.session.hasStudy(),
                                             tr("There is nothing to draw yet.")))
        return;
    if (!context_.notifications.refuseUnless(!context_.viewport.showsOtherPhase(),
                                             whyNotOfOpenPhase(context_.viewport)))
        return;
    const study::OpenedStudy& study = context_.session.study();
    const auto path = panel_->pathFrom(toCamera(context_.viewport.camera()));
    if (!path) return;
    // Takes what is on screen now: while a person looks for a folder, another study may open.
    MovieRequest request;
    request.sequence.picture.volume = study.volume;
    request.sequence.picture.seriesDigest = study.seriesDigest;
    request.sequence.picture.drawing = context_.shown.drawing();
    request.sequence.picture.sizePx = {panel_->sizePx().width(), panel_->sizePx().height()};
    request.sequence.picture.effort.quality = panel_->quality();
    request.sequence.path = *path;
    request.sequence.frames = panel_->frames();
    request.sequence.isClosed = panel_->isClosed();
    request.picturesPerS = panel_->picturesPerS();
    request.wantsVideo = panel_->wantsVideo();
    const std::vector<std::string> lines =
        panel_->withNames() ? linesToShow(study.identity) : std::vector<std::string>();
    if (panel_->withLetters() || !lines.empty()) {
        request.sequence.stampsFor = [lines, withLetters = panel_->withLetters(),
                                      sizePx = request.sequence.picture.sizePx](const Camera& from) {
            const scene::EdgeLetters letters =
                withLetters ? scene::edgeLetters(scene::orbitCameraOf(from)) : scene::EdgeLetters{};
            return stampsOf(lines, letters, sizePx);
        };
    }
    auto* dialog = context_.files.toOpenFolder(FolderKind::movies, tr("Choose a folder for the pictures"));
    context_.files.ask(dialog, FolderKind::movies,
                       [this, request = std::move(request)](const QString& folder) {
                           MovieRequest now = request;
                           now.sequence.folder = folder.toStdString();
                           export_->start(std::move(now));
                       });
}

void MoviesController::askForPath() {
    auto* dialog =
        context_.files.toOpen(FolderKind::movies, tr("Open a way of the camera"), tr("Ways (*.json)"));
    context_.files.ask(dialog, FolderKind::movies, [this](const QString& file) {
        auto path = scene::readCameraPath(file.toStdString());
        if (!path) return context_.notifications.showError(path.error());
        context_.notifications.hide();
        panel_->setViews(*std::move(path));
    });
}

void MoviesController::askWhereToSavePath() {
    if (panel_->views().stops.empty()) return;
    auto* dialog =
        context_.files.toSave(FolderKind::movies, tr("Save the way of the camera"), tr("Ways (*.json)"),
                              QStringLiteral("json"), QStringLiteral("path.json"));
    context_.files.ask(
        dialog, FolderKind::movies, [this, json = toJson(panel_->views())](const QString& file) {
            context_.notifications.showOutcome(
                writeTextAtomically(file.toStdString(), json),
                tr("The way is written to %1. macula hybrid draws it with --path %1.").arg(file));
        });
}

}  // namespace macula::viewer
