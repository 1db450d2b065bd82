// A panel for the doses of a study: which lies over it, and its isodoses.
#pragma once

#include <QWidget>
#include <cstddef>
#include <optional>
#include <vector>

#include "scene/second/dose_lines.h"
#include "study/dose/found_dose.h"
#include "viewer/dose/isodose_edits.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace macula::viewer {

class IsodoseTable;

// Shows what its controller gives it, proposes edits of the isodoses to the session, and asks for the rest.
class DosePanel : public QWidget {
    Q_OBJECT

  public:
    explicit DosePanel(StudyEditor& session, QWidget* parent = nullptr);  // the session outlives it

    struct Shown {
        const scene::Isodoses* isodoses = nullptr;  // null: no dose lies over the study
        std::optional<study::DoseReference> reference = {};
        QString unit = {};
    };
    void setDoses(const std::vector<study::FoundDose>& doses);  // of the study; the first is chosen
    void setShown(const Shown& shown);
    std::size_t chosen() const;  // an index into the doses; 0 without any

  Q_SIGNALS:
    void showAsked(std::size_t dose);
    void histogramAsked(std::size_t dose);

  private:
    void tell();
    void askForColour(std::size_t row);
    void makeIsodoses();

    StudyEditor& session_;
    IsodoseEdits edits_;
    std::vector<study::FoundDose> doses_;
    std::optional<study::DoseReference> reference_;
    bool isShowing_ = false;  // controls follow the state and propose nothing
    QComboBox* choice_;
    QLabel* facts_;
    QPushButton* show_;
    QPushButton* histogram_;
    QWidget* lines_;
    QCheckBox* areShown_ = nullptr;
    QComboBox* unit_ = nullptr;
    QLabel* whole_ = nullptr;
    QDoubleSpinBox* hundred_ = nullptr;
    IsodoseTable* table_ = nullptr;
    QPushButton* remove_ = nullptr;
    QPushButton* add_ = nullptr;
};

}  // namespace macula::viewer
