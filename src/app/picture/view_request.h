// From what a window shows to what is drawn and told of it; what view_picture.h and view_sequence.h share.
#pragma once

#include <string>
#include <vector>

#include "app/picture/drawn_picture.h"
#include "app/picture/picture_request.h"
#include "app/picture/render_record.h"
#include "app/picture/view_picture.h"

namespace macula::app {

// usage for a size that no picture can have; fails as chooseQuality.
Result<PictureRequest> requestOf(const ViewPicture& picture, bool isLinear);

// For the metadata of its file; no patient data.
RenderRecord recordOf(const ViewPicture& picture, const PictureRequest& request, const DrawnPicture& drawn);

// What a person should know of it.
std::vector<std::string> sentencesOf(const DrawnPicture& drawn, const PictureRequest& request);

}  // namespace macula::app
