// Encodes the pictures of a folder as a video with ffmpeg, if that is installed.
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>

namespace macula::viewer {

struct VideoRequest {
    QString folder;  // with frame-0001.png and so on: pictures::frameName
    int frames = 0;
    double picturesPerS = 25.0;
    QString fileName;  // in that folder, .mp4; must not exist
};

// Encodes H.264, or MPEG-4 if the encoder has no H.264. Runs the encoder as a process without a shell. Lives
// on the UI thread.
class VideoEncoder : public QObject {
    Q_OBJECT

  public:
    explicit VideoEncoder(QObject* parent = nullptr);
    ~VideoEncoder() override;  // ends the process

    // The program of that name in PATH; empty if there is none.
    static QString find(const QString& program = QStringLiteral("ffmpeg"));
    // The arguments for the codec of index `kind`; empty if there are no more.
    static QStringList argumentsFor(const VideoRequest& request, std::size_t kind);

    void start(const QString& program, const VideoRequest& request);
    void cancel();  // leaves no file and emits nothing
    bool running() const { return process_ != nullptr; }

  Q_SIGNALS:
    void progressed(double fraction);
    void ended(bool isWritten);

  private:
    void startKind();
    void onOutput();
    void onFinished(bool isDone);
    QString partName() const;

    QString program_;
    VideoRequest request_;
    std::size_t kind_ = 0;
    QProcess* process_ = nullptr;
};

}  // namespace macula::viewer
