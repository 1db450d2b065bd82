// Views: what was chosen, shown in the menus, saved, and opened again.
#include <QFileDialog>
#include <algorithm>

#include "base/atomic_file.h"
#include "scene/drawing/drawing_of.h"
#include "viewer/presets/preset_box.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

namespace {

// In a list that is shown in a menu or a box; -1: it is none of them.
template <class Items, class Same>
int indexOf(const Items& items, const Same& isSame) {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const auto& item) { return isSame(*item); });
    return found == items.end() ? -1 : int(found - items.begin());
}

}  // namespace

scene::StudyState MainWindow::state() const {
    scene::StudyState state = shown_->state();
    if (study().volume) state.camera = toCamera(viewport_->camera());
    return state;
}

Result<void> MainWindow::setState(const scene::StudyState& state) {
    MACULA_TRY_VOID(shown_->take(state));
    sessionNote_.clear();  // it is not as it was left any more
    showNotes();
    if (state.camera) viewport_->showFrom(*state.camera);
    return {};
}

void MainWindow::showChosen() {
    const scene::StudyState& state = session_.state();
    presets_->choose(state.preset.get());
    looks_->choose(int(state.settings.look));
    shading_->setChecked(state.settings.shading == trace::Shading::headlight);
    // Number 0 is no clip; a clip of its own is none of the menu's, and "No Clip" takes it away.
    const int clip =
        indexOf(catalogue().clips, [&](const ClipPreset& c) { return state.clip && c == *state.clip; });
    const bool isAll = !state.clip && state.cuts.isNothing();
    clips_->choose(isAll ? 0 : clip < 0 ? -1 : clip + 1);
}

void MainWindow::askForView() {
    auto* dialog =
        new QFileDialog(this, tr("Open a view"), folders_.of(FolderKind::views), tr("Views (*.json)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    ask(dialog, FolderKind::views, [this](const QString& path) { openView(path); });
}

void MainWindow::askWhereToSaveView() {
    if (!study().volume)
        return messages_->showError({ErrorCode::usage,
                                     tr("There is no view to save yet.").toStdString(),
                                     {},
                                     tr("Open a study first.").toStdString()});
    auto* dialog =
        new QFileDialog(this, tr("Save the view"), folders_.of(FolderKind::views), tr("Views (*.json)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    dialog->selectFile(QStringLiteral("view.json"));
    scene::StudyState view = state();
    view.grid = scene::savedGridOf(*study().volume);
    ask(dialog, FolderKind::views,
        [this, json = toJson(view)](const QString& path) { saveView(path, json); });
}

void MainWindow::openView(const QString& path) {
    const auto shown = [&]() -> Result<void> {
        MACULA_TRY(const scene::StudyState state, scene::readStudyState(path.toStdString()));
        return setState(state);
    }();
    if (shown) {
        messages_->hide();
    } else {
        messages_->showError(shown.error());
    }
}

void MainWindow::saveView(const QString& path, const std::string& json) {
    const Result<void> written = writeTextAtomically(path.toStdString(), json);
    if (written) {
        messages_->hide();
    } else {
        messages_->showError(written.error());
    }
}

}  // namespace macula::viewer
