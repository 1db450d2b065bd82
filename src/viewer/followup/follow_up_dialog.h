// The table of a follow-up.
#pragma once

#include <QDialog>
#include <QStringList>
#include <cstddef>
#include <string>
#include <vector>

#include "scene/followup/follow_up.h"
#include "viewer/context/window_context.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace macula::viewer {

struct FollowedStudy {
    scene::FollowedExam exam;
    std::string study;              // session::studyIdentity; may be empty
    std::vector<std::string> gone;  // lesions that a person called gone, by scene::keyOfLesion
};

// What is known of the studies of a patient besides what is measured on the open volume.
struct FollowedStudies {
    std::vector<FollowedStudy> others;  // other studies, from what is kept of them
    FollowedStudy open;                 // other volumes of the open study
    QStringList notes;                  // sentences: what could not be read
};

// A column for each study, a row for each lesion, then sums, changes and categories. Follows what is measured
// on the open study, and closes when another is opened. Deletes itself when it is closed.
class FollowUpDialog : public QDialog {
    Q_OBJECT

  public:
    FollowUpDialog(FollowedStudies studies, const WindowContext& context);

  Q_SIGNALS:
    // A person has called other lesions of a study gone than before.
    void goneChanged(const std::string& study, const std::vector<std::string>& lesions);

  private:
    void gather();
    void fill();
    void fillBaselines();
    void fillRow(int row, const scene::FollowedLesion& lesion);
    void fillSums(int row);
    void setCell(int row, int column, const QString& text, bool isStrong = false);
    void showNotes();
    void showWhetherGone();
    void setGone(bool isGone);
    void save();

    FollowedStudies studies_;
    WindowContext context_;
    std::vector<scene::FollowedExam> exams_;  // of the table, by date
    std::vector<std::string> keys_;           // of the studies of these
    scene::GoneLesions gone_;
    scene::FollowUp table_;
    std::size_t baseline_ = 0;
    bool isBaselineChosen_ = false;
    QComboBox* baselines_;
    QTableWidget* grid_;
    QLabel* notes_;
    QPushButton* isGone_;
};

}  // namespace macula::viewer
