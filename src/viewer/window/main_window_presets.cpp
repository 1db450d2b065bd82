// Presets: the library, the gallery and the menu, and what choosing one of them does.
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>

#include "pipeline/volume/window.h"
#include "scene/drawing/drawing_of.h"
#include "scene/transfer/same_transfer.h"
#include "viewer/presets/preset_box.h"
#include "viewer/presets/preset_comparison.h"
#include "viewer/presets/preset_gallery.h"
#include "viewer/presets/preset_library.h"
#include "viewer/status/status_texts.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

namespace {

constexpr int kComparedPx = 720;  // of the longer side: both are there soon

QString titleOf(const LibraryPreset& preset) {
    return titleOr(preset.function->title, preset.function->name);
}

// In a menu an ampersand marks a letter.
QString inMenu(QString title) {
    return title.replace(QLatin1Char('&'), QLatin1String("&&"));
}

// A null volume: nothing is open.
void use(const LibraryPreset& preset, const Volume* volume, scene::StudyState& next) {
    if (volume != nullptr && preset.own && preset.own->seen) return live::use(*preset.own, *volume, next);
    next.preset = preset.function;
    // In projections it is a window, and of those each look has its own.
    if (const trace::Look look = next.settings.look; volume != nullptr && trace::isProjection(look))
        next.windows.at(std::size_t(look)) = presetWindow(*next.preset, *volume);
}

}  // namespace

void MainWindow::makePresets() {
    presetLibrary_ = new PresetLibrary(session_, keeper_, this);
    gallery_ = new PresetGallery(session_, *presetLibrary_, [this] { return state(); });
    connect(gallery_, &PresetGallery::useAsked, this, &MainWindow::usePreset);
    connect(gallery_, &PresetGallery::compareAsked, this, &MainWindow::comparePreset);
    connect(gallery_, &PresetGallery::exportAsked, this, &MainWindow::askWhereToExportPreset);
    connect(gallery_, &PresetGallery::importAsked, this, &MainWindow::askForPresetFile);
    connect(gallery_, &PresetGallery::failed, messages_, &MessageBar::showError);
    connect(presetLibrary_, &PresetLibrary::imported, this,
            [this](const QStringList& titles, const QStringList& notes) {
                const QStringList told{
                    tr("Kept as presets of your own: %1.").arg(titles.join(QStringLiteral(", ")))};
                messages_->showNote((told + notes).join(QLatin1Char(' ')));
            });
    connect(presetLibrary_, &PresetLibrary::failed, this, [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    });
    const auto offer = [this] {
        if (presets_ == nullptr) return;  // the tool bar is not made yet
        presets_->fillAnew();
        showChosen();
    };
    connect(&session_, &StudyEditor::presetsChanged, this, offer);
    connect(&session_, &StudyEditor::studyShown, this, offer);
}

// Made anew whenever it opens: it is of the volume that is open then.
void MainWindow::makePresetMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Preset"));
    menu->setObjectName(QStringLiteral("preset-choice"));
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillPresetMenu(*menu); });
    fillPresetMenu(*menu);
}

void MainWindow::fillPresetMenu(QMenu& menu) {
    menu.clear();
    // Menus within a menu outlive its actions.
    for (QMenu* inner : menu.findChildren<QMenu*>(Qt::FindDirectChildrenOnly)) delete inner;
    const auto& shown = session_.state().preset;
    const auto add = [&](QMenu& to, const LibraryPreset& preset) {
        QAction* action = to.addAction(inMenu(titleOf(preset)), this, [this, preset] { usePreset(preset); });
        action->setCheckable(true);
        action->setChecked(shown && scene::isSame(*shown, *preset.function));
    };
    const std::vector<LibraryPreset> own = presetLibrary_->own();
    for (const LibraryPreset& preset : own) add(menu, preset);
    if (!own.empty()) menu.addSeparator();
    QMenu* others = nullptr;
    for (const LibraryPreset& preset : presetLibrary_->builtIn()) {
        const bool fits = presetLibrary_->fits(*preset.function);
        if (!fits && !others) {
            others = new QMenu(tr("For &Other Images"), &menu);
            others->setToolTipsVisible(true);
        }
        add(fits ? menu : *others, preset);
    }
    if (others) menu.addMenu(others);
    menu.addSeparator();
    menu.addAction(tr("Keep the &Curve…"), gallery_, &PresetGallery::askToSaveCurve)
        ->setToolTip(tr("The transfer function that is shown, as a preset of your own"));
    menu.addAction(tr("Keep All That Is &Seen…"), gallery_, &PresetGallery::askToSaveSeen)
        ->setToolTip(tr("Curve, look, lights, window, clip and camera, as a preset of your own"));
    menu.addAction(tr("&Import…"), this, &MainWindow::askForPresetFile)
        ->setToolTip(tr("Of Macula, 3D Slicer, ParaView, VolView, MITK, Horos or OsiriX"));
}

void MainWindow::usePreset(const LibraryPreset& preset) {
    session_.change(tr("Preset"), [&](scene::StudyState& next) { use(preset, study().volume.get(), next); });
    if (study().volume && preset.own && preset.own->seen && preset.own->seen->camera)
        viewport_->showFrom(live::cameraIn(*preset.own->seen->camera, *study().volume));
    presetLibrary_->noteUsed(preset.ref);
    focusPicture();
}

void MainWindow::askForPresetFile() {
    auto* dialog = new QFileDialog(this, tr("Import presets"), folders_.of(FolderKind::presets),
                                   tr("Presets (*.json *.vp *.xml *.mrml *.plist);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    ask(dialog, FolderKind::presets,
        [this](const QString& path) { presetLibrary_->importFile(path.toStdString()); });
}

void MainWindow::askWhereToExportPreset(const LibraryPreset& preset) {
    auto* dialog = new QFileDialog(this, tr("Export the preset"), folders_.of(FolderKind::presets),
                                   tr("Presets (*.json)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    dialog->selectFile(QString::fromStdString(preset.function->name) + QStringLiteral(".json"));
    ask(dialog, FolderKind::presets, [this, ref = preset.ref](const QString& path) {
        tellOfFile(presetLibrary_->exportTo(path.toStdString(), ref),
                   tr("The preset is written to %1. Open it with --preset %1.").arg(path));
    });
}

// The same view, once as it is and once under the other preset, whose clip and lights count where it has
// some.
void MainWindow::comparePreset(const LibraryPreset& preset) {
    if (!study().volume) return;
    const QSize size = viewport_->pictureSize().scaled(QSize(kComparedPx, kComparedPx), Qt::KeepAspectRatio);
    const scene::StudyState& now = session_.state();
    scene::StudyState other = now;
    use(preset, study().volume.get(), other);
    const auto picture = [&](scene::Drawing drawing) {
        pictures::ViewPicture view;
        view.volume = study().volume;
        view.drawing = std::move(drawing);
        view.camera = toCamera(viewport_->camera());
        view.sizePx = {std::max(1, size.width()), std::max(1, size.height())};
        view.effort.quality = "draft";
        return view;
    };
    auto* dialog = new PresetComparison(
        {now.preset ? titleOr(now.preset->title, now.preset->name) : QString(), picture(shown_->drawing())},
        {titleOf(preset), picture(shown_->drawingOf(other))}, options_.device, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &PresetComparison::secondChosen, this, [this, preset] { usePreset(preset); });
    // No picture is seen beside another study.
    connect(&session_, &StudyEditor::studyShown, dialog, &QDialog::reject);
    dialog->show();
}

}  // namespace macula::viewer
