// How large and how good a picture is to be.
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

// A choice of usual sizes, or any; and one of the qualities. What it says holds once it is accepted.
class PictureDialog : public QDialog {
    Q_OBJECT

  public:
    // `onScreenPx` is the first choice.
    explicit PictureDialog(QSize onScreenPx, QWidget* parent = nullptr);

    // Instead of what it begins with by itself; a quality that there is not changes nothing.
    void beginWith(const QString& quality, bool isDeidentified);

    // Only what the look has may be chosen: a lens of path-traced ones, fog of all but projections.
    void offerEffectsOf(trace::Look look);

    // Says that the view in 3D is drawn all the same.
    void tellThat3dIsHidden();

    QSize sizePx() const;
    std::string quality() const;          // by name: app::EffortWish
    app::PictureEffects effects() const;  // sharp is what the middle of the picture shows
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
