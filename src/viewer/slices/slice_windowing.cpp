#include "viewer/slices/slice_windowing.h"

#include <cstddef>

#include "scene/drawing/projection_windows.h"
#include "scene/slices/window_presets.h"

namespace macula::viewer {

SliceWindowing::SliceWindowing(StudyEditor& session, const PaneContent& content)
    : session_(session), content_(content) {}

void SliceWindowing::applyPreset(int digit) {
    if (!content_.hasStudy()) return;
    if (const auto preset = scene::windowPreset(content_.wantedVolume(), digit))
        propose(preset->window, false);
}

void SliceWindowing::applyOwn(int number) {
    if (!content_.hasStudy() || own_ == nullptr || number < 1) return;
    const auto own = own_->fitting(content_.wantedVolume());
    if (std::size_t(number) <= own.size()) propose(own[std::size_t(number) - 1].window, false);
}

void SliceWindowing::drag(glm::dvec2 byHeights) {
    propose(scene::dragged(content_.wantedWindow(), byHeights, content_.wantedVolume()), true);
}

void SliceWindowing::propose(const std::optional<DisplayWindow>& window, bool isDrag) {
    const bool ofSecond = content_.wantsSecond();
    const auto edit = [&](scene::StudyState& next) {
        const bool isOwn = ofSecond && !next.secondVolume->linksWindow;
        (isOwn ? next.secondVolume->window : next.slices.window) = window;
    };
    const QString what = ofSecond ? tr("Window of the second volume") : tr("Window");
    if (isDrag) {
        session_.drag(what, edit);
    } else {
        session_.change(what, edit);
    }
}

}  // namespace macula::viewer
