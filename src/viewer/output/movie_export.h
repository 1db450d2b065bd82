// A turntable or a way of the camera that is drawn to a folder while the window goes on, and made a video.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <string>

#include "pictures/view_sequence.h"
#include "viewer/jobs/background_job.h"
#include "viewer/output/video_encoder.h"

namespace macula::viewer {

struct MovieWish {
    app::ViewSequence sequence;
    double picturesPerS = 25.0;
    bool wantsVideo = false;  // where there is an encoder
};

// One at a time; another one takes the place of the one before. When drawing
// is stopped nothing of it is left; when encoding is, the pictures are. Lives on the UI thread, and so do its
// signals.
class MovieExport : public QObject {
    Q_OBJECT

  public:
    explicit MovieExport(std::string preferredDevice, QObject* parent = nullptr);

    void start(MovieWish wish);
    void cancel();
    bool running() const { return job_.running() || encoder_.running(); }

  signals:
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void written(const QString& told);  // sentences for a person
    void failed(const macula::Error& error);

  private:
    void onDrawn(const Result<app::WrittenSequence>& outcome);
    void finish(const QString& aboutVideo);

    std::string preferredDevice_;
    // Of the last wish; the volume and names are the job's alone, and go with it.
    QString folder_;
    double picturesPerS_ = 0.0;
    bool wantsVideo_ = false;
    QStringList told_;
    qint64 stageBeganMs_ = 0;
    BackgroundJob<app::WrittenSequence> job_;
    VideoEncoder encoder_;
};

}  // namespace macula::viewer
