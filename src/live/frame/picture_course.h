// What a window shows next, and what is done for that meanwhile: the rules alone, without window, device or
// clock.
//
// While a hand moves: the peripheral model, at once and with all pixels, and over it the fovea, which is
// traced between two frames; where there is no model, small traced pictures. When it stops: the traced
// picture of this view if there is one; else the model stays, with a fovea that grows, until the first is
// ready, and fades into it. Then the picture converges and the model learns in turns, until both are done. A
// model is searched for when there is none, in turns with small pictures: few of them while nothing moves.
// One that is too young to be shown learns likewise while a hand moves, and beside tracing at rest. An
// estimate of what is wanted, where there is one, stands for the model until that is fit.
//
// On a graphics card a frame leaves time until the next input: the model learns in that. And where a picture
// of all pixels is soon there, it waits for nothing.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

namespace macula::app {

// How much of the wanted picture is on screen.
enum class OnScreen {
    nothing,   // only what was wanted before, if anything
    preview,   // a small traced picture
    estimate,  // the model of before, changed to what is wanted now (estimated_model.h)
    model,
    fading,  // from the model or the estimate to the traced picture
    traced,  // all pixels
};

// The name as in reports; a literal.
std::string_view nameOf(OnScreen picture);
// Of a model, learnt or estimated, alone.
constexpr bool isOfSplats(OnScreen picture) {
    return picture == OnScreen::model || picture == OnScreen::estimate;
}

// What there is of a peripheral model for it.
enum class ModelState {
    none,
    searching,
    young,  // not fit to be shown (hybrid::isFitToBeShown)
    ready,
};

enum class Step {
    none,         // all is done
    showModel,    // and the fovea over it, as far as there is one
    traceFovea,   // while a hand moves, a slice of it
    showPreview,  // another view, or more samples of this one
    search,       // a slice of the search for the model's first points
    trace,        // a slice of tracing: all pixels
    showTraced,   // the picture traced so far
    fade,         // a step of the fade
    learn,        // a slice of training the model
};

// The name as in reports; a literal.
std::string_view nameOf(Step step);

class PictureCourse {
  public:
    using TimePoint = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::milliseconds kFade{200};
    // Without a model, the small picture is refined for so long before the full one starts: it stays on
    // screen during the long first pass of that, and should not be the noisiest of all.
    static constexpr std::chrono::milliseconds kSettle{300};
    // Samples of a small picture beside which a model is searched for while nothing moves: with fewer it is
    // all noise for as long as the search takes, and with more the search takes longer.
    static constexpr std::uint64_t kRefinedWhileSearching = 8;
    // As soon as a young model is fit it is the first picture with all pixels, and what a hand will want
    // next: where tracing one takes long, so much of search and learning comes before that.
    static constexpr double kYoungFirstMs = 15000.0;
    // After that, of the time of tracing, what it may have beside it.
    static constexpr double kYoungShare = 2.0;
    // The same while a picture of all pixels is soon there, at any time: that gets better fast enough.
    static constexpr double kYoungShareWhereQuick = 3.0;
    // Of one that is fit, over a traced picture.
    static constexpr double kReadyShare = 1.0;

    // Another picture from now on, of the same scene or of another one. `isTraced`: of exactly this there is
    // a traced one with all pixels, which has converged or can go on.
    void want(bool isTraced);
    void setHand(bool moves) { handMoves_ = moves; }
    void setModel(ModelState state, bool learns);
    // Whether an estimate can be drawn where the model is not fit.
    void setEstimate(bool isThere) { hasEstimate_ = isThere; }
    // Whether there is a fovea to trace, other than the one there is: over the model, before all pixels are.
    void setFovea(bool isWanted) { wantsFovea_ = isWanted; }
    // Whether the model is to learn over a frame in motion, until the next one is due.
    void setLearnsBesideHand(bool learns) { learnsBesideHand_ = learns; }
    // Whether a picture of all pixels is expected within kSettle or so: small ones are of no use at rest
    // then.
    void setQuick(bool isQuick) { isQuick_ = isQuick; }
    // How many samples small pictures are worth while a hand holds still.
    void setPreviewLimit(std::uint64_t samples) { previewLimit_ = samples; }
    // More samples are asked for than the traced picture converged with.
    void goOnTracing() { hasConverged_ = false; }

    Step next(TimePoint now) const;

    // What was done since.
    void showedModel();
    void showedEstimate();
    void showedPreview(std::uint64_t samples, TimePoint now);  // the traced picture with all pixels is lost
    void searched() { hasSearched_ = true; }
    // The traced picture has become worth showing, and was shown unless it fades in.
    void traced(bool hasConverged);
    void showedTraced();
    void faded(TimePoint now);  // a step; the first begins it
    // For the turns that tracing and learning take.
    void spent(Step step, double ms);

    OnScreen onScreen() const { return onScreen_; }
    bool hasConverged() const { return onScreen_ == OnScreen::traced && hasConverged_; }
    // While it fades: how much of the traced picture is seen, 0 to 1. 0 before its first step.
    double tracedShare(TimePoint now) const;

  private:
    Step nextOverEstimate() const;
    bool isLearningsTurn() const;
    bool isSearchsTurn() const;
    bool isBeforeTraced() const;

    bool handMoves_ = false;
    ModelState model_ = ModelState::none;
    bool learns_ = false;
    bool hasEstimate_ = false;
    bool wantsFovea_ = false;
    bool learnsBesideHand_ = false;
    bool isQuick_ = false;
    OnScreen onScreen_ = OnScreen::nothing;
    bool isTraced_ = false;      // worth showing
    bool hasConverged_ = false;  // the traced picture
    std::uint64_t previewLimit_ = 1;
    std::uint64_t previewSamples_ = 0;
    TimePoint previewSince_{};
    bool hasSearched_ = false;  // or learnt, since the last small picture
    std::optional<TimePoint> fadingSince_;
    double tracedMs_ = 0.0;
    double learntMs_ = 0.0;  // and searched
};

}  // namespace macula::app
