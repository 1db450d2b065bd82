// The controls of phases, below the panes: which one the slices show, playing, and the curve over time.
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>

class QDoubleSpinBox;
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

  Q_SIGNALS:
    void phaseChosen(int phase);
    void playToggled(bool plays);
    void openAsked();
    void curveAsked();

  private:
    QToolButton* addButton(const char* name, const QString& text, const QString& tip);

    QToolButton* play_;
    QSlider* phases_;
    ElidingLabel* shown_;
    QDoubleSpinBox* rate_;
    QLabel* note_;
    QToolButton* open_;
    QToolButton* curve_;
};

}  // namespace macula::viewer
