// Draws a picture to a file in the background.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <string>
#include <vector>

#include "pictures/view_picture.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// One at a time; a new one cancels the one before, which writes nothing. Lives on the UI thread, and so do
// its signals.
class PictureExport : public QObject {
    Q_OBJECT

  public:
    explicit PictureExport(std::string preferredDevice, QObject* parent = nullptr);

    void start(pictures::ViewPicture picture);
    void cancel();
    bool running() const { return job_.running(); }

  Q_SIGNALS:
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void written(const QString& path, const QStringList& notes);
    void failed(const macula::Error& error);

  private:
    void onEnded(const Result<std::vector<Text>>& outcome);

    std::string preferredDevice_;
    QString path_;
    BackgroundJob<std::vector<Text>> job_;
};

}  // namespace macula::viewer
