#include <unistd.h>
#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <cmath>
#include <cstdio>
#include <optional>

#include "base/exit_codes.h"
#include "viewer/driven/workday_script.h"
#include "viewer/program/startup.h"

namespace macula::viewer {

namespace {

constexpr int kResumedWithinMs = 300'000;
constexpr double kWindowMs = 1000.0;
constexpr double kSliceMs = 1500.0;
constexpr double kPictureMs = 4000.0;
constexpr double kResumedLaterMs = 1000.0;
constexpr double kStallMs = 50.0;
constexpr double kFramesPerSecond = 15.0;

std::optional<double> openingOf(const QJsonObject& report, const char* what) {
    const QJsonObject opening = report.value(QLatin1String("opening")).toObject();
    const double ms = opening.value(QLatin1String(what)).toDouble(-1.0);
    return ms >= 0.0 ? std::optional(ms) : std::nullopt;
}

class Table {
  public:
    Table() { text_ = QStringLiteral("| what | measured | wanted |\n|---|---|---|\n"); }

    // Nothing: it did not come.
    void addMs(const QString& what, std::optional<double> ms, std::optional<double> mostMs) {
        const QString measured = ms ? QStringLiteral("%1 ms").arg(*ms, 0, 'f', 0) : QStringLiteral("none");
        const QString wanted = mostMs ? QStringLiteral("at most %1 ms").arg(*mostMs, 0, 'f', 0) : QString();
        add(what, measured, wanted, !mostMs || (ms && *ms <= *mostMs));
    }
    void add(const QString& what, const QString& measured, const QString& wanted, bool isMet) {
        text_ += QStringLiteral("| %1 | %2 | %3 |\n")
                     .arg(what, measured,
                          wanted.isEmpty() || isMet ? wanted : wanted + QStringLiteral(": not met"));
    }
    QString text() const { return text_; }

  private:
    QString text_;
};

void addResumed(Table& table, const QJsonObject& resumed) {
    const auto read = openingOf(resumed, "studyReadMs");
    const auto later = [&](const char* what) -> std::optional<double> {
        const auto at = openingOf(resumed, what);
        return at && read ? std::optional(std::max(*at - *read, 0.0)) : std::nullopt;
    };
    table.addMs(QStringLiteral("resumed: study read, cold files"), read, {});
    table.addMs(QStringLiteral("resumed: first 3D picture after that"), later("pictureMs"), kResumedLaterMs);
    table.addMs(QStringLiteral("resumed: preview sharp after that"), later("modelMs"), {});
}

void addStalls(Table& table, const QJsonObject& session) {
    const double longest = session.value(QLatin1String("longestUiStallMs")).toDouble();
    QString where;
    int noticed = 0;
    for (const auto& value : session.value(QLatin1String("steps")).toArray()) {
        const QJsonObject step = value.toObject();
        const double ms = step.value(QLatin1String("longestUiStallMs")).toDouble();
        if (ms > kStallMs) ++noticed;
        if (ms == longest && where.isEmpty()) where = step.value(QLatin1String("step")).toString();
    }
    table.addMs(QStringLiteral("longest UI stall (%1)").arg(where), longest, kStallMs);
    table.add(QStringLiteral("steps with a longer stall than that"), QString::number(noticed), {}, true);
}

}  // namespace

double processAgeMs() {
    QFile stat(QStringLiteral("/proc/self/stat"));
    QFile uptime(QStringLiteral("/proc/uptime"));
    if (!stat.open(QIODevice::ReadOnly) || !uptime.open(QIODevice::ReadOnly)) return -1.0;
    // The name, in brackets, may hold anything; the start, in ticks, is the 20th word after it.
    const QByteArray line = stat.readAll();
    const QList<QByteArray> words = line.mid(line.lastIndexOf(')') + 2).split(' ');
    const double ticksPerSecond = double(sysconf(_SC_CLK_TCK));
    constexpr qsizetype kStart = 19;
    if (words.size() <= kStart || !(ticksPerSecond > 0.0)) return -1.0;
    const double startS = words[kStart].toDouble() / ticksPerSecond;
    const double nowS = uptime.readAll().split(' ').front().toDouble();
    return std::max(1000.0 * (nowS - startS), 0.0);
}

QString sessionTable(const QJsonObject& session, const QJsonObject& resumed) {
    Table table;
    const QJsonObject cold = session.value(QLatin1String("cold")).toObject();
    table.add(QStringLiteral("files taken out of the cache"),
              QStringLiteral("%1, %2 MiB, %3 % still in it")
                  .arg(cold.value(QLatin1String("files")).toInt())
                  .arg(cold.value(QLatin1String("mib")).toDouble())
                  .arg(100.0 * cold.value(QLatin1String("stillCachedShare")).toDouble(), 0, 'f', 0),
              {}, true);
    const double started = std::max(session.value(QLatin1String("startMs")).toDouble(), 0.0);
    const auto window = openingOf(session, "windowMs");
    table.addMs(QStringLiteral("window, since the program was started"),
                window ? std::optional(*window + started) : std::nullopt, kWindowMs);
    table.addMs(QStringLiteral("first slice, cold files"), openingOf(session, "sliceMs"), kSliceMs);
    table.addMs(QStringLiteral("first 3D picture, cold files"), openingOf(session, "pictureMs"), kPictureMs);
    table.addMs(QStringLiteral("preview sharp enough to be shown"), openingOf(session, "modelMs"), {});
    if (!resumed.isEmpty()) addResumed(table, resumed);
    addStalls(table, session);
    const QJsonObject orbit = session.value(QLatin1String("orbit")).toObject();
    const double rate = orbit.value(QLatin1String("framesPerSecond")).toDouble();
    table.add(QStringLiteral("orbit at %1 x %2 beside three slices")
                  .arg(orbit.value(QLatin1String("width")).toInt())
                  .arg(orbit.value(QLatin1String("height")).toInt()),
              QStringLiteral("%1 frames/s").arg(rate), QStringLiteral("at least 15 frames/s"),
              rate >= kFramesPerSecond);
    table.add(QStringLiteral("pose to picture, median and 95th"),
              QStringLiteral("%1, %2 ms")
                  .arg(orbit.value(QLatin1String("latencyMedianMs")).toDouble())
                  .arg(orbit.value(QLatin1String("latency95thMs")).toDouble()),
              {}, true);
    return table.text();
}

int reportSession(int code, const QJsonObject& session, const QStringList& arguments) {
    QJsonObject resumed;
    if (code == kExitDone) {
        QProcess again;
        again.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        again.start(QCoreApplication::applicationFilePath(), arguments);
        const bool ended = again.waitForFinished(kResumedWithinMs);
        if (!ended) again.kill();
        resumed = QJsonDocument::fromJson(again.readAllStandardOutput()).object();
        if (!ended || again.exitStatus() != QProcess::NormalExit || again.exitCode() != 0 ||
            resumed.isEmpty()) {
            tellError(QStringLiteral("The study could not be opened again."));
            code = exitCodeOf(ErrorCode::deviceNotUsable);
        }
    }
    QJsonObject all = session;
    all.insert(QStringLiteral("resumed"), resumed);
    std::fputs(sessionTable(session, resumed).toUtf8().constData(), stderr);
    std::fputs(QJsonDocument(all).toJson(QJsonDocument::Indented).constData(), stdout);
    std::fflush(stdout);
    return code;
}

}  // namespace macula::viewer
