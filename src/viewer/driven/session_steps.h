// The steps of a day's work, through which the bench drives the window.
#pragma once

#include <vector>

#include "viewer/driven/driven_hand.h"
#include "viewer/driven/driven_steps.h"
#include "viewer/driven/gauges.h"

namespace macula::viewer {

struct WorkdaySteps {
    QSize volumePixels{1280, 720};  // of the 3D picture while it turns, beside three slices
    double orbitSeconds = 8.0;
    double turnSeconds = 8.0;  // once around the patient
};

// Begins with a study on screen, and ends with it as first opened. The arguments outlive the steps.
std::vector<DrivenStep> sessionSteps(MainWindow& window, DrivenHand& hand, OrbitGauge& orbit,
                                     const WorkdaySteps& work);

// Shows or hides the panel of that object name ("studies-panel") by its action.
void showPanel(DrivenHand& hand, const char* name, bool shown);

}  // namespace macula::viewer
