// The work that FrameRenderer must do before its course goes on. Only the rules: no window, no device.
//
//   picture   right ──other background──▶ other background ──shown──▶ right
//             any   ──other picture─────▶ begins ──scene applied──▶ right
//             begins ──played──▶ played ──any input──▶ begins
//   run       on ──failure──▶ halted ──other picture──▶ on
//             on ──lost too often──▶ given up ──other scene──▶ on
//   screen    ours ──other study, failure──▶ foreign ──cleared, or a picture of ours shown──▶ ours
#pragma once

namespace macula::live {

class RenderDuty {
  public:
    enum class Work {
        nothing,
        clear,       // empty the screen: the input has no picture
        scene,       // bring the scene to the device
        background,  // draw the picture over the new background
        course,      // PictureCourse decides
    };

    // What has changed.
    void otherStudy();     // the screen may show another patient
    void otherPicture();   // begins again, even after halting or giving up
    void otherSizeOnly();  // begins again, but not after giving up
    void beginAnew();      // what is on the device is no longer valid
    void otherBackground();
    void otherInput();  // of any kind: what was played stays only until then

    // What was done.
    void appliedScene() { picture_ = Picture::right; }
    void showedBackground() { picture_ = Picture::right; }
    void played() { picture_ = Picture::played; }  // a phase as splats; its scene is not on the device
    void showedOurs() { isForeign_ = false; }      // a picture, or an empty window
    void owesClearing() { isForeign_ = true; }     // the window system had no image for the empty window
    void halt();                                   // until the picture changes
    void failed();                                 // halts; the content of the screen is not to be trusted
    void lostTooOften();                     // gives up until another scene; another size does not count
    void startedAgain() { run_ = Run::on; }  // on a new device, after a loss

    // Whether the screen shows another study, or the remains of a failure.
    bool isForeign() const { return isForeign_; }
    bool isHalted() const { return run_ != Run::on; }
    // `isComplete`: the input has all that a picture needs. `courseGoesOn` is only called then.
    template <class CourseGoesOn>
    Work work(bool isComplete, const CourseGoesOn& courseGoesOn) const {
        if (isHalted()) return Work::nothing;
        if (!isComplete) return picture_ == Picture::right ? Work::nothing : Work::clear;
        if (picture_ == Picture::begins) return Work::scene;
        if (picture_ == Picture::played) return Work::nothing;
        if (picture_ == Picture::otherBackground) return Work::background;
        return courseGoesOn() ? Work::course : Work::nothing;
    }

  private:
    enum class Picture { right, otherBackground, begins, played };
    enum class Run { on, halted, givenUp };

    Picture picture_ = Picture::right;
    Run run_ = Run::on;
    bool isForeign_ = false;
};

}  // namespace macula::live
