#include "scenes/scene_watch.h"

#include <cassert>

namespace bullet_buoyancy::scenes {

namespace {

thread_local const SceneWatch* watching = nullptr;

}  // namespace

SceneWatch::SceneWatch(Look look) : m_look(std::move(look)) {
    assert(!watching);
    watching = this;
}

SceneWatch::~SceneWatch() {
    watching = nullptr;
}

void SceneWatch::show(const FloatScene& scene) {
    if (watching) watching->m_look(scene);
}

}  // namespace bullet_buoyancy::scenes
