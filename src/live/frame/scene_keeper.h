// Where models of scenes are kept for longer than the program runs, as who shows scenes sees it.
#pragma once

#include <memory>
#include <string>

#include "base/volume.h"
#include "pipeline/hybrid/model/model_store.h"
#include "scene/drawing/drawing.h"

namespace macula::app {

// find() and keep() are asked by the live model, for a name that was looked for before.
class SceneKeeper : public hybrid::ModelStore {
  public:
    // The scene that is called `name` from now on, of a complete drawing: it is about to be shown. What was
    // looked for before is given up, and what was found of it forgotten. Returns at once.
    virtual void look(const std::string& name, std::shared_ptr<const Volume> volume,
                      const Drawing& drawing) = 0;
};

}  // namespace macula::app
