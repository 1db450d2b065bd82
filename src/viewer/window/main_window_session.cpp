// What of a study is kept for the next time it is opened, and how it comes back.
#include <QDockWidget>
#include <chrono>
#include <optional>
#include <utility>

#include "live/store/study_keeper.h"
#include "viewer/jobs/post.h"
#include "viewer/language/core_words.h"
#include "viewer/panes/tool_box.h"
#include "viewer/presets/preset_library.h"
#include "viewer/second/second_volume_bar.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

namespace {

// A program that is killed loses no more: of what was chosen or measured, and of where the camera is.
constexpr std::chrono::milliseconds kChangeKeptAfter{300};
constexpr std::chrono::milliseconds kStateKeptEvery{5000};
constexpr std::chrono::milliseconds kWorkIsKeptWithin{3000};  // a desktop that logs out waits no longer

}  // namespace

// Called on another thread: the error crosses to this one's through its queue.
std::shared_ptr<live::StudyKeeper> MainWindow::makeKeeper() {
    if (!options_.sessions) return nullptr;
    std::optional<std::chrono::days> retention;
    if (options_.keepDays) retention.emplace(*options_.keepDays);
    return std::make_shared<live::StudyKeeper>(
        session::StoreOptions{.folder = *options_.sessions,
                              .modelCapBytes = std::uint64_t(options_.settings.modelCapMb) * 1'000'000},
        [this](const Error& error) {
            post(this, [this, error] {
                storeNote_ = inWindowsLanguage(error);
                storeNoteIsNew_ = !study().volume || loader_.loading();
                showNotes();
            });
        },
        retention);
}

// The render thread hands its model over as it ends, and the keeper saves it while this window, which it
// tells of faults, is still there.
MainWindow::~MainWindow() {
    keepState();
    // All that looks at the session goes before it does.
    hide();
    for (QDockWidget* panel : findChildren<QDockWidget*>()) delete panel;
    delete tools_;
    delete presetLibrary_;
    delete besideBar_;
    delete secondVolume_;
    delete takeCentralWidget();  // with the panes
    viewport_ = nullptr;
    loader_.setKeeper(nullptr);
    keeper_.reset();
}

std::optional<scene::StudyState> MainWindow::stateAsLeft(const study::OpenedStudy& study) {
    if (study.stateAsLeft.empty() || options_.restores == Restores::nothing) return std::nullopt;
    auto state = scene::studyStateFromJson(study.stateAsLeft, {});
    if (!state) {
        sessionNote_ = tr("How this study was left cannot be read; it is shown as when opened first.");
        return std::nullopt;
    }
    return *std::move(state);
}

// A camera that nobody has moved goes on fitting what is visible, in a window of another size too.
scene::StudyState MainWindow::stateToKeep() const {
    scene::StudyState now = state();
    if (!study().volume) return now;
    if (viewport_->framedFrom() == viewport_->firstFrom()) now.camera.reset();
    return now;
}

void MainWindow::connectKeeping() {
    loader_.setKeeper(keeper_);
    if (!keeper_) return;
    for (QTimer* timer : {&keeps_, &keepsChange_})
        connect(timer, &QTimer::timeout, this, &MainWindow::keepState);
    keeps_.start(kStateKeptEvery);
    keepsChange_.setSingleShot(true);
    keepsChange_.setInterval(kChangeKeptAfter);
    // Not begun anew: while a hand drags it is kept too.
    connect(&session_, &StudyEditor::changed, &keepsChange_, [this] {
        if (!keepsChange_.isActive()) keepsChange_.start();
    });
}

// What is there from the beginning is what a person has not changed: of it nothing is kept.
void MainWindow::beginToKeep() {
    kept_ = stateToKeep();
    keptText_ =
        std::make_shared<std::string>(study().stateAsLeft.empty() ? toJson(*kept_) : study().stateAsLeft);
}

void MainWindow::keepState() {
    if (!keeper_ || !study().volume || options_.restores == Restores::nothing) return;
    scene::StudyState now = stateToKeep();
    if (kept_ && *kept_ == now) return;
    keeper_->keepState(study().volume, toJson(now), keptText_);
    kept_ = std::move(now);
}

bool MainWindow::keepStateNow() {
    keepState();
    return !keeper_ || keeper_->waitUntilStatesAreKept(kWorkIsKeptWithin);
}

// What was measured is a person's work, and stays.
void MainWindow::showAfresh() {
    if (!study().volume) return;
    table_->cancel();
    sessionNote_.clear();
    session_.change(tr("Show afresh"), [this](scene::StudyState& next) {
        const scene::StudyState before = std::exchange(next, {});
        next.seriesDigest = before.seriesDigest;
        next.preset = usualPreset(*study().volume);
        next.lights = options_.lights;
        next.layout = before.layout;
        next.measurements = before.measurements;
        next.namedClips = before.namedClips;
        next.secondVolume = before.secondVolume;
        next.otherKeys = before.otherKeys;
    });
    viewport_->setParallel(false);
    viewport_->showFrom(viewport_->firstFrom());
    showNotes();
}

}  // namespace macula::viewer
