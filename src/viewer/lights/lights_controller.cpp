#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/lights/lights_controller.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QScrollBar>
#include <QToolBar>
#include <algorithm>
#include <utility>

#include "base/atomic_file.h"
#include "pictures/view_picture.h"
#include "pipeline/trace/light_rig_json.h"
#include "scene/choice/lights_choice.h"
#include "scene/state/parameters.h"
#include "viewer/editor/study_editor.h"
#include "viewer/lights/lights_panel.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_texts.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

namespace {

pictures::ViewPicture seenIn(const WindowContext& context) {
    const QSize size = context.viewport.pictureSize();
    pictures::ViewPicture picture;
    picture.volume = context.session.study().volume;
    picture.drawing = context.shown.drawing();
    picture.camera = toCamera(context.viewport.camera());
    picture.sizePx = {std::max(1, size.width()), std::max(1, size.height())};
    return picture;
}

}  // namespace

LightsController::LightsController(const WindowContext& context)
    : QObject(&context.window),
      context_(context),
      editing_(context.session),
      tool_(context.session, editing_),
      panel_(new LightsPanel(context.session, editing_, &context.window)),
      scrolls_(new QScrollArea(&context.window)),
      metering_(this, {.ended = [this](const Result<double>& exposure) { useMetered(exposure); }}) {
    // Scrolls, because the panel is too tall for a small screen.
    scrolls_->setObjectName(QStringLiteral("lights-scrolls"));
    scrolls_->setFrameShape(QFrame::NoFrame);
    scrolls_->setFocusPolicy(Qt::NoFocus);  // its contents have the focus
    scrolls_->setWidgetResizable(true);
    scrolls_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolls_->setWidget(panel_);
    scrolls_->setMinimumWidth(panel_->minimumSizeHint().width() +
                              scrolls_->verticalScrollBar()->sizeHint().width());
    connect(&editing_, &LightsEditing::changed, &context_.viewport, &Viewport::updateToolMarks);
    connect(panel_, &LightsPanel::saveAsked, this, &LightsController::save);
    connect(panel_, &LightsPanel::openAsked, this, &LightsController::open);
    connect(panel_, &LightsPanel::meteringAsked, this, &LightsController::meter);
    connect(panel_, &LightsPanel::lookedAt, this,
            [this] { editing_.setCamera(toCamera(context_.viewport.camera())); });
    // An exposure metered for another picture is of no use.
    const auto stop = [this] {
        if (!metering_.running()) return;
        metering_.cancel();
        panel_->setMetering(false);
    };
    connect(&context_.session, &StudyEditor::studyShown, this, stop);
    connect(&context_.session, &StudyEditor::changed, this, stop);
}

void LightsController::save() {
    const auto rig = editing_.rig();
    auto* dialog = context_.files.toSave(FolderKind::presets, tr("Save the lights"), tr("Lights (*.json)"),
                                         QStringLiteral("json"),
                                         QString::fromStdString(rig->name) + QStringLiteral(".json"));
    context_.files.ask(dialog, FolderKind::presets, [this, json = toJson(*rig)](const QString& path) {
        if (const Result<void> written = writeTextAtomically(path.toStdString(), json); !written)
            return context_.notifications.fail(written.error());
        context_.notifications.showNote(
            tr("The lights are written to %1. Use them with --lights %1.").arg(path));
    });
}

void LightsController::open() {
    auto* dialog =
        context_.files.toOpen(FolderKind::presets, tr("Open lights"), tr("Lights (*.json);;All files (*)"));
    context_.files.ask(dialog, FolderKind::presets, [this](const QString& path) {
        Result<trace::LightRig> rig = scene::chooseLightRig(path.toStdString());
        if (!rig) return context_.notifications.fail(rig.error());
        editing_.use(std::make_shared<const trace::LightRig>(*std::move(rig)));
    });
}

void LightsController::meter() {
    if (!editing_.isUsable()) return;
    panel_->setMetering(true);
    metering_.start([picture = seenIn(context_), device = context_.device](Progress& progress) {
        return pictures::meteredExposureOf(picture, device, progress);
    });
}

void LightsController::useMetered(const Result<double>& exposure) {
    panel_->setMetering(false);
    if (!exposure) {
        if (exposure.error().code != ErrorCode::cancelled) panel_->tell(exposure.error());
        return;
    }
    context_.session.change(tr("Exposure"), [&](scene::StudyState& next) {
        scene::parameter("exposure").set(next.settings, *exposure);
    });
}

void LightsController::setDock(QDockWidget& dock) {
    connect(&dock, &QDockWidget::visibilityChanged, &editing_, &LightsEditing::setPanelOpen);
}

void LightsController::addList(QToolBar& bar) {
    list_ = new QComboBox(&bar);
    list_->setAccessibleName(tr("Lights"));
    list_->setPlaceholderText(tr("Own"));
    for (const auto& lights : context_.session.catalogue().lights) {
        list_->addItem(titleOr(lights->title, lights->name));
        list_->setItemData(list_->count() - 1, QString::fromStdString(lights->name), Qt::ToolTipRole);
    }
    bar.addWidget(new QLabel(tr("  Lights "), &bar));
    bar.addWidget(list_);
    connect(list_, &QComboBox::activated, this, [this](int index) {
        context_.session.change(tr("Lights"), [&](scene::StudyState& next) {
            next.lights = context_.session.catalogue().lights[std::size_t(index)];
        });
        context_.focusPicture();
    });
    followState(context_.session, list_, [this] { showChosen(); });
}

void LightsController::showChosen() {
    const scene::StudyState& state = context_.session.state();
    const trace::Look look = state.settings.look;
    const auto wanted =
        state.lights ? state.lights : scene::defaultLights(context_.session.catalogue(), look);
    const auto& items = context_.session.catalogue().lights;
    // A rig read from JSON equals the listed one, but is another object.
    const auto found = std::ranges::find_if(
        items, [&](const auto& item) { return item == wanted || (wanted && *item == *wanted); });
    list_->setCurrentIndex(found == items.end() ? -1 : int(found - items.begin()));
    list_->setEnabled(trace::isPathTraced(look));
    list_->setToolTip(trace::isPathTraced(look) ? tr("Where the light comes from")
                                                : tr("Only Cinematic and Clear have lights"));
}

}  // namespace macula::viewer
