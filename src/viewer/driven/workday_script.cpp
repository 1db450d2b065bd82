#include "viewer/driven/workday_script.h"

#include <QJsonArray>
#include <cmath>
#include <variant>

#include "base/exit_codes.h"
#include "viewer/program/startup.h"

namespace macula::viewer {

namespace {

constexpr int kPictureWithinMs = 300'000;

double rounded(double value) {
    return std::round(10.0 * value) / 10.0;
}

QJsonObject toJson(const ColdFiles& cold) {
    const double bytes = double(cold.bytes);
    return {{"files", qint64(cold.files)},
            {"mib", rounded(bytes / 1048576.0)},
            {"stillCachedShare", cold.bytes == 0 ? 0.0 : double(cold.bytesStillCached) / bytes}};
}

}  // namespace

WorkdayScript::WorkdayScript(MainWindow& window, WorkdayScriptOptions options, QObject* parent)
    : QObject(parent),
      window_(window),
      options_(std::move(options)),
      opening_(window),
      hand_(window),
      orbit_(window) {
    connect(&window_, &MainWindow::failed, this, &WorkdayScript::fail);
    connect(&window_.viewport(), &Viewport::rendered, this, [this](const live::RenderEvent& event) {
        if (const auto* ready = std::get_if<live::DeviceReady>(&event))
            device_ = QString::fromStdString(ready->name);
    });
}

std::vector<DrivenStep> WorkdayScript::steps() {
    const auto has = [this](const char* what) {
        return opening_.toJson().value(QLatin1String(what)).toDouble() >= 0.0;
    };
    std::vector<DrivenStep> all;
    DrivenStep opens;
    opens.name = QStringLiteral("opening");
    opens.isDone = [has] { return has("pictureMs") && has("sliceMs") && has("studyReadMs"); };
    opens.patienceMs = kPictureWithinMs;
    all.push_back(std::move(opens));
    DrivenStep learns;
    learns.name = QStringLiteral("model");
    learns.isDone = [has] { return has("modelMs"); };
    learns.patienceMs = int(options_.modelSeconds * 1000.0);
    all.push_back(std::move(learns));
    if (options_.opensOnly) return all;
    for (DrivenStep& step : sessionSteps(window_, hand_, orbit_, options_.work))
        all.push_back(std::move(step));
    return all;
}

void WorkdayScript::start() {
    startMs_ = processAgeMs();
    if (options_.study) cold_ = dropFromCache(*options_.study);
    steps_ = std::make_unique<DrivenSteps>(steps());
    connect(steps_.get(), &DrivenSteps::ended, this, [this](const MeasuredStep& step) {
        if (step.name == QLatin1String("opening") && !step.isDone) {
            tellError(QStringLiteral("No picture came in time."));
            finish(exitCodeOf(ErrorCode::deviceNotUsable));
        }
    });
    connect(steps_.get(), &DrivenSteps::finished, this, [this] {
        bool isWhole = hand_.missing().isEmpty();
        for (const MeasuredStep& step : steps_->measured()) {
            // Looks without a model have none.
            if (step.isDone || step.name == QLatin1String("model")) continue;
            tellError(QStringLiteral("Not done: %1.").arg(step.name));
            isWhole = false;
        }
        for (const QString& name : hand_.missing()) tellError(QStringLiteral("Not there: %1.").arg(name));
        finish(isWhole ? kExitDone : kExitFault);
    });
    opening_.start();
    steps_->start();
}

QJsonObject WorkdayScript::report() const {
    const std::vector<MeasuredStep> measured = steps_ ? steps_->measured() : std::vector<MeasuredStep>();
    QJsonObject json{{"device", device_},
                     {"cold", toJson(cold_)},
                     {"startMs", std::round(startMs_)},
                     {"opening", opening_.toJson()},
                     {"longestUiStallMs", rounded(longestStallMs(measured))},
                     {"steps", toJson(measured)},
                     {"missing", QJsonArray::fromStringList(hand_.missing())}};
    if (!options_.opensOnly) json.insert(QStringLiteral("orbit"), orbit_.toJson());
    return json;
}

void WorkdayScript::fail(const Error& error) {
    finish(tellError(error));
}

void WorkdayScript::finish(int exitCode) {
    if (std::exchange(isDone_, true)) return;
    steps_->stop();
    Q_EMIT finished(exitCode);
}

}  // namespace macula::viewer
