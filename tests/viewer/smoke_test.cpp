// The programs themselves, as a user starts them.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSet>
#include <QTemporaryDir>

#include <csignal>

#include "viewer/display.h"
#include "viewer/wait_until.h"

namespace macula::viewer {
namespace {

struct Outcome {
    int exitCode = -1;
    QByteArray output;
    QByteArray errors;
};

Outcome run(const QString& program, const QStringList& arguments, const QStringList& environment) {
    QProcess process;
    QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    for (const QString& entry : environment) {
        const qsizetype equals = entry.indexOf('=');
        if (equals == entry.size() - 1) {
            all.remove(entry.left(equals));
        } else {
            all.insert(entry.left(equals), entry.mid(equals + 1));
        }
    }
    process.setProcessEnvironment(all);
    process.start(program, arguments);
    if (!process.waitForFinished(250'000)) {
        process.kill();
        process.waitForFinished();
        return {-1, process.readAllStandardOutput(), process.readAllStandardError() + "\nkilled: too slow"};
    }
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2,
            process.readAllStandardOutput(), process.readAllStandardError()};
}

Outcome runViewer(const QStringList& arguments, const QStringList& environment = {}) {
    return run(QStringLiteral(MACULA_VIEWER_PROGRAM), arguments, environment);
}

Outcome runBench(const QStringList& arguments, const QStringList& environment = {}) {
    return run(QStringLiteral(MACULA_VIEWER_BENCH_PROGRAM), arguments, environment);
}

class ViewerProgram : public testing::Test {
  protected:
    void SetUp() override {
        if (const std::string why = test::ensureDisplay(); !why.empty()) GTEST_SKIP() << why;
    }
};

using ViewerBenchProgram = ViewerProgram;

TEST_F(ViewerBenchProgram, OrbitsThePhantomTakesScreenshotsAndMeasuresItself) {
    QTemporaryDir folder;
    const Outcome outcome = runBench(
        {"orbit", "--seconds", "2", "--spp", "2", "--size", "520x300", "--screenshots", folder.path()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();

    const QJsonObject json = QJsonDocument::fromJson(outcome.output).object();
    EXPECT_EQ(json["width"].toInt(), 520);
    EXPECT_EQ(json["height"].toInt(), 300);
    EXPECT_FALSE(json["device"].toString().isEmpty());
    // How fast is for a benchmark to say; that the picture follows the hand at all, for this.
    EXPECT_GE(json["orbitFrames"].toInt(), 3);
    EXPECT_GE(json["orbitSeconds"].toDouble(), 2.0);
    EXPECT_GT(json["orbitFramesPerSecond"].toDouble(), 0.0);
    // That nobody waits for pictures, RenderThreadTest.PublishingDoesNotWaitForAStepUnderWay shows.
    EXPECT_TRUE(json["longestUiStallMs"].isDouble());
    EXPECT_GT(json["uiBeats"].toInt(), json["orbitFrames"].toInt());

    for (const char* name : {"motion-1.png", "motion-2.png", "motion-3.png", "converged.png"}) {
        const QImage picture(folder.filePath(name));
        ASSERT_FALSE(picture.isNull()) << name;
        ASSERT_GE(picture.width(), 400);
        // The middle of the window, where the phantom is.
        QSet<QRgb> colours;
        for (int y = picture.height() / 3; y < 2 * picture.height() / 3; ++y) {
            for (int x = picture.width() / 3; x < 2 * picture.width() / 3; ++x) {
                colours.insert(picture.pixel(x, y));
            }
        }
        EXPECT_GT(colours.size(), 100) << name << " is nearly uniform";
    }
}

TEST_F(ViewerBenchProgram, OpensTheStudyAndSaysHowSoon) {
    const Outcome outcome = runBench({"opening", "--no-model", "--spp", "2", "--size", "520x300"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
    const QJsonObject json = QJsonDocument::fromJson(outcome.output).object();
    const QJsonObject opening = json["opening"].toObject();
    for (const char* what : {"windowMs", "studyReadMs", "sliceMs", "pictureMs"})
        EXPECT_GE(opening[QLatin1String(what)].toDouble(-1.0), 0.0) << what;
    EXPECT_GE(json["startMs"].toDouble(), 0.0);
    EXPECT_TRUE(json["longestUiStallMs"].isDouble());
    EXPECT_FALSE(json.contains("orbit"));
}

TEST_F(ViewerBenchProgram, TakesPicturesOfStations) {
    QTemporaryDir folder;
    const Outcome outcome = runBench({"stations", "--until", "studies", "--wait", "1", "--no-model", "--spp",
                                      "2", "--screenshots", folder.path()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors.toStdString();
    const QImage open(folder.filePath("open.png"));
    const QImage studies(folder.filePath("studies.png"));
    ASSERT_FALSE(open.isNull());
    ASSERT_FALSE(studies.isNull());
    EXPECT_EQ(open.size(), studies.size());
    EXPECT_NE(open, studies) << "a panel is shown";
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 2);
    EXPECT_EQ(runBench({"stations", "--until", "nowhere", "--screenshots", folder.path()}).exitCode, 2);
}

void expectSentence(const Outcome& outcome, int code) {
    EXPECT_EQ(outcome.exitCode, code) << outcome.errors.toStdString();
    EXPECT_GT(outcome.errors.size(), 20);
}

TEST_F(ViewerProgram, ExitCodesTellWhatWasWrong) {
    expectSentence(runViewer({"--view", "sideways"}), 2);
    expectSentence(runViewer({"--preset", "no-such-preset"}), 2);
    expectSentence(runViewer({}, {"DISPLAY=", "WAYLAND_DISPLAY=", "QT_QPA_PLATFORM="}), 4);
    // A display that was there once; asked for by name, too.
    expectSentence(runViewer({}, {"DISPLAY=:4711", "WAYLAND_DISPLAY=", "QT_QPA_PLATFORM="}), 4);
    expectSentence(runViewer({}, {"DISPLAY=:4711", "WAYLAND_DISPLAY=", "QT_QPA_PLATFORM=xcb"}), 4);
    EXPECT_EQ(runViewer({"--version"}, {"DISPLAY="}).exitCode, 0);
}

TEST_F(ViewerProgram, RefusesAScriptAndSaysWhoHasIt) {
    const Outcome outcome = runViewer({"--script", "orbit"}, {"DISPLAY="});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_TRUE(outcome.errors.startsWith("macula-viewer: ")) << outcome.errors.toStdString();
    EXPECT_TRUE(outcome.errors.contains("macula-viewer-bench")) << outcome.errors.toStdString();
}

TEST_F(ViewerBenchProgram, ExitCodesTellWhatWasWrong) {
    const auto expectTold = [](const Outcome& outcome, int code) {
        expectSentence(outcome, code);
        EXPECT_TRUE(outcome.errors.contains("macula-viewer-bench: ")) << outcome.errors.toStdString();
    };
    expectTold(runBench({}), 2);
    expectTold(runBench({"dance"}), 2);
    expectTold(runBench({"orbit", "--preset", "no-such-preset"}), 2);
    expectTold(runBench({"orbit", "/no/such/folder"}), 3);
    expectTold(runBench({"orbit", "--device", "no-such-device"}), 2);
    expectTold(runBench({"orbit"}, {"VK_ICD_FILENAMES=/nowhere.json", "VK_DRIVER_FILES=/nowhere.json"}), 4);
    expectTold(runBench({"orbit"}, {"DISPLAY=", "WAYLAND_DISPLAY=", "QT_QPA_PLATFORM="}), 4);
    EXPECT_EQ(runBench({"--version"}, {"DISPLAY="}).exitCode, 0);
}

// As a virtual display may: one that starts anew with its last client is away for a moment, this one for
// good.
TEST_F(ViewerProgram, LooksForTheDisplayWithoutLosingIt) {
    QProcess server;
    server.start(QStringLiteral("Xvfb"),
                 {"-displayfd", "1", "-screen", "0", "640x480x24", "-nolisten", "tcp", "-terminate"});
    if (!server.waitForStarted()) GTEST_SKIP() << "Xvfb does not start";
    while (!server.canReadLine()) ASSERT_TRUE(server.waitForReadyRead());
    const QString display = ":" + QString::fromLatin1(server.readAllStandardOutput()).trimmed();

    const Outcome outcome =
        runViewer({"--preset", "no-such-preset"}, {"DISPLAY=" + display, "QT_QPA_PLATFORM=xcb"});

    EXPECT_EQ(outcome.exitCode, 2) << outcome.errors.toStdString();
    EXPECT_TRUE(server.waitForFinished()) << "it was no display of the kind that this is about";
}

// Signals that the process catches: a bit each, of /proc.
quint64 caughtBy(qint64 process) {
    QFile status(QStringLiteral("/proc/%1/status").arg(process));
    if (!status.open(QIODevice::ReadOnly)) return 0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("SigCgt:")) return line.mid(7).trimmed().toULongLong(nullptr, 16);
    return 0;
}

// A shutdown: it ends in order, which saves, and does not fall over.
TEST_F(ViewerProgram, EndsInOrderWhenASignalAsksForIt) {
    const QTemporaryDir folder;
    for (const int number : {SIGTERM, SIGHUP, SIGINT}) {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("XDG_DATA_HOME"), folder.path());
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral(MACULA_VIEWER_PROGRAM),
                      {"--sessions", folder.path(), "--no-model", "--size", "320x240"});
        ASSERT_TRUE(process.waitForStarted());
        ASSERT_TRUE(waitUntil([&] { return (caughtBy(process.processId()) >> (number - 1) & 1) != 0; }));
        ASSERT_EQ(::kill(pid_t(process.processId()), number), 0);
        ASSERT_TRUE(process.waitForFinished(250'000));
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit) << number;
        EXPECT_EQ(process.exitCode(), 130) << process.readAllStandardError().toStdString();
    }
}

}  // namespace
}  // namespace macula::viewer
