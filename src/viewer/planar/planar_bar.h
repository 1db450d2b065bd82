// The controls below an image: its place in the series, playing, and how it is shown.
#pragma once

#include <QStringList>
#include <QWidget>
#include <map>
#include <optional>

#include "study/planar/image_measurement.h"

class QAction;
class QComboBox;
class QMenu;
class QSlider;
class QToolButton;

namespace macula::viewer {

// Lives on the UI thread. Setters emit nothing.
class PlanarBar : public QWidget {
    Q_OBJECT

  public:
    explicit PlanarBar(QWidget* parent = nullptr);

    void setPlaces(int count, int place);  // of the slider, from 0
    void setPlaying(bool plays);
    void setCanPlay(bool can);
    // Windows and tables; empty: none to choose.
    void setDisplays(const QStringList& names, int chosen);  // -1: none of them
    void setInverted(bool isInverted);
    void setCanGoBack(bool can);  // to the volume
    // Presentation states; empty: none to choose, and no list.
    void setPresentations(const QStringList& names, int chosen);
    void setTool(std::optional<study::ImageMeasurement::Kind> tool);
    void setOverlays(bool hasOnes, bool shown);
    void setHasMeasurements(bool has);
    void setBoxesMenu(QMenu* menu);  // null: none
    double speed() const;            // 1: as recorded

  Q_SIGNALS:
    void placeChosen(int place);
    void playToggled(bool plays);
    void displayChosen(int index);
    void invertToggled(bool isInverted);
    void turnAsked();
    void mirrorAsked();
    void fitAsked();
    void backAsked();
    void presentationChosen(int index);
    void toolChosen(std::optional<macula::study::ImageMeasurement::Kind> tool);
    void overlaysToggled(bool shown);
    void copyAsked();
    void saveAsked();
    void removeAllAsked();

  private:
    void makeMenu();
    QToolButton* addButton(const char* name, const QString& text, const QString& tip);

    QToolButton* play_;
    QSlider* places_;
    QComboBox* speed_;
    QComboBox* displays_;
    QComboBox* presentations_;
    QToolButton* measure_;
    std::map<std::optional<study::ImageMeasurement::Kind>, QAction*> tools_;
    QAction* overlays_ = nullptr;
    QAction* copy_ = nullptr;
    QAction* save_ = nullptr;
    QAction* removeAll_ = nullptr;
    QToolButton* boxes_;
    QToolButton* invert_;
    QToolButton* back_;
};

}  // namespace macula::viewer
