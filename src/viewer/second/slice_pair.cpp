#include "viewer/second/slice_pair.h"

namespace macula::viewer {

SlicePair::SlicePair(StudyEditor& session, slices::Orientation orientation, QWidget* parent)
    : QSplitter(Qt::Horizontal, parent),
      study_(new SliceView(session, orientation)),
      second_(new SliceView(session, orientation, nullptr, PaneRole::second)) {
    constexpr int kGapPx = 2;
    setHandleWidth(kGapPx);
    setChildrenCollapsible(false);
    setFocusProxy(study_);
    for (SliceView* pane : {study_, second_}) {
        addWidget(pane);
        setStretchFactor(indexOf(pane), 1);
    }
    second_->hide();
    connect(study_, &SliceView::viewChanged, second_, &SliceView::setPaneView);
    connect(second_, &SliceView::viewChanged, study_, &SliceView::setPaneView);
}

void SlicePair::setBoth(bool both) {
    if (both == showsBoth_) return;
    showsBoth_ = both;
    if (!both && second_->hasFocus()) study_->setFocus(Qt::OtherFocusReason);
    second_->setVisible(both);
    if (both) setSizes({width() / 2, width() - width() / 2});
}

void SlicePair::showNames(bool shown) {
    study_->showNames(shown);
    second_->showNames(shown);
}

void SlicePair::setSecond(const std::shared_ptr<const SecondVolumeTexts>& second) {
    study_->setSecond(second);
    second_->setSecond(second);
}

}  // namespace macula::viewer
