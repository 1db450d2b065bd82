// Which of a preset's two pairs of curves is edited: that of flat matter, or that of steep matter.
#pragma once

#include <QComboBox>
#include <QPushButton>
#include <QWidget>

namespace macula::viewer {

// A preset without curves of steep matter has one pair, and the choice waits. Tells what somebody wants, and
// shows what it is given.
class SteepChoice : public QWidget {
    Q_OBJECT

  public:
    explicit SteepChoice(QWidget* parent = nullptr);

    // Without curves of steep matter the others are chosen again, and nobody is told.
    void showCurves(bool hasSteep);
    bool isSteep() const { return which_->currentIndex() == 1; }
    void chooseSteep() { which_->setCurrentIndex(1); }

  signals:
    void chosen();                   // the other pair
    void steepWanted(bool isThere);  // curves of steep matter: to be there, or to go

  private:
    QComboBox* which_;
    QPushButton* steep_;
    bool hasSteep_ = false;
};

}  // namespace macula::viewer
