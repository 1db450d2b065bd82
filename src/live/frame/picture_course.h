// Decides what the window shows next, and what work is done meanwhile. Holds only the rules: no window, no
// device, no clock.
//
// While a hand moves, the screen shows the peripheral model at once with all pixels, and over it the fovea,
// which is traced between two frames. Without a model it shows small traced pictures. When the hand stops, it
// shows the traced picture of this view, if one exists. Otherwise the model stays, with a growing fovea,
// until the first traced picture is ready, and fades into it. Then tracing and training take turns until both
// are done; models of other phases that are wanted too take turns with both. A missing model is searched for,
// in turns with small pictures (few of them at rest). A model too young to be shown also trains while a hand
// moves, and beside tracing at rest. An estimate replaces the model until that is fit.
//
// On a graphics card the model trains in the time that a frame leaves before the next input. If a full-size
// picture is expected soon, its tracing does not wait for small pictures.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

namespace macula::live {

// How much of the wanted picture is on screen.
enum class OnScreen {
    nothing,   // at most a picture of an earlier input
    preview,   // a small traced picture
    estimate,  // splats changed for an edit (estimated_model.h)
    model,
    fading,  // from the model or the estimate to the traced picture
    traced,  // all pixels
};

// The name as in reports; a literal.
std::string_view nameOf(OnScreen picture);
// Whether the picture shows splats alone: a learnt model or an estimate.
constexpr bool isOfSplats(OnScreen picture) {
    return picture == OnScreen::model || picture == OnScreen::estimate;
}

// The state of the peripheral model of the wanted scene.
enum class ModelState {
    none,
    searching,
    young,  // not fit to be shown (hybrid::isFitToBeShown)
    ready,
};

enum class Step {
    none,         // no work is left
    showModel,    // with the fovea over it, if there is one
    traceFovea,   // a time slice of tracing the fovea
    showPreview,  // a new small picture, or more samples of this one
    search,       // a time slice of the search for the model's first points
    trace,        // a time slice of tracing all pixels
    showTraced,   // the picture traced so far
    fade,         // a step of the fade
    learn,        // a time slice of training the model
    learnPhases,  // the same of the models of other phases
};

// The name as in reports; a literal.
std::string_view nameOf(Step step);

class PictureCourse {
  public:
    using TimePoint = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::milliseconds kFade{200};
    // How long the small picture is refined before the full one starts, without a model. It stays on screen
    // during the long first pass of the full one, so it should not be at its noisiest.
    static constexpr std::chrono::milliseconds kSettle{300};
    // Samples per pixel of the small picture while a model is searched for at rest: with fewer it stays all
    // noise during the search, with more the search takes longer.
    static constexpr std::uint64_t kRefinedWhileSearching = 8;
    // Time for search and training before tracing at full size: a fit model is the first picture with all
    // pixels where tracing is slow, and the user's next motion needs it.
    static constexpr double kYoungFirstMs = 15000.0;
    // After that, the share of tracing time that search and training of a young model may take.
    static constexpr double kYoungShare = 2.0;
    // The share for a young model where a full-size picture is quick (setQuick): tracing is fast enough.
    static constexpr double kYoungShareWhereQuick = 3.0;
    // The share for training a model that is fit.
    static constexpr double kReadyShare = 1.0;
    // The share for the models of other phases, of the time for this one: a person waits for them to play.
    static constexpr double kPhasesShare = 3.0;

    // Another picture is wanted, of the same scene or another one. `isTraced`: a full-size traced picture of
    // exactly this exists, and either has converged or can be traced further.
    void want(bool isTraced);
    void setHand(bool moves) { handMoves_ = moves; }
    void setModel(ModelState state, bool learns);
    // Whether models of other phases are to be learnt while the traced picture is on screen.
    void setPhases(bool learn) { learnsPhases_ = learn; }
    // Whether an estimate can be drawn, for a model that is not fit.
    void setEstimate(bool isThere) { hasEstimate_ = isThere; }
    // Whether another fovea than the present one is to be traced; it precedes the full-size picture.
    void setFovea(bool isWanted) { wantsFovea_ = isWanted; }
    // Whether the model trains after a frame in motion, until the next input is due.
    void setLearnsBesideHand(bool learns) { learnsBesideHand_ = learns; }
    // Whether a full-size picture is expected so soon that small ones are of no use at rest.
    void setQuick(bool isQuick) { isQuick_ = isQuick; }
    // Most samples per pixel of a small picture.
    void setPreviewLimit(std::uint64_t samples) { previewLimit_ = samples; }
    // The sample limit rose or the noise target fell, so a converged picture is traced further.
    void goOnTracing() { hasConverged_ = false; }

    Step next(TimePoint now) const;

    // Reports what was done.
    void showedModel();
    void showedEstimate();
    void showedPreview(std::uint64_t samples, TimePoint now);  // the full-size picture is lost
    void searched() { hasSearched_ = true; }
    // The traced picture is now worth showing. It is on screen, unless it fades in over splats.
    void traced(bool hasConverged);
    void showedTraced();
    void faded(TimePoint now);  // a step of the fade; the first begins it
    // Time spent on a step; it decides the turns of tracing and training.
    void spent(Step step, double ms);

    OnScreen onScreen() const { return onScreen_; }
    bool hasConverged() const { return onScreen_ == OnScreen::traced && hasConverged_; }
    // The share of the traced picture in the fade, 0 to 1. 0 before the first step.
    double tracedShare(TimePoint now) const;

  private:
    Step nextOverEstimate() const;
    bool isLearningsTurn() const;
    bool isSearchsTurn() const;
    bool isBeforeTraced() const;
    bool isPhasesTurn() const;

    bool handMoves_ = false;
    ModelState model_ = ModelState::none;
    bool learns_ = false;
    bool learnsPhases_ = false;
    bool hasEstimate_ = false;
    bool wantsFovea_ = false;
    bool learnsBesideHand_ = false;
    bool isQuick_ = false;
    OnScreen onScreen_ = OnScreen::nothing;
    bool isTraced_ = false;      // the traced picture is worth showing
    bool hasConverged_ = false;  // the traced picture
    std::uint64_t previewLimit_ = 1;
    std::uint64_t previewSamples_ = 0;
    TimePoint previewSince_{};
    bool hasSearched_ = false;  // or trained, since the last small picture
    std::optional<TimePoint> fadingSince_;
    double tracedMs_ = 0.0;
    double learntMs_ = 0.0;  // training and search
    double phasesMs_ = 0.0;  // the same of other phases
};

}  // namespace macula::live
