// Lights: the desk that has them all, at home in this window.
#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include "viewer/lights/lights_desk.h"

namespace macula::viewer {

void MainWindow::makeLights() {
    lightsDesk_ =
        new LightsDesk(session_,
                       {.seen =
                            [this] {
                                const QSize size = viewport_->pictureSize();
                                pictures::ViewPicture picture;
                                picture.volume = study().volume;
                                picture.drawing = shown_->drawing();
                                picture.camera = toCamera(viewport_->camera());
                                picture.sizePx = {std::max(1, size.width()), std::max(1, size.height())};
                                return picture;
                            },
                        .ask =
                            [this](QFileDialog* dialog, std::function<void(const QString&)> then) {
                                ask(dialog, FolderKind::presets, std::move(then));
                            },
                        .folder = [this] { return folders_.of(FolderKind::presets); },
                        .device = options_.device},
                       this);
    connect(lightsDesk_, &LightsDesk::marksChanged, viewport_, &Viewport::updateToolMarks);
    connect(lightsDesk_, &LightsDesk::told, messages_, &MessageBar::showNote);
    connect(lightsDesk_, &LightsDesk::failed, this, [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    });
}

}  // namespace macula::viewer
