#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/lights/lights_controller.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QToolBar>
#include <algorithm>
#include <utility>

#include "viewer/editor/follow_state.h"
#include "viewer/lights/lights_desk.h"
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
      desk_(new LightsDesk(context.session,
                           {.seen = [this] { return seenIn(context_); },
                            .ask =
                                [this](QFileDialog* dialog, std::function<void(const QString&)> then) {
                                    context_.files.ask(dialog, FolderKind::presets, std::move(then));
                                },
                            .folder = [this] { return context_.files.folderOf(FolderKind::presets); },
                            .device = context.device},
                           &context.window)) {
    connect(desk_, &LightsDesk::marksChanged, &context_.viewport, &Viewport::updateToolMarks);
    connect(desk_, &LightsDesk::told, &context_.notifications, &Notifications::showNote);
    connect(desk_, &LightsDesk::failed, this,
            [this](const Error& error) { context_.notifications.fail(error); });
}

void LightsController::setDock(QDockWidget& dock) {
    connect(&dock, &QDockWidget::visibilityChanged, desk_, &LightsDesk::setPanelOpen);
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
