// What FrameRenderer owes before its course can go on: the rules alone, without window or device.
//
//   picture   right ──other background──▶ other background ──shown──▶ right
//             any   ──other picture─────▶ begins ──scene applied──▶ right
//   run       on ──failure──▶ halted ──other picture──▶ on
//             on ──lost too often──▶ given up ──other scene──▶ on
//   screen    ours ──other study, failure──▶ foreign ──cleared, or a picture of ours shown──▶ ours
#pragma once

namespace macula::app {

class RenderDuty {
  public:
    enum class Work {
        nothing,
        clear,       // nothing is to be shown, and something is on screen
        scene,       // the device has not all that the picture is of
        background,  // the picture is right, but over another background
        course,      // PictureCourse says
    };

    // What has changed.
    void otherStudy();     // what is on screen may be of another patient
    void otherPicture();   // begins anew; whoever halted tries again
    void otherSizeOnly();  // likewise, but who has given up does not try again: nobody asked for it
    void beginAnew();      // what was made is not right any more, on the device or beside it
    void otherBackground();

    // What was done.
    void appliedScene() { picture_ = Picture::right; }
    void showedBackground() { picture_ = Picture::right; }
    void showedOurs() { isForeign_ = false; }   // a picture, or an empty window
    void owesClearing() { isForeign_ = true; }  // the window system gave out no image for the empty window
    void halt();                                // until something changes
    void failed();                              // halts, and what is on screen is not to be trusted
    void lostTooOften();                        // until another scene is wanted: another size changes nothing
    void startedAgain() { run_ = Run::on; }     // on a new device, after a loss

    // Whether what is on screen belongs to another study, or to what failed.
    bool isForeign() const { return isForeign_; }
    bool isHalted() const { return run_ != Run::on; }
    // `isComplete`: the input says all that a picture needs. `courseGoesOn`: asked only then.
    template <class CourseGoesOn>
    Work work(bool isComplete, const CourseGoesOn& courseGoesOn) const {
        if (isHalted()) return Work::nothing;
        if (!isComplete) return picture_ == Picture::right ? Work::nothing : Work::clear;
        if (picture_ == Picture::begins) return Work::scene;
        if (picture_ == Picture::otherBackground) return Work::background;
        return courseGoesOn() ? Work::course : Work::nothing;
    }

  private:
    enum class Picture { right, otherBackground, begins };
    enum class Run { on, halted, givenUp };

    Picture picture_ = Picture::right;
    Run run_ = Run::on;
    bool isForeign_ = false;
};

}  // namespace macula::app
