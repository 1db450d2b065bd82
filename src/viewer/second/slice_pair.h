// Slices of the study beside slices of the second volume in the same planes.
#pragma once

#include <QSplitter>
#include <memory>

#include "viewer/slices/slice_view.h"

namespace macula::viewer {

// The study is always on the left. Both panes share zoom and position. Lives on the UI thread.
class SlicePair : public QSplitter {
    Q_OBJECT

  public:
    // The session must outlive it.
    SlicePair(StudyEditor& session, slices::Orientation orientation, QWidget* parent = nullptr);

    SliceView& study() { return *study_; }
    SliceView& second() { return *second_; }
    bool showsBoth() const { return showsBoth_; }
    void setBoth(bool both);
    void showNames(bool shown);
    void setSecond(const std::shared_ptr<const SecondVolumeTexts>& second);  // null: no second volume

  private:
    SliceView* study_;
    SliceView* second_;
    bool showsBoth_ = false;
};

}  // namespace macula::viewer
