// Whether there is a display, before Qt looks for one.
#pragma once

namespace macula::viewer {

// Qt ends the process with an abort where no display answers; a sentence is kinder. Needs no QApplication.
//
// To be kept until the QApplication is there: a virtual display starts anew when its last client leaves (Xvfb
// without -noreset), and is away for a moment just when Qt would connect.
class DisplayCheck {
  public:
    DisplayCheck();
    ~DisplayCheck();
    DisplayCheck(const DisplayCheck&) = delete;
    DisplayCheck& operator=(const DisplayCheck&) = delete;

    bool found() const { return found_; }

  private:
    void connectToX();

    bool found_ = true;
    void* library_ = nullptr;     // libxcb
    void* connection_ = nullptr;  // xcb_connection_t
};

}  // namespace macula::viewer
