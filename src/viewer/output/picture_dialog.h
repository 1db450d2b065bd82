// Asks for the size and the quality of a picture to save.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSize>
#include <QSpinBox>
#include <string>

#include "pictures/picture_effects.h"

namespace macula::viewer {

// Offers usual sizes or any other, and a quality. Its values hold once it is accepted.
class PictureDialog : public QDialog {
    Q_OBJECT

  public:
    // `onScreenPx` is the first choice.
    explicit PictureDialog(QSize onScreenPx, QWidget* parent = nullptr);

    // Replaces the defaults; an unknown quality changes nothing.
    void beginWith(const QString& quality, bool isDeidentified);

    // Enables only the effects of the look: a lens for path-traced looks, fog for all but projections.
    void offerEffectsOf(trace::Look look);

    // Shows a note that the 3D view is drawn although it is hidden.
    void tellThat3dIsHidden();

    QSize sizePx() const;
    std::string quality() const;               // by name: pictures::EffortRequest
    pictures::PictureEffects effects() const;  // the lens focuses on the middle of the picture
    bool isDeidentified() const { return deidentified_->isChecked(); }
    bool hasOverlays() const { return overlays_->isChecked(); }  // cube, scale, letters

  private:
    void addSize(const QString& title, QSize pixels);
    void addRows(QWidget* buttons);

    QLabel* hidden_;
    QComboBox* sizes_;
    QSpinBox* width_;
    QSpinBox* height_;
    QComboBox* qualities_;
    QDoubleSpinBox* lens_;
    QDoubleSpinBox* fog_;
    QCheckBox* overlays_;
    QCheckBox* deidentified_;
};

}  // namespace macula::viewer
