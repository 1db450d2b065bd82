// Where a person changes what is seen of a study, and in which colour.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"
#include "scene/transfer/histogram.h"
#include "scene/transfer/value_axis.h"
#include "viewer/jobs/background_job.h"
#include "viewer/session/viewer_session.h"
#include "viewer/transfer/matter_fields.h"
#include "viewer/transfer/point_fields.h"
#include "viewer/transfer/steep_choice.h"
#include "viewer/transfer/transfer_curve.h"

namespace macula::viewer {

// Edits the preset of the session's state. A preset that was chosen is never changed: the first edit makes a
// copy (app::ownCopy), and what is a copy is edited further. A drag is one step of the session's history.
// Lives on the UI thread; values are counted in the background, and so is what a preset is fitted to.
class TransferFunctionEditor : public QWidget {
    Q_OBJECT

  public:
    // The session outlives this.
    explicit TransferFunctionEditor(ViewerSession& session, QWidget* parent = nullptr);
    ~TransferFunctionEditor() override;

    TransferCurve& curve() { return *curve_; }
    bool isCounting() const { return job_.running(); }
    // What is edited: the preset of the state, or the copy that its first change makes; and how its values
    // lie on the volume. Nothing without a study, and as long as that is being counted.
    struct Edited {
        TransferFunction function;
        app::ValueMap map;
    };
    std::optional<Edited> edited() const;
    QString line() const { return line_->text(); }  // which preset it is, or why there is none

  signals:
    void saveAsked();  // of the preset in the session's state

  private:
    using Preset = std::shared_ptr<const TransferFunction>;
    // What an edited copy goes back to.
    struct Chosen {
        Preset inState;   // null: nobody chose, and the volume decides
        Preset function;  // never null
    };
    struct Seen {
        std::optional<app::Histogram> histogram;
        std::optional<ValueRange> foreground;  // the volume's part of a fit to it; nothing: nobody asked
    };
    using SeenResult = std::shared_ptr<const Seen>;

    void onStudyShown();
    void onChanged(const app::StudyState& before);
    void onSeen(const Result<SeenResult>& outcome);
    void showNothing();
    void showState();
    void look(bool isForegroundWanted);
    Preset presetShown();
    Chosen chosenFor(const Preset& preset) const;
    Preset inCatalogue(const std::string& name) const;
    std::set<std::string> takenNames(const Preset& original) const;
    // How the preset lies on the volume; nothing as long as that is not known.
    std::optional<app::ValueMap> mapFor(const TransferFunction& function) const;

    void makeButtons();
    void listen();
    void propose(const TransferFunction& function, bool isDrag);
    void changeSelected(std::optional<double> value, std::optional<double> opacity,
                        const std::optional<glm::dvec3>& colour);
    // Swaps the curves of steep matter to the front while these are edited, so that all editing is of one
    // pair; called again, it swaps them back.
    TransferFunction edits(const TransferFunction& function) const;
    void changeSide();
    void changeSteep(bool isThere);
    void changeMatter(const app::MatterParameter& parameter, double value);
    void reset();
    void showFields();
    void showLine();

    ViewerSession& session_;
    BackgroundJob<SeenResult> job_;
    QLabel* line_ = nullptr;
    TransferCurve* curve_ = nullptr;
    PointFields* fields_ = nullptr;
    MatterFields* matter_ = nullptr;
    SteepChoice* steep_ = nullptr;
    QPushButton* showsMatter_ = nullptr;
    QPushButton* reset_ = nullptr;
    QPushButton* save_ = nullptr;

    Preset byDefault_;              // what the volume is shown with when nobody chose; null: not asked yet
    std::optional<Chosen> chosen_;  // nothing: no study
    TransferFunction own_;          // what is edited: the copy, though nobody may have changed it yet
    bool isCopy_ = false;           // it is in the state
    std::map<std::string, Chosen> chosenByCopy_;  // by the name of the copy, of this study
    SeenResult seen_;
    QString trouble_;  // why values could not be counted
    bool isProposing_ = false;
};

}  // namespace macula::viewer
