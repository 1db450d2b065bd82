// What of a study is kept for the next time it is opened, and how it comes back.
#include <QMetaObject>
#include <utility>

#include "app/session/model_keeper.h"
#include "viewer/main_window.h"

namespace macula::viewer {

// Called on another thread: the error crosses to this one's through its queue.
std::shared_ptr<app::ModelKeeper> MainWindow::makeKeeper() {
    if (!options_.sessions) return nullptr;
    return std::make_shared<app::ModelKeeper>(
        session::StoreOptions{.folder = *options_.sessions}, [this](const Error& error) {
            QMetaObject::invokeMethod(
                this,
                [this, error] {
                    sessionNote_ = QString::fromStdString(error.message + " " + error.hint);
                    showNotes();
                },
                Qt::QueuedConnection);
        });
}

// The render thread hands its model over as it ends, and the keeper saves it while this window can still be
// told of a fault.
MainWindow::~MainWindow() {
    keepState();
    delete viewport_;
    viewport_ = nullptr;
    loader_.setKeeper(nullptr);
    keeper_.reset();
}

std::optional<app::StudyState> MainWindow::stateAsLeft() {
    if (study_.stateAsLeft.empty() || !options_.restoresState) return std::nullopt;
    auto state = app::studyStateFromJson(study_.stateAsLeft, {});
    if (!state) {
        sessionNote_ = tr("How this study was left cannot be read; it is shown as when opened first.");
        return std::nullopt;
    }
    return *std::move(state);
}

void MainWindow::keepState() {
    if (!keeper_ || !study_.volume || !options_.restoresState) return;
    app::StudyState now = state();
    if (kept_ && *kept_ == now) return;
    keeper_->keepState(study_.volume, app::toJson(now));
    kept_ = std::move(now);
}

void MainWindow::showAfresh() {
    if (!study_.volume) return;
    app::OpenedStudy study = study_;
    study.stateAsLeft.clear();
    showStudy(study);
}

}  // namespace macula::viewer
