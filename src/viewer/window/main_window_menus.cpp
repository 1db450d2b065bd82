// Menus, bars, and what stands in them.
#include <QAction>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <algorithm>
#include <array>

#include "pipeline/volume/window.h"
#include "scene/camera/view_directions.h"
#include "viewer/browser/recent_menu.h"
#include "viewer/browser/study_browser.h"
#include "viewer/editor/undo_actions.h"
#include "viewer/keys/keys.h"
#include "viewer/language/core_words.h"
#include "viewer/presets/preset_box.h"
#include "viewer/quality/quality_control.h"
#include "viewer/settings/key_book.h"
#include "viewer/status/status_texts.h"
#include "viewer/window/help_boxes.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

namespace {

QString asText(std::string_view text) {
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

// With a capital.
QString asTitle(const std::string& name) {
    QString title = titleInWindowsLanguage(name);
    if (!title.isEmpty()) title[0] = title[0].toUpper();
    return title;
}

template <class Item>
void fill(QComboBox& box, const std::vector<std::shared_ptr<const Item>>& items) {
    for (const auto& item : items) {
        box.addItem(titleOr(item->title, item->name));
        box.setItemData(box.count() - 1, QString::fromStdString(item->name), Qt::ToolTipRole);
    }
}

// How values between voxels are found; of looks that show matter.
void addFilters(QMenu& menu, StudyEditor& session) {
    struct Choice {
        trace::Filter filter;
        QString text;
        QString hint;
    };
    const std::array choices{
        Choice{trace::Filter::trilinear, MainWindow::tr("&Linear"),
               MainWindow::tr("Values between eight voxels, as other viewers show them")},
        Choice{trace::Filter::smooth, MainWindow::tr("&Smooth"),
               MainWindow::tr("Fewest rings on skin and bone, and a voxel softer")},
        Choice{trace::Filter::sharp, MainWindow::tr("S&harp"),
               MainWindow::tr("Fine detail as with Linear, and somewhat fewer rings")}};
    auto* filters = new ChoiceMenu(MainWindow::tr("Between &Voxels"), &menu);
    for (const Choice& choice : choices)
        filters->addChoice(choice.text, QStringLiteral("between-voxels-") + asText(nameOf(choice.filter)))
            ->setToolTip(choice.hint);
    menu.addMenu(filters);
    QObject::connect(filters, &ChoiceMenu::changed, &session, [&session, choices](int index) {
        session.change(MainWindow::tr("Values between voxels"), [&](scene::StudyState& next) {
            next.settings.filter = choices[std::size_t(index)].filter;
        });
    });
    const auto show = [filters, choices, &session] {
        const trace::Settings& settings = session.state().settings;
        const auto shown = std::ranges::find(choices, settings.filter, &Choice::filter);
        filters->choose(shown == choices.end() ? -1 : int(shown - choices.begin()));
        for (QAction* action : filters->actions()) action->setEnabled(trace::showsMatter(settings.look));
    };
    QObject::connect(&session, &StudyEditor::changed, filters, show);
    QObject::connect(&session, &StudyEditor::studyShown, filters, show);
    show();
}

// How light that is brighter than the screen is shown; a projection shows values as they are.
void addToneMap(QMenu& menu, StudyEditor& session) {
    QAction* keepsHue = menu.addAction(MainWindow::tr("Keep &Hues of Highlights"));
    keepsHue->setObjectName(QStringLiteral("keep-hues"));
    keepsHue->setCheckable(true);
    keepsHue->setToolTip(MainWindow::tr(
        "What is too bright for the screen bleaches in its own hue; without it, contrast is higher. Not of "
        "projections"));
    QObject::connect(keepsHue, &QAction::triggered, &session, [&session](bool keeps) {
        session.change(MainWindow::tr("Hues of highlights"), [keeps](scene::StudyState& next) {
            next.settings.toneMap = keeps ? trace::ToneMap::hue : trace::ToneMap::neutral;
        });
    });
    const auto show = [keepsHue, &session] {
        keepsHue->setChecked(session.state().settings.toneMap == trace::ToneMap::hue);
        keepsHue->setEnabled(!trace::isProjection(session.state().settings.look));
    };
    QObject::connect(&session, &StudyEditor::changed, keepsHue, show);
    QObject::connect(&session, &StudyEditor::studyShown, keepsHue, show);
    show();
}

}  // namespace

void MainWindow::makeMenus() {
    makeFileMenu();
    makeEditMenu();
    makeViewMenu();
    makePresetMenu();
    makeLookMenu();
    makeClipMenu();

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addAction(tr("&Keys and Mouse"), this, [this] { showKeys(this); })
        ->setShortcut(keyOf(KeyAction::help));
    help->addAction(tr("&About Macula"), this, [this] { showAbout(this); });
}

void MainWindow::makeFileMenu() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->setToolTipsVisible(true);
    QAction* openFolder = file->addAction(tr("&Open Folder…"), this, &MainWindow::askForFolder);
    openFolder->setShortcut(keyOf(KeyAction::openFolder));
    openFolder->setToolTip(tr("Open the best volume in a folder of DICOM files"));
    QAction* openFile = file->addAction(tr("Open &File…"), this, &MainWindow::askForFile);
    openFile->setShortcut(keyOf(KeyAction::openFile));
    openFile->setToolTip(tr("Open the series of an image, a DICOMDIR, or a NIfTI, NRRD or MetaImage file"));
    file->addMenu(recent_);
    QAction* phantom = file->addAction(tr("Open &Phantom"), this, [this] { open(std::nullopt); });
    phantom->setToolTip(tr("Open the built-in phantom study"));
    addSecondToFile(*file);
    file->addSeparator();
    QAction* openView = file->addAction(tr("Open &View…"), this, &MainWindow::askForView);
    openView->setShortcut(keyOf(KeyAction::openView));
    openView->setToolTip(tr("Show this study as it was when a view was saved"));
    QAction* saveView = file->addAction(tr("&Save View…"), this, &MainWindow::askWhereToSaveView);
    saveView->setShortcut(keyOf(KeyAction::saveView));
    saveView->setToolTip(tr("All that was chosen, and the camera, for another time"));
    addPresentationsTo(*file);
    file->addSeparator();
    QAction* savePicture = file->addAction(tr("Save &Picture…"), this, &MainWindow::askForPicture);
    savePicture->setObjectName(QStringLiteral("save-picture"));
    savePicture->setShortcut(keyOf(KeyAction::savePicture));
    savePicture->setToolTip(tr("Draw what is seen in 3D at any size and quality, without names"));
    QAction* saveMeasurements =
        file->addAction(tr("Save &Measurements…"), this, &MainWindow::askWhereToSaveMeasurements);
    saveMeasurements->setObjectName(QStringLiteral("save-measurements"));
    saveMeasurements->setShortcut(keyOf(KeyAction::saveMeasurements));
    saveMeasurements->setToolTip(tr("As a table (CSV) or JSON, in mm, degrees and the unit of the study"));
    addOutputActions(*file);
    file->addAction(tr("Save P&reset…"), this, &MainWindow::askWhereToSavePreset)
        ->setToolTip(tr("The transfer function, for other studies and programs"));
    file->addSeparator();
    QAction* quit = file->addAction(tr("&Quit"), this, &QWidget::close);
    quit->setShortcut(keyOf(KeyAction::quit));
}

void MainWindow::makeEditMenu() {
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    edit->addAction(&undo_->undo());
    edit->addAction(&undo_->redo());
    edit->addSeparator();
    QAction* find = edit->addAction(tr("&Find a Study…"), this, [this] {
        if (!browserShown_->isChecked()) browserShown_->trigger();
        browser_->focusSearch();
    });
    find->setShortcut(keyOf(KeyAction::find));
    edit->addSeparator();
    QAction* clear = edit->addAction(tr("Remove All &Measurements"), this, [this] {
        session_.change(tr("Remove measurements"),
                        [](scene::StudyState& next) { next.measurements.clear(); });
    });
    clear->setObjectName(QStringLiteral("remove-measurements"));
    edit->addSeparator();
    QAction* settings = edit->addAction(tr("&Settings…"), this, &MainWindow::askForSettings);
    settings->setObjectName(QStringLiteral("settings"));
    settings->setShortcut(keyOf(KeyAction::settings));
    settings->setToolTip(tr("Language, look, keys, and what is kept"));
}

void MainWindow::makeViewMenu() {
    // The keys of this menu are handled by the viewport, so that they do nothing while a list has the focus.
    QMenu* view = menuBar()->addMenu(tr("&View"));
    const auto withKey = [](QAction* item, KeyAction action) {
        KeyBook::showPictureKey(*item, keyOf(action));
        return item;
    };
    for (const KeyRow& row : kKeys) {
        if (const auto direction = viewDirectionOf(row.action))
            withKey(view->addAction(asTitle(scene::nameOf(*direction)), this,
                                    [this, from = *direction] { viewport_->showFrom(from); }),
                    row.action);
    }
    view->addSeparator();
    withKey(view->addAction(tr("Fit what is visible"), this, [this] { viewport_->fit(); }), KeyAction::fit);
    QAction* afresh = view->addAction(tr("Show as when first opened"), this, &MainWindow::showAfresh);
    afresh->setObjectName(QStringLiteral("show-afresh"));
    afresh->setToolTip(
        tr("Preset, lights, clip, look and camera that a study has which nobody has seen yet"));
    view->addSeparator();
    for (const LayoutRow& row : kLayouts) {
        QAction* action = view->addAction(
            inWindowsLanguage(QString::fromLatin1(row.title)), this, [this, layout = row.layout] {
                session_.change(tr("Panes"), [layout](scene::StudyState& next) { next.layout = layout; });
            });
        action->setShortcut(keyOf(row));
    }
    addSecondToView(*view);
    view->addSeparator();
    view->addActions(panels_);
    view->addSeparator();
    names_ = withKey(view->addAction(tr("Patient and study over the picture")), KeyAction::names);
    names_->setObjectName(QStringLiteral("names"));
    names_->setCheckable(true);
    names_->setChecked(true);
    connect(names_, &QAction::triggered, this, &MainWindow::showNames);
    addView3dActions(*view);
    QAction* gaze = view->addAction(tr("Trace where the pointer is, while moving"));
    gaze->setCheckable(true);
    gaze->setChecked(true);
    connect(gaze, &QAction::triggered, viewport_, &Viewport::setGazeFollowsPointer);
    addQualityActions(*view);
    addHeadsetAction(*view);
}

void MainWindow::makeLookMenu() {
    looks_ = new ChoiceMenu(tr("&Look"), this);
    menuBar()->addMenu(looks_);
    for (const trace::LookTraits& look : trace::kLooks) {
        looks_
            ->addChoice(titleInWindowsLanguage(std::string(look.title)),
                        QStringLiteral("look-") + asText(look.name))
            ->setShortcut(keyOf(look.look));
    }
    looks_->addSeparator();
    shading_ = looks_->addAction(tr("&Shade Ray Cast"));
    shading_->setObjectName(QStringLiteral("shade-ray-cast"));
    shading_->setCheckable(true);
    shading_->setShortcut(keyOf(KeyAction::shade));
    shading_->setToolTip(tr("Light ray casts from the eye, as much as the preset says"));
    shading_->setChecked(true);
    addFilters(*looks_, session_);
    addToneMap(*looks_, session_);
    QAction* window = looks_->addAction(tr("Reset &Window"), this, [this] {
        session_.change(tr("Window"), [](scene::StudyState& next) {
            next.windows.at(std::size_t(next.settings.look)).reset();
        });
    });
    window->setObjectName(QStringLiteral("reset-window"));
    window->setShortcut(keyOf(KeyAction::resetWindow));
    window->setToolTip(tr("Of the values: that of the series"));
    resetWindow_ = window;
    connect(viewport_, &Viewport::windowDragged, this, [this](QPointF byHeights) {
        const auto from = shown_->drawing().settings.window;
        if (!from || !session_.hasStudy()) return;
        session_.drag(tr("Window"), [&](scene::StudyState& next) {
            next.windows.at(std::size_t(next.settings.look)) =
                scene::dragged(*from, {byHeights.x(), byHeights.y()}, *session_.study().volume);
        });
    });
    connect(&viewport_->window(), &VulkanWindow::dragEnded, &session_, &StudyEditor::endDrag);
    connect(looks_, &ChoiceMenu::changed, this, [this](int index) {
        session_.change(tr("Look"), [index](scene::StudyState& next) {
            next.settings.look = trace::kLooks.at(std::size_t(index)).look;
        });
    });
    connect(shading_, &QAction::triggered, this, [this](bool shaded) {
        session_.change(tr("Shading"), [shaded](scene::StudyState& next) {
            next.settings.shading = shaded ? trace::Shading::headlight : trace::Shading::none;
        });
    });
}

void MainWindow::makeClipMenu() {
    clips_ = new ChoiceMenu(tr("&Clip"), this);
    menuBar()->addMenu(clips_);
    clips_->addAction(&table_->action());
    addClipActions(*clips_);
    clips_->addSeparator();
    clips_->addChoice(tr("&No Clip"), QStringLiteral("no-clip"))->setShortcut(keyOf(KeyAction::noClip));
    for (const auto& clip : catalogue().clips) {
        clips_->addChoice(titleOr(clip->title, clip->name),
                          QStringLiteral("clip-") + QString::fromStdString(clip->name));
    }
    connect(clips_, &ChoiceMenu::changed, this, [this](int index) {
        session_.change(tr("Clip"), [&](scene::StudyState& next) {
            next.clip.reset();
            if (index == 0) next.cuts = {};
            if (index > 0) next.clip = *catalogue().clips.at(std::size_t(index) - 1);  // 0 is no clip
        });
    });
}

void MainWindow::makeToolBar() {
    QToolBar* bar = addToolBar(tr("Look"));
    bar->setMovable(false);
    presets_ = new PresetBox(*presetLibrary_, bar);
    lights_ = new QComboBox(bar);
    lights_->setAccessibleName(tr("Lights"));
    lights_->setPlaceholderText(tr("Own"));
    fill(*lights_, catalogue().lights);
    bar->addWidget(new QLabel(tr(" Preset "), bar));
    bar->addWidget(presets_);
    bar->addWidget(new QLabel(tr("  Lights "), bar));
    bar->addWidget(lights_);
    bar->addWidget(new QLabel(QStringLiteral("   "), bar));
    volumes_ = new VolumeChoice(bar);
    volumesInBar_ = bar->addWidget(volumes_);
    volumesInBar_->setObjectName(QStringLiteral("volumes-in-bar"));
    volumesInBar_->setVisible(false);
    bar->addWidget(new QLabel(QStringLiteral("  "), bar));
    connect(volumes_, &VolumeChoice::chosen, this, &MainWindow::openFound);
    description_ = new ElidingLabel(tr("Series"), bar);
    description_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(description_);
    bar->addWidget(quality_);

    connect(presets_, &PresetBox::chosen, this, &MainWindow::usePreset);
    connect(lights_, &QComboBox::activated, this, [this](int index) {
        session_.change(tr("Lights"), [&](scene::StudyState& next) {
            next.lights = catalogue().lights[std::size_t(index)];
        });
        focusPicture();
    });
}

void MainWindow::makeStatusBar() {
    fidelity_ = new ElidingLabel(tr("How true the picture is"));
    modelText_ = new ElidingLabel(tr(
        "The preview with all pixels that is shown while a hand moves; it gets sharper while nothing moves"));
    pictureText_ = new ElidingLabel(tr("Pixels, pictures per second"));
    volumeText_ = new ElidingLabel(tr("Voxels and their size"));
    deviceText_ = new ElidingLabel(tr("Device"));
    // How far the picture can be trusted is the last thing to be cut short.
    fidelity_->keepLongest();
    statusBar()->addWidget(loading_);
    statusBar()->addWidget(searching_);
    statusBar()->addWidget(segmenting_);
    statusBar()->addWidget(exporting_);
    statusBar()->addWidget(filming_);
    statusBar()->addWidget(savingModel_);
    statusBar()->addWidget(converging_);
    statusBar()->addWidget(cuttingBar_);
    badge_ = new FidelityBadge;
    // A message hides what it takes the place of, and whatever shows itself again would lie over it.
    auto* badgePlace = new QWidget;
    auto* row = new QHBoxLayout(badgePlace);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(badge_);
    statusBar()->addWidget(badgePlace);
    statusBar()->addWidget(fidelity_, 1);
    statusBar()->addPermanentWidget(modelText_);
    statusBar()->addPermanentWidget(pictureText_);
    statusBar()->addPermanentWidget(volumeText_);
    statusBar()->addPermanentWidget(deviceText_);
    fidelity_->setFullText(tr("No study is open"));
}

}  // namespace macula::viewer
