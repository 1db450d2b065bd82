// Checks for a display before Qt looks for one.
#pragma once

namespace macula::viewer {

// Without a display Qt aborts; the caller can print a message instead. Needs no QApplication.
//
// Keep it until the QApplication exists: a virtual display (Xvfb without -noreset) resets when its last
// client leaves, and is unavailable for the moment in which Qt would connect.
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
