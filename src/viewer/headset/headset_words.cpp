#include "viewer/headset/headset_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <string>

#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(HeadsetWords)
};

// Texts of buttons have at most 15 letters, that of "hold" including its argument; "quality" has 32.
void fillPanel(xr::RoomWords& words) {
    words.shift = Words::tr("Shift").toStdString();
    words.knifeOn = Words::tr("Knife: on").toStdString();
    words.knifeOff = Words::tr("Knife: off").toStdString();
    words.hold = Words::tr("Hold: %1").toStdString();
    words.nothing = Words::tr("nothing").toStdString();
    words.resetClips = Words::tr("Reset clips").toStdString();
    words.undo = Words::tr("Undo").toStdString();
    words.takePicture = Words::tr("Take picture").toStdString();
    words.otherWrist = Words::tr("Other wrist").toStdString();
    words.realSize = Words::tr("Real size 1:1").toStdString();
    words.larger = Words::tr("%1 times real size").toStdString();
    words.smaller = Words::tr("1/%1 of real size").toStdString();
    words.notCalibrated = Words::tr("Size is not calibrated").toStdString();
    words.recentre = Words::tr("Before me").toStdString();
    words.quality = Words::tr("Quality: %1").toStdString();
    words.fast = Words::tr("fast").toStdString();
    words.balanced = Words::tr("balanced").toStdString();
    words.fine = Words::tr("fine").toStdString();
    words.notForDiagnosis = Words::tr("Not for primary diagnosis").toStdString();
}

// The panel shows at most 52 letters of a sentence.
void fillSentences(xr::RoomWords& words) {
    words.isRealSize = Words::tr("Real size 1:1: a millimetre is a millimetre.").toStdString();
    words.isBeforeYou = Words::tr("Before you, at real size 1:1.").toStdString();
    words.nothingLeft = Words::tr("Nothing would be left to see: that was not done.").toStdString();
    words.noMoreCuts = Words::tr("No more than six cuts: undo one, or reset the clips.").toStdString();
    words.lostPlace = Words::tr("The headset has lost its place. Look around.").toStdString();
    words.pictureWritten = Words::tr("Picture %1 is written.").toStdString();
}

}  // namespace

xr::RoomWords headsetWords(const std::vector<std::shared_ptr<const TransferFunction>>& presets) {
    xr::RoomWords words;
    fillPanel(words);
    fillSentences(words);
    words.edited = titleInWindowsLanguage("edited").toStdString();
    for (const auto& preset : presets)
        words.titles[preset->title] = titleInWindowsLanguage(preset->title).toStdString();
    words.say = [](const Text& text) { return inWindowsLanguage(text).toStdString(); };
    const QString sign = QLocale().decimalPoint();
    if (sign.size() == 1 && sign[0].unicode() < 0x80) words.decimalSign = char(sign[0].unicode());
    return words;
}

}  // namespace macula::viewer
