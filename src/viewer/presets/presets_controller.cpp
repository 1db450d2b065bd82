#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/presets/presets_controller.h"

#include <QDialog>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <algorithm>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "pipeline/volume/transfer_function_json.h"
#include "pipeline/volume/window.h"
#include "scene/drawing/drawing_of.h"
#include "scene/transfer/same_transfer.h"
#include "viewer/editor/study_editor.h"
#include "viewer/presets/preset_box.h"
#include "viewer/presets/preset_comparison.h"
#include "viewer/presets/preset_gallery.h"
#include "viewer/presets/preset_library.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_texts.h"
#include "viewer/status/study_notes.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

namespace {

constexpr int kComparedPx = 720;  // of the longer side; small enough to draw both soon

QString titleOf(const LibraryPreset& preset) {
    return titleOr(preset.function->title, preset.function->name);
}

// In a menu an ampersand would mark a shortcut letter.
QString inMenu(QString title) {
    return title.replace(QLatin1Char('&'), QLatin1String("&&"));
}

// A null volume: nothing is open.
void putPreset(const LibraryPreset& preset, const Volume* volume, scene::StudyState& next) {
    if (volume != nullptr && preset.own && preset.own->seen) return live::use(*preset.own, *volume, next);
    next.preset = preset.function;
    // Projections use the preset as a window, and each projection look has its own.
    if (const trace::Look look = next.settings.look; volume != nullptr && trace::isProjection(look))
        next.windows.at(std::size_t(look)) = presetWindow(*next.preset, *volume);
}

}  // namespace

PresetsController::PresetsController(const WindowContext& context,
                                     const std::shared_ptr<live::StudyKeeper>& keeper,
                                     std::function<scene::StudyState()> stateNow)
    : QObject(&context.window),
      context_(context),
      library_(new PresetLibrary(context.session, keeper, this)),
      gallery_(new PresetGallery(context.session, *library_, std::move(stateNow))) {
    connect(gallery_, &PresetGallery::useAsked, this, &PresetsController::use);
    connect(gallery_, &PresetGallery::compareAsked, this, &PresetsController::compare);
    connect(gallery_, &PresetGallery::exportAsked, this, &PresetsController::askWhereToExport);
    connect(gallery_, &PresetGallery::importAsked, this, &PresetsController::askForFile);
    connect(gallery_, &PresetGallery::failed, &context_.notifications, &Notifications::showError);
    connectLibrary();
}

// After a change of the same study's state.
void PresetsController::onChanged(const scene::StudyState& before) {
    const scene::StudyState& now = context_.session.state();
    if (now.preset == before.preset) return;
    if (context_.session.hasStudy() && now.preset)
        context_.notes.showIfOther(NoteOn::preset,
                                   presetWarning(*now.preset, *context_.session.study().volume));
    showChosen();
}

void PresetsController::connectLibrary() {
    connect(library_, &PresetLibrary::imported, this,
            [this](const QStringList& titles, const QStringList& notes) {
                context_.notifications.showDone(
                    tr("Kept as presets of your own: %1.").arg(titles.join(QStringLiteral(", "))), notes);
            });
    connect(library_, &PresetLibrary::failed, this,
            [this](const Error& error) { context_.notifications.fail(error); });
    const auto offer = [this] {
        if (box_ == nullptr) return;
        box_->fillAnew();
        showChosen();
    };
    connect(&context_.session, &StudyEditor::presetsChanged, this, offer);
    connect(&context_.session, &StudyEditor::studyShown, this, offer);
}

// Filled whenever it opens, for the volume that is open then.
void PresetsController::addMenu(QMenuBar& bar) {
    QMenu* menu = bar.addMenu(tr("&Preset"));
    menu->setObjectName(QStringLiteral("preset-choice"));
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(*menu); });
    fillMenu(*menu);
}

void PresetsController::addFileAction(QMenu& file) {
    file.addAction(tr("Save P&reset…"), this, &PresetsController::askWhereToSaveShown)
        ->setToolTip(tr("The transfer function, for other studies and programs"));
}

void PresetsController::addBox(QToolBar& bar) {
    box_ = new PresetBox(*library_, &bar);
    bar.addWidget(new QLabel(tr(" Preset "), &bar));
    bar.addWidget(box_);
    connect(box_, &PresetBox::chosen, this, &PresetsController::use);
    followState(context_.session, box_, [this] { showLook(); });
    // Connected last: it shows all notes, including those of the second volume.
    connect(&context_.session, &StudyEditor::changed, this, &PresetsController::onChanged);
}

void PresetsController::showChosen() {
    box_->choose(context_.session.state().preset.get());
}

void PresetsController::showLook() {
    box_->setToolTip(trace::isProjection(context_.session.state().settings.look)
                         ? tr("In this look a preset that is chosen gives the window only")
                         : tr("What is seen, and in which colours"));
}

void PresetsController::fillMenu(QMenu& menu) {
    menu.clear();
    // clear() does not delete submenus.
    for (QMenu* inner : menu.findChildren<QMenu*>(Qt::FindDirectChildrenOnly)) delete inner;
    const auto& shown = context_.session.state().preset;
    const auto add = [&](QMenu& to, const LibraryPreset& preset) {
        QAction* action = to.addAction(inMenu(titleOf(preset)), this, [this, preset] { use(preset); });
        action->setCheckable(true);
        action->setChecked(shown && scene::isSame(*shown, *preset.function));
    };
    const std::vector<LibraryPreset> own = library_->own();
    for (const LibraryPreset& preset : own) add(menu, preset);
    if (!own.empty()) menu.addSeparator();
    QMenu* others = nullptr;
    for (const LibraryPreset& preset : library_->builtIn()) {
        const bool fits = library_->fits(*preset.function);
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
    menu.addAction(tr("&Import…"), this, &PresetsController::askForFile)
        ->setToolTip(tr("Of Macula, 3D Slicer, ParaView, VolView, MITK, Horos or OsiriX"));
}

void PresetsController::use(const LibraryPreset& preset) {
    const auto& volume = context_.session.study().volume;
    context_.session.change(tr("Preset"),
                            [&](scene::StudyState& next) { putPreset(preset, volume.get(), next); });
    if (volume && preset.own && preset.own->seen && preset.own->seen->camera)
        context_.viewport.showFrom(live::cameraIn(*preset.own->seen->camera, *volume));
    library_->noteUsed(preset.ref);
    context_.focusPicture();
}

void PresetsController::askForFile() {
    auto* dialog = context_.files.toOpen(FolderKind::presets, tr("Import presets"),
                                         tr("Presets (*.json *.vp *.xml *.mrml *.plist);;All files (*)"));
    context_.files.ask(dialog, FolderKind::presets,
                       [this](const QString& path) { library_->importFile(path.toStdString()); });
}

void PresetsController::askWhereToExport(const LibraryPreset& preset) {
    auto* dialog = context_.files.toSave(
        FolderKind::presets, tr("Export the preset"), tr("Presets (*.json)"), QStringLiteral("json"),
        QString::fromStdString(preset.function->name) + QStringLiteral(".json"));
    context_.files.ask(dialog, FolderKind::presets, [this, ref = preset.ref](const QString& path) {
        context_.notifications.showOutcome(
            library_->exportTo(path.toStdString(), ref),
            tr("The preset is written to %1. Open it with --preset %1.").arg(path));
    });
}

void PresetsController::askWhereToSaveShown() {
    const auto& preset = context_.session.state().preset;
    if (!context_.notifications.refuseUnless(preset != nullptr, tr("There is no preset to save yet.")))
        return;
    auto* dialog = context_.files.toSave(FolderKind::presets, tr("Save the preset"), tr("Presets (*.json)"),
                                         QStringLiteral("json"),
                                         QString::fromStdString(preset->name) + QStringLiteral(".json"));
    context_.files.ask(dialog, FolderKind::presets, [this, json = toJson(*preset)](const QString& path) {
        context_.notifications.showOutcome(
            writeTextAtomically(path.toStdString(), json),
            tr("The preset is written to %1. Open it with --preset %1.").arg(path));
    });
}

// Draws the view twice: as it is, and with the other preset, including that preset's clip and lights if any.
void PresetsController::compare(const LibraryPreset& preset) {
    const auto& volume = context_.session.study().volume;
    if (!volume) return;
    const QSize size =
        context_.viewport.pictureSize().scaled(QSize(kComparedPx, kComparedPx), Qt::KeepAspectRatio);
    const scene::StudyState& now = context_.session.state();
    scene::StudyState other = now;
    putPreset(preset, volume.get(), other);
    const auto picture = [&](scene::Drawing drawing) {
        pictures::ViewPicture view;
        view.volume = volume;
        view.drawing = std::move(drawing);
        view.camera = toCamera(context_.viewport.camera());
        view.sizePx = {std::max(1, size.width()), std::max(1, size.height())};
        view.effort.quality = "draft";
        return view;
    };
    auto* dialog = new PresetComparison(
        {now.preset ? titleOr(now.preset->title, now.preset->name) : QString(),
         picture(context_.shown.drawing())},
        {titleOf(preset), picture(context_.shown.drawingOf(other))}, context_.device, &context_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &PresetComparison::secondChosen, this, [this, preset] { use(preset); });
    // A comparison must not stay open beside another study.
    connect(&context_.session, &StudyEditor::studyShown, dialog, &QDialog::reject);
    dialog->show();
}

}  // namespace macula::viewer
