#include "viewer/output/movie_export.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <cmath>
#include <new>
#include <utility>

#include "viewer/language/window_language.h"

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

}  // namespace macula::viewer
