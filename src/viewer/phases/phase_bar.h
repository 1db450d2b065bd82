// The controls of phases, below the panes: which one is shown, playing, 3D, differences, and the curve over
// time.
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QSlider;
class QToolButton;

namespace macula::viewer {

class ElidingLabel;

// Lives on the UI thread. Setters emit nothing.
class PhaseBar : public QWidget {
    Q_OBJECT

  public:
    explicit PhaseBar(QWidget* parent = nullptr);

    void setPhases(int count);
    void setShown(int phase, const QString& text);
    void setPlaying(bool plays);
    void setNote(const QString& note);  // such as how many are decoded; empty: none
    void setCanOpen(bool can);
    double perSecond() const;  // phases a second
    void setIn3d(bool on);
    void setNoteOn3d(const QString& note);             // empty: none
    void setReference(int phase);                      // the difference to it is shown; -1: values are
    void setReach(double reach, const QString& unit);  // half the width of the window of a difference

  Q_SIGNALS:
    void phaseChosen(int phase);
    void playToggled(bool plays);
    void openAsked();
    void curveAsked();
    void in3dToggled(bool on);
    void learningToggled(bool learns);
    void referenceChosen(int phase);  // -1: none
    void reachChosen(double reach);

  private:
    QToolButton* addButton(QHBoxLayout& row, const char* name, const QString& text, const QString& tip);
    QHBoxLayout* makeFirstRow();
    QHBoxLayout* makeSecondRow();

    QToolButton* play_;
    QSlider* phases_;
    ElidingLabel* shown_;
    QDoubleSpinBox* rate_;
    QLabel* note_;
    QToolButton* open_;
    QToolButton* curve_;
    QCheckBox* in3d_;
    QCheckBox* learns_;
    QLabel* noteOn3d_;
    QComboBox* reference_;
    QDoubleSpinBox* reach_;
};

}  // namespace macula::viewer
