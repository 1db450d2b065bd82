// From what a window shows to what is drawn and told of it; what view_picture.h and view_sequence.h share.
#pragma once

#include <string>
#include <vector>

#include "pictures/drawn_picture.h"
#include "pictures/picture_request.h"
#include "pictures/render_record.h"
#include "pictures/view_picture.h"

namespace macula::app {

// usage for a size that no picture can have; fails as chooseQuality.
Result<PictureRequest> requestOf(const ViewPicture& picture, bool isLinear);

// For the metadata of its file; no patient data.
RenderRecord recordOf(const ViewPicture& picture, const PictureRequest& request, const DrawnPicture& drawn);

// What a person should know of it.
std::vector<std::string> sentencesOf(const DrawnPicture& drawn, const PictureRequest& request);

}  // namespace macula::app
