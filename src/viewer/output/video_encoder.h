// Pictures of a folder as a video, by the encoder of the machine: ffmpeg, where it is installed.
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>

namespace macula::viewer {

struct VideoWish {
    QString folder;  // with frame-0001.png and so on: app::frameName
    int frames = 0;
    double picturesPerS = 25.0;
    QString fileName;  // in that folder, .mp4; not there yet
};

// The first kind of video that the encoder has. A process of its own that is given words, and no shell. Lives
// on the UI thread.
class VideoEncoder : public QObject {
    Q_OBJECT

  public:
    explicit VideoEncoder(QObject* parent = nullptr);
    ~VideoEncoder() override;  // ends the process

    // The program of that name in PATH; empty: there is none.
    static QString find(const QString& program = QStringLiteral("ffmpeg"));
    // What it is called with, for the kind of video with that index; empty: there are no more.
    static QStringList argumentsFor(const VideoWish& wish, std::size_t kind);

    void start(const QString& program, const VideoWish& wish);
    void cancel();  // nothing of the video is left, and nothing is told
    bool running() const { return process_ != nullptr; }

  signals:
    void progressed(double fraction);
    void ended(bool isWritten);

  private:
    void startKind();
    void onOutput();
    void onFinished(bool isDone);
    QString partName() const;

    QString program_;
    VideoWish wish_;
    std::size_t kind_ = 0;
    QProcess* process_ = nullptr;
};

}  // namespace macula::viewer
