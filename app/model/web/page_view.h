#pragma once

#include "app/model/session/picture.h"

namespace app {

class JsonWriter;

/// Writes what page/scene.js draws of a scene that does not change from frame to frame: the shapes of its points, its
/// links, walls and ground. Ends of rooms that are infinitely far away become null.
void writeView(JsonWriter &json, const lessons::View &view, const sim::Scene &scene);

}
