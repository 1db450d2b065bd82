#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/planar/planar_controller.h"

#include <QBoxLayout>
#include <QMainWindow>
#include <algorithm>

#include "viewer/editor/study_editor.h"
#include "viewer/planar/images_window.h"
#include "viewer/planar/planar_measuring.h"
#include "viewer/planar/planar_saving.h"

namespace macula::viewer {

PlanarController::PlanarController(const WindowContext& context, QWidget& beneath)
    : QObject(&context.window),
      context_(context),
      beneath_(beneath),
      widget_(new QWidget),
      boxes_(new ImageBoxes(context)),
      saving_(new PlanarSaving(context)),
      volumeActions_(context.window) {
    auto* column = new QVBoxLayout(widget_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* content = new QWidget;
    content->setObjectName(QStringLiteral("images-content"));
    auto* inner = new QVBoxLayout(content);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(0);
    inner->addWidget(boxes_, 1);
    inner->addWidget(&boxes_->bars());
    column->addWidget(content);
    widget_->hide();
    connect(boxes_, &ImageBoxes::shownChanged, this, [this] {
        if (isShown()) Q_EMIT shownChanged();
    });
    connect(boxes_, &ImageBoxes::imageShown, this, &PlanarController::imageShown);
    connect(boxes_, &ImageBoxes::closeAsked, this, &PlanarController::close);
    connect(boxes_, &ImageBoxes::saveAsked, this, &PlanarController::saveMeasurements);
}

PlanarController::~PlanarController() = default;

void PlanarController::show(const std::shared_ptr<const study::FoundVolumes>& found,
                            const dicom::Stack* stack) {
    const study::PlanarSeries series = study::seriesOf(*found, stack);
    if (series.stack == nullptr) return;
    const auto isOfPatient = [&](const ImageBox* box) {
        return box->found() == found && box->series().study->patient == series.study->patient;
    };
    const std::vector<ImageBox*> boxes = boxes_->boxes();
    if (!isShown() || std::ranges::none_of(
                          boxes, [&](const ImageBox* box) { return box->isShown() && isOfPatient(box); })) {
        if (isShown()) Q_EMIT aboutToClose();
        boxes_->begin({.rows = 1, .columns = 1, .boxes = {{found, stack, {}}}, .isLinked = false});
        present();
        return Q_EMIT begun();
    }
    const auto has = [&](const ImageBox* box) { return box->isShown() && box->series().stack == stack; };
    const auto shown = std::ranges::find_if(boxes, has);
    if (shown != boxes.end())
        boxes_->choose(**shown);
    else
        boxes_->showInChosen(found, series);
    present();
}

void PlanarController::showBoxes(const BoxArrangement& arrangement) {
    boxes_->begin(arrangement);
    present();
}

void PlanarController::present() {
    placeWidgets();
    view().setFocus();
}

// Where images are, and what they hide.
void PlanarController::placeWidgets() {
    widget_->setVisible(isShown() && !isDetached());
    beneath_.setVisible(!hidesPanes());
    volumeActions_.setImagesShown(hidesPanes());
    if (window_) window_->setVisible(isShown());
    Q_EMIT shownChanged();
}

void PlanarController::close() {
    if (!isShown() || !(context_.session.hasStudy() || isDetached())) return;
    Q_EMIT aboutToClose();
    boxes_->clear();
    placeWidgets();
    context_.focusPicture();
}

void PlanarController::giveWay() {
    if (hidesPanes()) close();
}

void PlanarController::onStudyShown() {
    const ImageBox* shown = boxes_->firstShown();
    if (shown != nullptr && (hidesPanes() || shown->found() != context_.session.study().found)) close();
}

bool PlanarController::hidesPanes() const {
    return isShown() && !isDetached();
}

bool PlanarController::isInFront() const {
    return isShown() && (!isDetached() || window_->isActiveWindow());
}

void PlanarController::setDetached(bool detached) {
    if (detached == isDetached()) return;
    auto* content = widget_->findChild<QWidget*>(QStringLiteral("images-content"));
    if (detached && content != nullptr) {
        window_ = std::make_unique<ImagesWindow>(*content, context_.window);
        window_->setWindowTitle(tr("Images"));
        connect(window_.get(), &ImagesWindow::activeChanged, this, &PlanarController::shownChanged);
        connect(
            window_.get(), &ImagesWindow::closeAsked, this, [this] { setDetached(false); },
            Qt::QueuedConnection);
    } else if (window_) {
        QWidget* within = window_->findChild<QWidget*>(QStringLiteral("images-content"));
        window_->giveBack();
        widget_->layout()->addWidget(within);
        within->show();
        window_.reset();
    }
    placeWidgets();
    if (isShown()) view().setFocus();
}

std::optional<study::Identity> PlanarController::identity() const {
    if (!hidesPanes()) return {};
    return study::identityOf((box().isShown() ? box() : *boxes_->firstShown()).series());
}

std::optional<study::Identity> PlanarController::identityOfNewest() const {
    if (!hidesPanes()) return {};
    const ImageBox* newest = boxes_->firstShown();
    for (const ImageBox* each : boxes_->boxes())
        if (each->isShown() && each->series().study->date > newest->series().study->date) newest = each;
    return study::identityOf(newest->series());
}

bool PlanarController::savePicture() {
    if (!isInFront()) return false;
    saving_->savePicture(view().pictureWithoutNames());
    return true;
}

bool PlanarController::saveMeasurements() {
    if (!isInFront()) return false;
    if (box().isShown()) saving_->saveMeasurements(box().found(), stack(), measuring().all());
    return true;
}

bool PlanarController::removeMeasurements() {
    if (!isInFront()) return false;
    measuring().removeAll();
    return true;
}

}  // namespace macula::viewer
