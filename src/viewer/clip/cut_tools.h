// Controls for cuts along the line of sight: a plane before the eye, and the scissors.
#pragma once

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "viewer/clip/clip_editing.h"
#include "viewer/editor/study_editor.h"

namespace macula::viewer {

// Shows the cuts of the session's state, and proposes changes to them. Session and editing outlive it.
class CutTools : public QWidget {
    Q_OBJECT

  public:
    CutTools(StudyEditor& session, ClipEditing& editing, QWidget* parent = nullptr);

    void setScissorsOut(bool out);

  Q_SIGNALS:
    void scissorsAsked(bool out);

  private:
    QWidget* makeEye();
    QWidget* makeScissors();
    void setUsable(QWidget& control, const QString& does);
    void showCuts();
    void tell(const Result<void>& done);

    StudyEditor& session_;
    ClipEditing& editing_;
    QCheckBox* onSlices_;
    QCheckBox* eye_;
    QDoubleSpinBox* depth_;
    QCheckBox* follows_;
    QPushButton* scissors_;
    QPushButton* uncut_;
    QLabel* count_;
    QLabel* trouble_;
};

}  // namespace macula::viewer
