// The panel of the curved plane: its picture, and how it is drawn.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "viewer/curve/curve_picture.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/background_job.h"
#include "viewer/slices/kept_curve.h"

class QComboBox;
class QDoubleSpinBox;
class QPushButton;

namespace macula::viewer {

class CurveView;

// Draws the state's curve while the panel is visible, and moves the state's cross-hair along it. The section
// is at the place of the curve that is nearest to the cross-hair. Lives on the UI thread.
class CurvePanel : public QWidget {
    Q_OBJECT

  public:
    explicit CurvePanel(StudyEditor& session, QWidget* parent = nullptr);  // `session` outlives it

    CurveView& view() const { return *view_; }
    bool isUpToDate() const { return !job_.running() && !isStale_; }
    void setFollowing(bool follows);  // the way of the vessel is being looked for
    // Another phase of the study that slices show, and a text that says which; null: the open study.
    void setPhase(std::shared_ptr<const study::OpenedStudy> phase, const QString& text);
    const study::OpenedStudy& study() const { return phase_ ? *phase_ : session_.study(); }

  Q_SIGNALS:
    void followAsked();  // a person wants the curve to follow the vessel
    void pictureShown();

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void addControls();
    QDoubleSpinBox* addNumber(const char* name, const QString& title, double low, double high, double value);
    void refresh();
    void start();
    std::optional<CurveRequest> request() const;
    void goTo(double atMm);
    void standPlanesAcross();
    void onStudyShown();
    const slices::Curve& curve() const;  // of the state's points
    glm::dvec3 crosshairMm() const;

    StudyEditor& session_;
    CurveView* view_;
    QComboBox* kind_ = nullptr;
    QDoubleSpinBox* turn_ = nullptr;
    QDoubleSpinBox* height_ = nullptr;
    QPushButton* follow_ = nullptr;
    QPushButton* across_ = nullptr;
    QPushButton* remove_ = nullptr;
    CurveLook look_;
    std::shared_ptr<const study::OpenedStudy> phase_;
    QString phaseText_;
    bool isFollowing_ = false;
    mutable KeptCurve curve_;
    bool isStale_ = false;  // another picture is wanted than the one that is being made
    QTimer scrollEnds_;     // steps along the curve until then are one undo step
    BackgroundJob<CurvePicture> job_;
};

}  // namespace macula::viewer
