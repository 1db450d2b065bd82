#include "viewer/segmenting/program_run.h"

#include <signal.h>
#include <unistd.h>

#include <QDir>
#include <QFileInfo>
#include <exception>
#include <utility>

#include "base/exceptions.h"
#include "formats/volume_file.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

constexpr qsizetype kMostWords = 2000;  // of the program's errors, in bytes
constexpr int kMsPerMinute = 60'000;
constexpr int kKillMs = 3000;

Error errorFrom(const QString& what, const QString& hint) {
    return {ErrorCode::inputNotUsable,
            Text::verbatim(what.toStdString()),
            {},
            Text::verbatim(hint.toStdString())};
}

}  // namespace

ProgramRun::ProgramRun(QObject* parent)
    : QObject(parent),
      writing_(this, {.progressed =
                          [this](const ProgressUpdate& update) {
                              Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                          },
                      .ended =
                          [this](const Result<bool>& outcome) {
                              if (outcome) return run();
                              end();
                              Q_EMIT failed(outcome.error());
                          }}),
      reading_(this, {.ended = [this](const Result<std::vector<scene::OwnSegment>>& outcome) {
                   end();
                   if (outcome) {
                       Q_EMIT succeeded(*outcome);
                   } else {
                       Q_EMIT failed(outcome.error());
                   }
               }}) {
    late_.setSingleShot(true);
    connect(&late_, &QTimer::timeout, this, [this] {
        const int minutes = minutes_;
        kill();
        fail(tr("The program took longer than %n minutes, and was stopped.", nullptr, minutes),
             tr("Allow more time, or let it work on a smaller volume."));
    });
}

ProgramRun::~ProgramRun() {
    kill();
}

Result<void> ProgramRun::start(const ProgramToRun& program, std::shared_ptr<const Volume> volume) {
    words_ = QProcess::splitCommand(program.command);
    const auto has = [this](const QString& what) { return words_.filter(what).size() > 0; };
    if (words_.isEmpty() || !has(QStringLiteral("{input}")) || !has(QStringLiteral("{output}")))
        return Error{
            ErrorCode::usage,
            Text::verbatim(tr("The command has to name a program, {input} and {output}.").toStdString()),
            {},
            Text::verbatim(tr("Write for example: my-model --in {input} --out {output}").toStdString())};
    cancel();
    folder_ = std::make_unique<QTemporaryDir>(QDir::tempPath() + QStringLiteral("/macula-segment-XXXXXX"));
    if (!folder_->isValid()) {
        folder_.reset();
        return Error{ErrorCode::outputNotWritable,
                     Text::verbatim(tr("No folder could be made for the program.").toStdString()),
                     {},
                     Text::verbatim(tr("Free some space for temporary files.").toStdString())};
    }
    volume_ = std::move(volume);
    minutes_ = program.minutesMost;
    errors_.clear();
    const QString input = folder_->filePath(QStringLiteral("input.nii.gz"));
    const QString output = folder_->filePath(QStringLiteral("output.nii.gz"));
    for (QString& word : words_)
        word.replace(QStringLiteral("{input}"), input).replace(QStringLiteral("{output}"), output);
    writing_.start([volume = volume_, path = input.toStdString()](Progress& progress) -> Result<bool> {
        try {
            MACULA_TRY_VOID(formats::writeVolumeFile(*volume, path, progress));
            return true;
        } catch (const std::exception& thrown) {
            return errorOf(thrown, Text("write the volume for the program"));
        }
    });
    return {};
}

void ProgramRun::run() {
    process_ = std::make_unique<QProcess>();
    process_->setWorkingDirectory(folder_->path());
    process_->setStandardInputFile(QProcess::nullDevice());
    // A group of its own, so that a cancel reaches what a script has started, too.
    process_->setChildProcessModifier([] { ::setpgid(0, 0); });
    connect(process_.get(), &QProcess::readyReadStandardOutput, this, [this] {
        const QList<QByteArray> lines = process_->readAllStandardOutput().trimmed().split('\n');
        Q_EMIT progressed(harmless(QString::fromUtf8(lines.back().right(80))), 0.0);
    });
    connect(process_.get(), &QProcess::readyReadStandardError, this,
            [this] { errors_ = (errors_ + process_->readAllStandardError()).right(kMostWords); });
    connect(process_.get(), &QProcess::finished, this, &ProgramRun::onFinished);
    connect(process_.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            fail(tr("The program could not be started."), tr("Check its path, and that it may be run."));
    });
    late_.start(minutes_ * kMsPerMinute);
    Q_EMIT progressed(tr("The program is working"), 0.0);
    process_->start(words_.front(), words_.mid(1));
}

QString ProgramRun::lastWords() const {
    return harmless(QString::fromUtf8(errors_).simplified());
}

void ProgramRun::onFinished(int code, QProcess::ExitStatus status) {
    errors_ = (errors_ + process_->readAllStandardError()).right(kMostWords);
    late_.stop();
    if (status == QProcess::NormalExit && code == 0) return read();
    const QString said = lastWords();
    fail(status == QProcess::NormalExit ? tr("The program ended with an error (code %1).").arg(code)
                                        : tr("The program crashed."),
         said.isEmpty() ? tr("It said nothing about why.") : tr("It said: %1").arg(said));
}

void ProgramRun::read() {
    const QString output = folder_->filePath(QStringLiteral("output.nii.gz"));
    if (!QFileInfo(output).isFile()) {
        const QString said = lastWords();
        return fail(tr("The program wrote no result."),
                    said.isEmpty() ? tr("It has to write the file that {output} names.")
                                   : tr("It said: %1").arg(said));
    }
    Q_EMIT progressed(tr("Reading the result"), 0.0);
    reading_.start([path = output.toStdString(),
                    volume = volume_](Progress& progress) -> Result<std::vector<scene::OwnSegment>> {
        MACULA_TRY(const auto labels, formats::readVolumeFile(path, progress));
        return scene::segmentsOfLabels(*labels, *volume);
    });
}

void ProgramRun::fail(const QString& what, const QString& hint) {
    if (!isRunning()) return;
    end();
    Q_EMIT failed(errorFrom(what, hint));
}

void ProgramRun::kill() {
    if (!process_) return;
    process_->disconnect(this);
    if (const qint64 pid = process_->processId(); pid > 0) ::kill(-pid_t(pid), SIGKILL);
    process_->kill();
    process_->waitForFinished(kKillMs);
}

void ProgramRun::cancel() {
    writing_.cancel();
    reading_.cancel();
    kill();
    if (isRunning()) end();
}

// Called from signals of the process, which therefore is deleted later.
void ProgramRun::end() {
    late_.stop();
    if (process_) {
        process_->disconnect(this);
        process_.release()->deleteLater();
    }
    volume_.reset();
    folder_.reset();
    Q_EMIT ended();
}

}  // namespace macula::viewer
