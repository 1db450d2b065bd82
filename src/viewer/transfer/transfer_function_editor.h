// The panel that edits the transfer function: opacity and colour by value.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <optional>

#include "pipeline/volume/transfer_function.h"
#include "scene/transfer/value_axis.h"
#include "viewer/editor/study_editor.h"
#include "viewer/transfer/counted_values.h"
#include "viewer/transfer/matter_fields.h"
#include "viewer/transfer/point_fields.h"
#include "viewer/transfer/preset_copies.h"
#include "viewer/transfer/transfer_curve.h"

namespace macula::viewer {

// Edits the preset of the session's state. A chosen preset never changes: the first edit makes a copy
// (scene::ownCopy), which later edits change. A drag is one undo step. Lives on the UI thread; the histogram,
// and the foreground that some presets are fitted to, are computed in the background.
class TransferFunctionEditor : public QWidget {
    Q_OBJECT

  public:
    // The session outlives this.
    explicit TransferFunctionEditor(StudyEditor& session, QWidget* parent = nullptr);
    ~TransferFunctionEditor() override;

    TransferCurve& curve() { return *curve_; }
    bool isCounting() const { return values_.isCounting(); }
    // The copy that is edited, or would be after the first edit, and the map of its values to the volume's.
    // Nothing without a study, or before the map is known.
    struct Edited {
        TransferFunction function;
        scene::ValueMap map;
    };
    std::optional<Edited> edited() const;
    QString line() const { return line_->text(); }  // names the preset, or says why there is none

  Q_SIGNALS:
    void saveAsked();  // save the preset of the session's state

  private:
    void onStudyShown();
    void onChanged(const scene::StudyState& before);
    void onCounted();
    void showNothing();
    void showState();

    void makeButtons();
    void listen();
    void propose(const TransferFunction& function, bool isDrag);
    void changeSelected(std::optional<double> value, std::optional<double> opacity,
                        const std::optional<glm::dvec3>& colour);
    // Swaps the curves for steep matter to the front while these are edited, so that all code edits one pair;
    // a second call swaps them back.
    TransferFunction edits(const TransferFunction& function) const;
    void changeSide();
    void changeSteep(bool isThere);
    void changeMatter(const scene::MatterParameter& parameter, double value);
    void reset();
    void showFields();
    void showLine();

    StudyEditor& session_;
    CountedValues values_;
    PresetCopies copies_;
    QLabel* line_ = nullptr;
    TransferCurve* curve_ = nullptr;
    PointFields* fields_ = nullptr;
    MatterFields* matter_ = nullptr;
    SteepChoice* steep_ = nullptr;
    QPushButton* showsMatter_ = nullptr;
    QPushButton* reset_ = nullptr;
    QPushButton* save_ = nullptr;

    std::optional<PresetCopies::Chosen> chosen_;  // nothing: no study
    TransferFunction own_;                        // the edited copy, perhaps not changed yet
    bool isCopy_ = false;                         // own_ is in the state
    QString trouble_;                             // why values could not be counted
    bool isProposing_ = false;
};

}  // namespace macula::viewer
