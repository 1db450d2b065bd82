#include "viewer/volume/viewer_widget.h"

#include <QVBoxLayout>
#include <utility>
#include <variant>

#include "scene/drawing/projection_windows.h"
#include "viewer/clip/voxel_cutting.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/status/status_texts.h"
#include "viewer/volume/hidden_voxels.h"
#include "viewer/volume/table_removal.h"

namespace macula::viewer {

ViewerWidget::ViewerWidget(StudyEditor& session, gpu::Instance instance, ViewerWidgetOptions options,
                           QWidget* parent)
    : QWidget(parent),
      session_(session),
      firstView_(options.firstView),
      shown_(new ShownVolume(session, this)),
      viewport_(new Viewport(std::move(instance), std::move(options.device), std::move(options.keeper))) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(viewport_);
    viewport_->showNames(options.showsNames);

    connect(&session_, &StudyEditor::studyShown, this, &ViewerWidget::onStudyShown);
    connect(shown_, &ShownVolume::changed, this, [this] {
        viewport_->showMarks(session_.state().showsMarks);
        viewport_->setDrawing(shown_->drawing());
    });
    connect(viewport_, &Viewport::marksAsked, this, [this](bool isShown) {
        session_.change(tr("Cube and scale"),
                        [isShown](scene::StudyState& next) { next.showsMarks = isShown; });
    });
    connect(viewport_, &Viewport::namesToggled, viewport_, &Viewport::showNames);
    connect(viewport_, &Viewport::windowDragged, this, [this](QPointF byHeights) {
        const auto from = shown_->drawing().settings.window;
        if (!from || !session_.hasStudy()) return;
        session_.drag(tr("Window"), [&](scene::StudyState& next) {
            next.windows.at(std::size_t(next.settings.look)) =
                scene::dragged(*from, {byHeights.x(), byHeights.y()}, *session_.study().volume);
        });
    });
    connect(&viewport_->window(), &VulkanWindow::dragEnded, &session_, &StudyEditor::endDrag);
    connect(viewport_, &Viewport::rendered, this, [this](const live::RenderEvent& event) {
        if (const auto* frame = std::get_if<live::FrameShown>(&event)) Q_EMIT frameShown(*frame);
        if (const auto* failure = std::get_if<live::RenderFailure>(&event)) Q_EMIT failed(failure->error);
    });
    connect(&shown_->table(), &TableRemoval::failed, this, &ViewerWidget::failed);
    connect(&shown_->cutting(), &VoxelCutting::failed, this, &ViewerWidget::failed);
    connect(&shown_->segments(), &SegmentationKeeper::failed, this, &ViewerWidget::failed);
    connect(&shown_->hidden(), &HiddenVoxels::failed, this, &ViewerWidget::failed);
    onStudyShown();
}

ViewerWidget::~ViewerWidget() = default;

void ViewerWidget::onStudyShown() {
    const study::OpenedStudy& study = session_.study();
    viewport_->showMarks(session_.state().showsMarks);
    viewport_->setStudy(study.volume, study.volume ? linesToShow(study.identity) : std::vector<std::string>(),
                        shown_->drawing(), firstView_);
    if (const auto& camera = session_.state().camera) viewport_->showFrom(*camera);
}

scene::StudyState ViewerWidget::state() const {
    scene::StudyState state = shown_->state();
    if (session_.hasStudy()) state.camera = toCamera(viewport_->camera());
    return state;
}

Result<void> ViewerWidget::setState(const scene::StudyState& state) {
    MACULA_TRY_VOID(shown_->take(state));
    if (state.camera) viewport_->showFrom(*state.camera);
    return {};
}

}  // namespace macula::viewer
