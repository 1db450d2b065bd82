#include "viewer/output/video_encoder.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <utility>

#include "pictures/view_sequence.h"

namespace macula::viewer {

namespace {

struct Kind {
    const char* codec;
    std::array<const char*, 2> quality;
};
// Each writes MP4. Every build of the encoder has the last one.
constexpr std::array<Kind, 3> kKinds{
    {{"libx264", {"-crf", "18"}}, {"libopenh264", {"-b:v", "12M"}}, {"mpeg4", {"-q:v", "2"}}}};

// The encoder's pattern for file names: frame-%04d.png.
QString pattern(int frames) {
    const QString last = QString::fromStdString(pictures::frameName(frames - 1, frames));
    const auto digits = last.size() - QStringLiteral("frame-.png").size();
    // Not with arg(), which would replace "%0".
    return QStringLiteral("frame-%0") + QString::number(digits) + QStringLiteral("d.png");
}

}  // namespace

VideoEncoder::VideoEncoder(QObject* parent) : QObject(parent) {}

VideoEncoder::~VideoEncoder() {
    cancel();
}

QString VideoEncoder::find(const QString& program) {
    return QStandardPaths::findExecutable(program);
}

// Names are relative to the folder, whose own name may contain any characters.
QStringList VideoEncoder::argumentsFor(const VideoRequest& request, std::size_t kind) {
    if (kind >= kKinds.size() || request.frames < 1) return {};
    const Kind& with = kKinds.at(kind);
    return {QStringLiteral("-nostdin"),
            QStringLiteral("-loglevel"),
            QStringLiteral("error"),
            QStringLiteral("-progress"),
            QStringLiteral("pipe:1"),
            QStringLiteral("-y"),
            QStringLiteral("-framerate"),
            QString::number(request.picturesPerS, 'g', 6),
            QStringLiteral("-start_number"),
            QStringLiteral("1"),
            QStringLiteral("-i"),
            pattern(request.frames),
            QStringLiteral("-frames:v"),
            QString::number(request.frames),
            QStringLiteral("-vf"),
            QStringLiteral("pad=ceil(iw/2)*2:ceil(ih/2)*2"),
            QStringLiteral("-c:v"),
            QString::fromLatin1(with.codec),
            QString::fromLatin1(with.quality[0]),
            QString::fromLatin1(with.quality[1]),
            QStringLiteral("-pix_fmt"),
            QStringLiteral("yuv420p"),
            QStringLiteral("-map_metadata"),
            QStringLiteral("-1"),
            QStringLiteral("-f"),
            QStringLiteral("mp4"),
            QStringLiteral(".") + request.fileName + QStringLiteral(".part")};
}

QString VideoEncoder::partName() const {
    return QDir(request_.folder).filePath(QStringLiteral(".") + request_.fileName + QStringLiteral(".part"));
}

void VideoEncoder::start(const QString& program, const VideoRequest& request) {
    cancel();
    program_ = program;
    request_ = request;
    kind_ = 0;
    startKind();
}

void VideoEncoder::startKind() {
    const QStringList arguments = argumentsFor(request_, kind_);
    if (arguments.isEmpty()) {
        Q_EMIT ended(false);
        return;
    }
    process_ = new QProcess(this);
    process_->setWorkingDirectory(request_.folder);
    process_->setStandardErrorFile(QProcess::nullDevice());
    connect(process_, &QProcess::readyReadStandardOutput, this, &VideoEncoder::onOutput);
    connect(process_, &QProcess::finished, this, [this](int code, QProcess::ExitStatus status) {
        onFinished(code == 0 && status == QProcess::NormalExit);
    });
    connect(process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) onFinished(false);
    });
    process_->start(program_, arguments);
}

// Lines such as "frame=12".
void VideoEncoder::onOutput() {
    while (process_ != nullptr && process_->canReadLine()) {
        const QByteArray line = process_->readLine().trimmed();
        if (!line.startsWith("frame=")) continue;
        Q_EMIT progressed(std::clamp(line.mid(6).toDouble() / std::max(request_.frames, 1), 0.0, 1.0));
    }
}

void VideoEncoder::onFinished(bool isDone) {
    if (process_ == nullptr) return;
    std::exchange(process_, nullptr)->deleteLater();
    const QString file = QDir(request_.folder).filePath(request_.fileName);
    if (isDone && QFile::rename(partName(), file)) {
        Q_EMIT ended(true);
        return;
    }
    QFile::remove(partName());
    ++kind_;
    startKind();  // the encoder may have this one
}

void VideoEncoder::cancel() {
    if (process_ == nullptr) return;
    QProcess* process = std::exchange(process_, nullptr);
    process->disconnect(this);
    process->kill();
    process->waitForFinished(1000);
    delete process;
    QFile::remove(partName());
}

}  // namespace macula::viewer
