#include "viewer/driven/changes_script.h"

#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMouseEvent>
#include <QScreen>
#include <array>
#include <cstdio>
#include <fstream>
#include <utility>

#include "base/exit_codes.h"
#include "viewer/program/startup.h"

namespace macula::viewer {

namespace {

constexpr int kShortestPauseMs = 100;
constexpr int kLongestPauseMs = 2000;
// Now and then so long that a model is found, and learns.
constexpr int kLongPauseOneIn = 5;
constexpr int kLongestLongPauseMs = 12'000;
constexpr int kSilenceMs = 60'000;
constexpr int kHandIntervalMs = 16;
constexpr int kSmallestPx = 260;
constexpr int kSizeSteps = 8;
constexpr int kSizeStepPx = 90;
// Where memory is read: the phantom as when first opened, in a window of one size, at rest for so long.
constexpr int kHomePx = 600;
constexpr int kAfreshAfterMs = 4'000;
constexpr int kHomeMs = 20'000;
constexpr double kFirstReadingOfTime = 0.2;

double residentMiB() {
    std::ifstream statm("/proc/self/statm");
    double pages = 0.0;
    double resident = 0.0;
    statm >> pages >> resident;
    return resident * 4096.0 / 1048576.0;
}

QJsonObject toJson(const std::map<std::string, std::int64_t>& counts) {
    QJsonObject json;
    for (const auto& [name, count] : counts) json.insert(QString::fromStdString(name), qint64(count));
    return json;
}

}  // namespace

ChangesScript::ChangesScript(MainWindow& window, ChangesScriptOptions options, QObject* parent)
    : QObject(parent), window_(window), options_(std::move(options)), random_(options_.seed) {
    next_.setSingleShot(true);
    connect(&next_, &QTimer::timeout, this, &ChangesScript::change);
    hand_.setInterval(kHandIntervalMs);
    connect(&hand_, &QTimer::timeout, this, &ChangesScript::drag);
    silence_.setSingleShot(true);
    silence_.setInterval(kSilenceMs);
    connect(&silence_, &QTimer::timeout, this, [this] {
        tellError(QStringLiteral("No picture came for a minute."));
        finish(exitCodeOf(ErrorCode::deviceNotUsable));
    });
    connect(&window_, &MainWindow::frameShown, this, &ChangesScript::onFrame);
    connect(&window_, &MainWindow::failed, this, [this](const Error& error) { finish(tellError(error)); });
}

void ChangesScript::start() {
    silence_.start();
}

void ChangesScript::onFrame(const live::FrameShown& frame) {
    silence_.start();
    ++pictures_[std::string(nameOf(frame.picture))];
    if (std::exchange(hasBegun_, true)) return;
    running_.start();
    heartbeat_.start();
    change();
}

int ChangesScript::below(int count) {
    return std::uniform_int_distribution<int>(0, count - 1)(random_);
}

void ChangesScript::change() {
    if (isDone_) return;
    const double seconds = double(running_.elapsed()) / 1000.0;
    if (seconds >= options_.seconds) return goHome([this] { report(); });
    if (!isReadEarly_ && seconds >= kFirstReadingOfTime * options_.seconds) {
        isReadEarly_ = true;
        return goHome([this] {
            residentMiBEarly_ = residentMiB();
            change();
        });
    }
    switch (below(12)) {
        case 0:
        case 1:
        case 2:
            chooseIn("Preset");
            break;
        case 3:
            chooseIn("Lights");
            break;
        case 4:
        case 5:
            trigger(below(3) == 0 ? "no-clip" : "clip-");
            break;
        case 6:
            // Most of the time in those that have a model.
            trigger(below(2) == 0 ? "look-cinematic" : "look-");
            break;
        case 7:
            ++changes_["size"];
            window_.resize(kSmallestPx + kSizeStepPx * below(kSizeSteps),
                           kSmallestPx + kSizeStepPx * below(kSizeSteps));
            break;
        case 8:
            ++changes_["study"];
            isPhantom_ = !isPhantom_;
            window_.open(isPhantom_ ? study::StudySource() : options_.study);
            break;
        default:
            ++changes_["drag"];
            dragsLeft_ = 5 + below(40);
            hand_.start();
    }
    const bool isLong = below(kLongPauseOneIn) == 0;
    next_.start(isLong ? kLongestPauseMs + below(kLongestLongPauseMs - kLongestPauseMs)
                       : kShortestPauseMs + below(kLongestPauseMs - kShortestPauseMs));
}

// Both readings are of one state: what is open otherwise, and how large the window is, is left to chance.
void ChangesScript::goHome(std::function<void()> then) {
    isPhantom_ = true;
    window_.resize(kHomePx, kHomePx);
    window_.open({});
    QTimer::singleShot(kAfreshAfterMs, this, [this] { trigger("show-afresh"); });
    QTimer::singleShot(kHomeMs, this, std::move(then));
}

void ChangesScript::chooseIn(const char* accessibleName) {
    for (QComboBox* box : window_.findChildren<QComboBox*>()) {
        if (box->accessibleName() != QLatin1String(accessibleName) || !box->isEnabled()) continue;
        ++changes_[accessibleName];
        const int index = below(box->count());
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
    }
}

void ChangesScript::trigger(const char* prefix) {
    QList<QAction*> actions;
    for (QAction* action : window_.findChildren<QAction*>()) {
        if (action->objectName().startsWith(QLatin1String(prefix)) && action->isEnabled()) actions << action;
    }
    if (actions.isEmpty()) return;
    ++changes_[prefix];
    actions[below(int(actions.size()))]->trigger();
}

void ChangesScript::drag() {
    VulkanWindow& target = window_.viewport().window();
    const auto send = [&](QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons held) {
        QMouseEvent event(type, at_, target.mapToGlobal(at_), button, held, Qt::NoModifier);
        QCoreApplication::sendEvent(&target, &event);
    };
    if (at_.isNull()) {
        at_ = QPointF(target.width() / 2.0, target.height() / 2.0);
        send(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton);
    }
    at_ += QPointF(7.0, 3.0);
    send(QEvent::MouseMove, Qt::NoButton, Qt::LeftButton);
    if (--dragsLeft_ > 0) return;
    hand_.stop();
    send(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton);
    at_ = QPointF();
}

void ChangesScript::report() {
    heartbeat_.stop();
    const QJsonObject json{
        {"seconds", double(running_.elapsed()) / 1000.0},
        {"changes", toJson(changes_)},
        {"pictures", toJson(pictures_)},
        {"longestUiStallMs", heartbeat_.longestStallMs()},
        {"uiStallsOver50Ms", qint64(heartbeat_.noticed())},
        {"uiBeats", qint64(heartbeat_.beats())},
        {"residentMiBAfterAFifth", residentMiBEarly_},
        {"residentMiBAtTheEnd", residentMiB()},
    };
    std::fputs(QJsonDocument(json).toJson(QJsonDocument::Indented).constData(), stdout);
    std::fflush(stdout);
    finish(kExitDone);
}

void ChangesScript::finish(int exitCode) {
    if (std::exchange(isDone_, true)) return;
    next_.stop();
    hand_.stop();
    silence_.stop();
    Q_EMIT finished(exitCode);
}

}  // namespace macula::viewer
