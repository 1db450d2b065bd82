#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/viewport/phase_in_3d.h"

#include <QCoreApplication>

namespace macula::viewer {

namespace {

struct PhaseIn3dWords {
    Q_DECLARE_TR_FUNCTIONS(PhaseIn3d)
};

}  // namespace

QString whyNotOfOpenPhase(const Viewport& viewport) {
    return viewport.showsOtherPhase()
               ? PhaseIn3dWords::tr(
                     "3D shows another phase than the one that is open. Open that phase first, "
                     "or show the open one.")
               : QString();
}

}  // namespace macula::viewer
