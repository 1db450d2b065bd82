#include "viewer/planar/volume_actions.h"

#include <QAction>
#include <QCoreApplication>
#include <QWidget>
#include <array>
#include <utility>

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(VolumeActions)
};

// By their object names.
constexpr std::array kOfVolume{"save-measurement-report",
                               "save-presentation",
                               "open-presentation",
                               "save-segmentation",
                               "save-movie",
                               "save-model",
                               "save-view",
                               "open-view",
                               "send-to-archive",
                               "save-own-segments",
                               "segment-by-program"};

}  // namespace

void VolumeActions::setImagesShown(bool shown) {
    for (const Disabled& each : std::exchange(disabled_, {})) {
        if (!each.action) continue;
        each.action->setEnabled(each.wasEnabled);
        each.action->setToolTip(each.tip);
    }
    if (!shown) return;
    for (const char* name : kOfVolume) {
        auto* action = window_.findChild<QAction*>(QLatin1String(name));
        if (action == nullptr) continue;
        disabled_.push_back({action, action->isEnabled(), action->toolTip()});
        action->setEnabled(false);
        action->setToolTip(
            Words::tr("Not of images: it would act on the volume that they hide. Esc goes back to it."));
    }
}

}  // namespace macula::viewer
