// Draws a turntable or a camera path to a folder in the background, and encodes it as a video.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <string>

#include "pictures/view_sequence.h"
#include "viewer/jobs/background_job.h"
#include "viewer/output/video_encoder.h"

namespace macula::viewer {

struct MovieRequest {
    pictures::ViewSequence sequence;
    double picturesPerS = 25.0;
    bool wantsVideo = false;  // if there is an encoder
};

// One at a time; a new one cancels the one before. Cancelling while drawing leaves no files; cancelling while
// encoding leaves the pictures. Lives on the UI thread, and so do its signals.
class MovieExport : public QObject {
    Q_OBJECT

  public:
    explicit MovieExport(std::string preferredDevice, QObject* parent = nullptr);

    void start(MovieRequest request);
    void cancel();
    bool running() const { return job_.running() || encoder_.running(); }

  Q_SIGNALS:
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void written(const QString& told);  // sentences for a person
    void failed(const macula::Error& error);

  private:
    void onDrawn(const Result<pictures::WrittenSequence>& outcome);
    void finish(const QString& aboutVideo);

    std::string preferredDevice_;
    // These three are from the last request; only the job keeps its volume and names.
    QString folder_;
    double picturesPerS_ = 0.0;
    bool wantsVideo_ = false;
    QStringList told_;
    qint64 stageBeganMs_ = 0;
    BackgroundJob<pictures::WrittenSequence> job_;
    VideoEncoder encoder_;
};

}  // namespace macula::viewer
