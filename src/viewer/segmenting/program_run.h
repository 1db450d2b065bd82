// Somebody else's program that segments the open volume.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QProcess>
#include <QString>
#include <QTemporaryDir>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "scene/segments/own_segments.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

struct ProgramToRun {
    QString command;  // as for a shell, but none is used; has {input} and {output}
    int minutesMost = 60;
};

// Writes the volume as NIfTI, without anything of the patient, into a folder that only the user can read;
// runs the program there with the paths of this file, and of one that it is to write; reads that one, which
// has to be a map of segment numbers on the same grid. The folder is deleted afterwards. One run at a time.
// Lives on the UI thread.
class ProgramRun : public QObject {
    Q_OBJECT

  public:
    explicit ProgramRun(QObject* parent = nullptr);
    ~ProgramRun() override;

    bool isRunning() const { return folder_ != nullptr; }
    // Usage for a command that cannot be run: without a program, {input} or {output}.
    Result<void> start(const ProgramToRun& program, std::shared_ptr<const Volume> volume);
    void cancel();  // kills the program and what it has started

  Q_SIGNALS:
    void progressed(const QString& stage, double fraction);  // 0 while nobody knows
    void ended();                                            // however it ended
    void succeeded(const std::vector<macula::scene::OwnSegment>& segments);
    void failed(const macula::Error& error);

  private:
    void run();
    void onFinished(int code, QProcess::ExitStatus status);
    void read();
    void kill();
    void end();
    void fail(const QString& what, const QString& hint);
    QString lastWords() const;

    std::unique_ptr<QTemporaryDir> folder_;  // null: nothing runs
    std::unique_ptr<QProcess> process_;
    std::shared_ptr<const Volume> volume_;
    QStringList words_;
    QByteArray errors_;  // the end of what the program wrote there
    QTimer late_;
    int minutes_ = 0;
    BackgroundJob<bool> writing_;
    BackgroundJob<std::vector<scene::OwnSegment>> reading_;
};

}  // namespace macula::viewer
