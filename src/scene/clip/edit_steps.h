// The steps that edits of a clip share (edited_clip.h): where a point lies in the volume, what is refused,
// and the last step of all.
#pragma once

#include "scene/clip/kept_box.h"

namespace macula::scene {

Error refused(Text message, Text hint);
Error notANumber();
Error nothingLeft();
Error notThere();  // the part that a handle moved

bool isWithin(const Box& box, const glm::dvec3& point);
glm::dvec3 fractionOf(const Volume& volume, const glm::dvec3& pointMm);
Box fractionsOf(const Box& boxMm, const Volume& volume);

// The box in fractions of the volume; its open faces lie beyond the volume.
OrientedBox boxOf(const Box& fractions);
void removeFaces(ClipPreset& clip);

// The last step of every edit: the clip as a person's own, or why it cannot be.
Result<OptionalClip> own(ClipPreset next, const Volume& volume);
// The same with these faces in place of the faces of keptBox.
Result<OptionalClip> withKept(ClipPreset next, const Box& keptMm, const Volume& volume);

}  // namespace macula::scene
