#include "viewer/driven/workday_script.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <QJsonArray>
#include <algorithm>
#include <cmath>
#include <system_error>
#include <variant>
#include <vector>

#include "base/exit_codes.h"
#include "viewer/program/startup.h"

namespace macula::viewer {

namespace {

namespace fs = std::filesystem;

// Of a file that is open.
std::uint64_t bytesCached(int file, std::uint64_t bytes) {
    if (bytes == 0) return 0;
    void* mapped = mmap(nullptr, bytes, PROT_READ, MAP_SHARED, file, 0);
    if (mapped == MAP_FAILED) return bytes;  // nobody knows: the worse is told
    const auto page = std::uint64_t(sysconf(_SC_PAGESIZE));
    std::vector<unsigned char> pages((bytes + page - 1) / page);
    std::uint64_t cached = bytes;
    if (mincore(mapped, bytes, pages.data()) == 0) {
        const auto there = std::count_if(pages.begin(), pages.end(), [](auto p) { return (p & 1) != 0; });
        cached = std::min(bytes, std::uint64_t(there) * page);
    }
    munmap(mapped, bytes);
    return cached;
}

void drop(const fs::path& path, ColdFiles& cold) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0) return;
    struct stat status {};
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode)) {
        const auto bytes = std::uint64_t(std::max<off_t>(status.st_size, 0));
        fdatasync(file);  // pages that are not written yet stay
        posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
        ++cold.files;
        cold.bytes += bytes;
        cold.bytesStillCached += bytesCached(file, bytes);
    }
    close(file);
}

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

ColdFiles dropFromCache(const fs::path& path) {
    ColdFiles cold;
    std::error_code error;
    if (!fs::is_directory(path, error)) {
        drop(path, cold);
        return cold;
    }
    fs::recursive_directory_iterator at(path, fs::directory_options::skip_permission_denied, error);
    for (const fs::recursive_directory_iterator end; !error && at != end; at.increment(error)) {
        if (std::error_code unknown; at->is_regular_file(unknown)) drop(at->path(), cold);
    }
    return cold;
}

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
