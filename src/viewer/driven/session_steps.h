// A day's work in the window: what the bench drives it through.
#pragma once

#include <vector>

#include "viewer/driven/driven_hand.h"
#include "viewer/driven/driven_steps.h"
#include "viewer/driven/orbit_gauge.h"

namespace macula::viewer {

struct SessionWork {
    QSize volumePixels{1280, 720};  // of the 3D picture while it is turned, three slices beside
    double orbitSeconds = 8.0;
    double turnSeconds = 8.0;  // once around the patient
};

// Begins with a study on screen, and ends with it shown as when first opened. All of these outlive the steps.
std::vector<DrivenStep> sessionSteps(MainWindow& window, DrivenHand& hand, OrbitGauge& orbit,
                                     const SessionWork& work);

// The panel of that name ("studies-panel") is shown or hidden, by its action.
void showPanel(DrivenHand& hand, const char* name, bool shown);

}  // namespace macula::viewer
