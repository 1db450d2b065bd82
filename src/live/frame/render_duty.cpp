#include "live/frame/render_duty.h"

namespace macula::live {

void RenderDuty::otherStudy() {
    isForeign_ = true;
    picture_ = Picture::begins;
}

void RenderDuty::otherPicture() {
    picture_ = Picture::begins;
    run_ = Run::on;
}

void RenderDuty::otherSizeOnly() {
    picture_ = Picture::begins;
    if (run_ != Run::givenUp) run_ = Run::on;
}

void RenderDuty::beginAnew() {
    picture_ = Picture::begins;
}

void RenderDuty::otherBackground() {
    if (picture_ == Picture::right) picture_ = Picture::otherBackground;
}

void RenderDuty::otherInput() {
    if (picture_ == Picture::played) picture_ = Picture::begins;
}

void RenderDuty::halt() {
    if (run_ == Run::on) run_ = Run::halted;
}

void RenderDuty::failed() {
    halt();
    isForeign_ = true;
}

void RenderDuty::lostTooOften() {
    run_ = Run::givenUp;
    isForeign_ = true;
}

}  // namespace macula::live
