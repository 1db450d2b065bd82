// Chooses which of a preset's two pairs of curves is edited: for flat or for steep matter.
#pragma once

#include <QComboBox>
#include <QPushButton>
#include <QWidget>

namespace macula::viewer {

// Without curves for steep matter the choice is disabled. Emits edits, and shows only what it is given.
class SteepChoice : public QWidget {
    Q_OBJECT

  public:
    explicit SteepChoice(QWidget* parent = nullptr);

    // Without curves for steep matter it chooses the flat ones, and does not emit `chosen`.
    void showCurves(bool hasSteep);
    bool isSteep() const { return which_->currentIndex() == 1; }
    void chooseSteep() { which_->setCurrentIndex(1); }

  Q_SIGNALS:
    void chosen();                   // a person chose the other pair
    void steepWanted(bool isThere);  // add or remove curves for steep matter

  private:
    QComboBox* which_;
    QPushButton* steep_;
    bool hasSteep_ = false;
};

}  // namespace macula::viewer
